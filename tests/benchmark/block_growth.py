"""How all that a job does with a cut grows with moves and with voxels, up to five million moves on a block of
300 x 300 x 80 mm at 0.1 mm. Exponents are fitted to the processor time of each phase as growth.py does it.

    build/release/tests/benchmark/limitgauge_benchmarks --benchmark_filter=block_huge \\
        --benchmark_out=RESULTS.json --benchmark_out_format=json          some minutes, 4 GB
    block_growth.py RESULTS.json                                          prints the exponents
"""

import json
import sys

import growth

FACTORS = "moves", "voxels"
PHASES = "cut_s", "lines_s", "agree_s", "points_s", "cpu_time", "peak_bytes"


def main(arguments):
    if len(arguments) != 1:
        sys.exit(__doc__)
    runs = [run for run in json.load(open(arguments[0]))["benchmarks"]
            if run["name"].startswith("block_huge") and run.get("run_type") == "iteration"]
    growth.print_exponents({phase: growth.fit(runs, phase, FACTORS) for phase in PHASES}, FACTORS)


if __name__ == "__main__":
    main(sys.argv[1:])
