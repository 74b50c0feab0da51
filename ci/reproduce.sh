#!/usr/bin/env bash
# Runs reproducers of findings by other tools: a C compiler and the Vulkan loader, and piglit's shader_runner (Debian's
# package piglit, which takes 2 GB and is asked for nowhere else; SHADER_RUNNER names another). Arguments are files;
# default: all of golden/reproducers. Exit status: 0 every file shows what it says, 1 one does not, 2 one could not run.
set -euo pipefail
cd "$(dirname "$0")/.."

files=("$@")
if [ "$#" -eq 0 ]; then
    shopt -s nullglob
    files=(golden/reproducers/*.c golden/reproducers/*.shader_test)
fi
runner=${SHADER_RUNNER:-$(command -v shader_runner || ls /usr/lib/*/piglit/bin/shader_runner 2>/dev/null || true)}
swiftshader=$(ls /usr/lib/chromium/vk_swiftshader_icd.json 2>/dev/null || true)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export XDG_RUNTIME_DIR=$scratch PIGLIT_PLATFORM=surfaceless_egl LIBGL_ALWAYS_SOFTWARE=1

# Prints what the tool says; the status is 1 where the file shows the result, 0 where it is allowed.
run_vulkan() {
    cc -o "$scratch/program" "$1" -lvulkan || return 2
    case $1 in
        *swiftshader*) VK_ICD_FILENAMES=$swiftshader "$scratch/program" ;;
        *) "$scratch/program" ;;
    esac
}
run_piglit() {
    if [ -z "$runner" ]; then
        echo "there is no shader_runner; Debian's package piglit has it"
        return 2
    fi
    local driver=()
    case $1 in
        *zink*) driver=(MESA_LOADER_DRIVER_OVERRIDE=zink) ;;
        *softpipe*) driver=(GALLIUM_DRIVER=softpipe) ;;
        *llvmpipe*) driver=(GALLIUM_DRIVER=llvmpipe) ;;
    esac
    local said
    said=$(env "${driver[@]}" "$runner" "$1" -auto -fbo 2>&1) || true
    echo "$said"
    # A skip is no success.
    case $said in
        *'"result": "pass"'*) return 0 ;;
        *'"result": "fail"'*) [[ $said == *'test failed: Reference'* ]] && return 1 ;;
    esac
    return 2
}

worst=0
for file in "${files[@]}"; do
    status=0
    case $file in
        *.c) said=$(run_vulkan "$file" 2>&1) || status=$? ;;
        *) said=$(run_piglit "$file" 2>&1) || status=$? ;;
    esac
    case $status in
        1) echo "$file: shows it" ;;
        0) echo "$file: does not show it"; worst=$((worst > 1 ? worst : 1)) ;;
        *) echo "$file: could not run"; worst=2 ;;
    esac
    if [ "$status" -ne 1 ]; then
        echo "$said"
    fi
done
exit "$worst"
