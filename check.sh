#!/usr/bin/env bash
# Everything that must hold before a change goes in: the build without a warning, all tests, the unit
# and property tests again under the address and undefined behaviour sanitizers, and a short run of
# the fuzz tests. Arguments go to cmake (-DLIMITGAUGE_PRECOMPILED=ON: quicker from nothing).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

./setup.sh
jobs=$(nproc)

common=(-DLIMITGAUGE_WERROR=ON -DLIMITGAUGE_TESTS=ON "$@")

cmake --preset release "${common[@]}" >/dev/null
cmake --build --preset release
ctest --test-dir build/release --output-on-failure -j "$jobs"

cmake --preset sanitize "${common[@]}" >/dev/null
cmake --build --preset sanitize
# Sanitized code is some ten times slower: the tests that run whole jobs have had their turn above.
ctest --test-dir build/sanitize -L 'unit|property' -LE slow --output-on-failure -j "$jobs"

FUZZ_JOBS=$jobs tests/fuzz/run.sh 10
