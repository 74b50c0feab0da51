#!/usr/bin/env bash
# Builds one preset (default: release), configuring it first where that was not done yet.
set -euo pipefail
cd "$(dirname "$0")/.."

preset=${1:-release}
folder=build
if [ "$preset" != release ]; then
    folder=build-$preset
fi
if [ ! -f "$folder/build.ninja" ]; then
    cmake --preset "$preset"
fi
cmake --build --preset "$preset"
