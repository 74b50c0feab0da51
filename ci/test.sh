#!/usr/bin/env bash
# Installs what is missing, builds, and passes all tests: the conformance run over all cases and devices, the harness's
# own tests, and the latter once more under the address and undefined-behaviour sanitizers.
set -euo pipefail
cd "$(dirname "$0")/.."

ci/setup.sh
ci/build.sh release
ci/build.sh sanitize
ctest --preset sanitize
ctest --preset release
