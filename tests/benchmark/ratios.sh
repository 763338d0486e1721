#!/usr/bin/env bash
# Builds the benchmarks and prints lines NAME VALUE: each the median over five repetitions of a ratio
# of times measured in one run.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

cmake --preset release -DLIMITGAUGE_BENCHMARKS=ON >/dev/null
cmake --build --preset release --target limitgauge_benchmarks >/dev/null
results=$(mktemp)
trap 'rm -f "$results"' EXIT
build/release/tests/benchmark/limitgauge_benchmarks --benchmark_repetitions=5 \
  --benchmark_enable_random_interleaving=true --benchmark_out="$results" \
  --benchmark_out_format=json >/dev/null 2>&1

python3 - "$results" <<'PY'
import json, statistics, sys
runs = {}
for run in json.load(open(sys.argv[1]))["benchmarks"]:
    if run.get("run_type") == "iteration":
        runs.setdefault(run["run_name"], []).append(run["real_time"])

def ratio(name, over, under):
    pairs = [a / b for a, b in zip(runs[over], runs[under])]
    print(name, f"{statistics.median(pairs):.3g}")

ratio("certify_1um_vs_cut", "certify_finish/1000/real_time", "cut_finish/100/real_time")
ratio("certify_100nm_vs_1um", "certify_finish/100/real_time", "certify_finish/1000/real_time")
PY
