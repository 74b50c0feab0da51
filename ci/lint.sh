#!/usr/bin/env bash
# Holds the sources against .clang-format and .clang-tidy. Needs the sanitize preset configured (clang's own compile
# commands). Arguments are files to check; default: all.
set -euo pipefail
cd "$(dirname "$0")/.."

if [ "$#" -gt 0 ]; then
    files=("$@")
else
    mapfile -t files < <(git ls-files 'harness/*.cc' 'harness/*.h' 'tests/*.cc' 'tests/*.h')
fi
clang-format-14 --dry-run --Werror "${files[@]}"

sources=()
for file in "${files[@]}"; do
    case $file in
        harness/*.cc) sources+=("$file") ;;
    esac
done
if [ "${#sources[@]}" -gt 0 ]; then
    printf '%s\0' "${sources[@]}" |
        xargs -0 -n 4 -P "$(nproc)" clang-tidy-14 -p build-sanitize --quiet 2>/dev/null
fi
echo "${#files[@]} files are formatted, ${#sources[@]} tidy"
