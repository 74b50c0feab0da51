#!/usr/bin/env bash
# Installs what is missing of ci/packages.txt. Needs root (or sudo) only where something is missing.
set -euo pipefail
cd "$(dirname "$0")/.."

missing=()
while read -r package; do
    if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
        missing+=("$package")
    fi
done < <(sed 's/#.*//' ci/packages.txt | awk 'NF { print $1 }')

if [ "${#missing[@]}" -eq 0 ]; then
    exit 0
fi
echo "installing: ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
    as_root=(sudo)
fi
"${as_root[@]}" apt-get update -qq
DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}"
