#!/usr/bin/env bash
# Builds the benchmarks and prints lines NAME VALUE: each the median over five repetitions of a ratio
# of times, or of bytes allocated, measured in one run. Cases called huge (voxels of 0.02 mm, five
# million moves) are left out; --benchmark_filter=huge asks for them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

cmake --preset release -DLIMITGAUGE_BENCHMARKS=ON >/dev/null
cmake --build --preset release --target limitgauge_benchmarks >/dev/null
results=$(mktemp)
trap 'rm -f "$results"' EXIT
build/release/tests/benchmark/limitgauge_benchmarks --benchmark_repetitions=5 \
  --benchmark_filter=-huge --benchmark_min_time=0.2 \
  --benchmark_enable_random_interleaving=true --benchmark_out="$results" \
  --benchmark_out_format=json >/dev/null 2>&1

python3 - "$results" <<'PY'
import json, math, statistics, sys
runs = {}
counters = {}
moves = {}
for run in json.load(open(sys.argv[1]))["benchmarks"]:
    if run.get("run_type") == "iteration":
        # These run on one thread in both: its own time, whatever else the machine does.
        clock = "cpu_time" if run["run_name"].startswith(("section", "parse")) else "real_time"
        runs.setdefault(run["run_name"], []).append(run[clock])
        if "moves" in run:
            moves[run["run_name"]] = run["moves"]
        for key in ("vs_half_edge", "vs_surface_mesh", "vs_surface_mesh_tight"):
            if key in run:
                counters.setdefault(run["run_name"].split("/")[0] + "_" + key, []).append(run[key])

def median_ratio(over, under):
    return statistics.median(a / b for a, b in zip(runs[over], runs[under]))

def ratio(name, over, under):
    print(name, f"{median_ratio(over, under):.3g}")

ratio("certify_1um_vs_cut", "certify_finish/1000/real_time", "cut_finish/100/real_time")
ratio("certify_100nm_vs_1um", "certify_finish/100/real_time", "certify_finish/1000/real_time")
ratio("remove_vs_cut", "remove_finish/100/real_time", "cut_finish/100/real_time")
ratio("certify_casting_vs_block", "certify_finish_of_casting/1000/real_time", "certify_finish/1000/real_time")
# Over one call of the distance and one write for each voxel of the band, at 0.05 mm and at 0.1 mm,
# where fixed costs weigh more; and over the same vectorised, which no single call can match.
for um, name in ((50, ""), (100, "_100um")):
    cut = f"cut_aircraft/{um}/real_time"
    ratio("cut_vs_floor" + name, cut, f"cut_aircraft_floor/{um}/real_time")
    ratio("cut_vs_vector_floor" + name, cut, f"cut_aircraft_vector_floor/{um}/real_time")

def growth(name, sizes):
    """Slope of log time over log size, least squares."""
    xs = [math.log(size) for size in sizes.values()]
    ys = [math.log(statistics.median(runs[run])) for run in sizes]
    x0, y0 = statistics.mean(xs), statistics.mean(ys)
    slope = sum((x - x0) * (y - y0) for x, y in zip(xs, ys)) / sum((x - x0) ** 2 for x in xs)
    print(name, f"{slope:.3g}")

growth("cut_growth_moves", {r: moves[r] for r in runs if r.startswith("cut_growth_moves/")})
# The voxels of a surface go with the inverse square of their edge.
growth("cut_growth_voxels", {r: int(r.split("/")[1]) ** -2.0
                             for r in runs if r.startswith("cut_growth_voxels/")})
ratio("section_vs_cgal_slicer", "section_family", "section_cgal_slicer/iterations:1")
# The worst of all surfaces and distances.
surfaces = [run.removeprefix("closest_point_exact") for run in runs
            if run.startswith("closest_point_exact")]
worst = max(median_ratio("closest_point_exact" + s, "closest_point_cgal_aabb" + s)
            for s in surfaces)
print("closest_point_vs_cgal_aabb", f"{worst:.3g}")
ratio("parse_vs_from_chars", "parse_program/iterations:1", "parse_from_chars/iterations:1")
for name, values in counters.items():
    print(name, f"{statistics.median(values):.4g}")
ratio("cell_refine_vs_cgal", "cell_refine/real_time", "cell_refine_cgal/real_time")
ratio("cell_refine_vs_opensubdiv", "cell_refine/real_time", "cell_refine_opensubdiv/real_time")
PY
