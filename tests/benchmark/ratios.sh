#!/usr/bin/env bash
# Builds the benchmarks and prints lines NAME VALUE: each the median over five repetitions of a ratio
# of times, or of bytes allocated, measured in one run. Before each, on standard error, stands what it
# counts and what it leaves out (tests/benchmark/ratios.py). Cases called huge (voxels of 0.02 mm, five
# million moves) are left out; --benchmark_filter=huge asks for them.
#
#   tests/benchmark/ratios.sh           some minutes
#   tests/benchmark/ratios.sh --list    the names, and what is in and out; nothing is built or run
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

case "${1:-}" in
  --list) exec python3 tests/benchmark/ratios.py --list ;;
  "") ;;
  *) echo "usage: tests/benchmark/ratios.sh [--list]" >&2; exit 3 ;;
esac

cmake --preset release -DLIMITGAUGE_BENCHMARKS=ON >/dev/null
cmake --build --preset release --target limitgauge_benchmarks >/dev/null
results=$(mktemp)
trap 'rm -f "$results"' EXIT
build/release/tests/benchmark/limitgauge_benchmarks --benchmark_repetitions=5 \
  --benchmark_filter=-huge --benchmark_min_time=0.2 \
  --benchmark_enable_random_interleaving=true --benchmark_out="$results" \
  --benchmark_out_format=json >/dev/null 2>&1
python3 tests/benchmark/ratios.py "$results"
