#!/usr/bin/env bash
# Installs what is missing, builds, and passes all tests: the sources' form, the harness's own tests with and without
# the address and undefined-behaviour sanitizers, and the conformance run over all cases and devices.
set -euo pipefail
cd "$(dirname "$0")/.."

ci/setup.sh
ci/build.sh release
ci/build.sh sanitize
ci/lint.sh
ctest --preset sanitize
ctest --preset release
