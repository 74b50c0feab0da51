#!/usr/bin/env bash
# Installs what is missing, builds, and runs every case on every device found. Arguments go to `etalon run`.
set -euo pipefail
cd "$(dirname "$0")/.."

ci/setup.sh
ci/build.sh release
exec build/etalon run "$@"
