#!/usr/bin/env bash
# Everything that must hold before a change goes in: the build without a warning, benchmarks included,
# all tests, the unit tests again under the address and undefined behaviour sanitizers, and a short run of
# the fuzz tests and of the torture test. With --full random tests take all their cases, collections are
# gone through whole, not by a share of them (tests/support/effort.h), and property tests run under the
# sanitizers too. Further arguments go to cmake.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

sanitized=unit
if [ "${1:-}" = --full ]; then
  export LIMITGAUGE_THOROUGH=1
  sanitized='unit|property'
  shift
fi
jobs=$(nproc)

common=(-DLIMITGAUGE_WERROR=ON -DLIMITGAUGE_TESTS=ON -DLIMITGAUGE_BENCHMARKS=ON -DLIMITGAUGE_UNITY=ON "$@")

# The program is compiled while what only the tests need is fetched and unpacked.
./setup.sh build
./setup.sh test & fetching=$!
cmake --preset release "${common[@]}" -DLIMITGAUGE_TESTS=OFF -DLIMITGAUGE_BENCHMARKS=OFF >/dev/null
cmake --build --preset release
wait "$fetching"

cmake --preset release "${common[@]}" >/dev/null
cmake --build --preset release
# One more than there are cores: browsers, clusters and what waits for time limits leave theirs idle.
ctest --test-dir build/release --output-on-failure -j "$((jobs + 1))"

cmake --preset sanitize "${common[@]}" >/dev/null
# Sanitized code is some ten times slower: the tests of whole jobs and those that hold the parts against
# each other have had their turn above, and nothing in them is left to build.
parts=(model engine simulator verifier study history reports app)
cmake --build --preset sanitize --target "${parts[@]/#/test_}"
# Less freed memory held back, and fewer frames kept of each allocation, take a tenth of the time off.
export ASAN_OPTIONS=quarantine_size_mb=64:malloc_context_size=6
ctest --test-dir build/sanitize -L "$sanitized" -LE slow -R "^($(IFS='|'; echo "${parts[*]}")):" \
  --output-on-failure -j "$jobs"

FUZZ_JOBS=$jobs tests/fuzz/run.sh 6

# Other moments every time: the seed is printed. How soon a command ends is no question for a machine that
# others are busy on.
tests/torture.sh 0.5 --patience 30
