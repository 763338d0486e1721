"""How the time of every phase grows, from real runs of the program.

A wavy plate is planned, cut and measured again and again, each time with another number of faces, moves,
surface voxels, or another area. To the seconds of each phase, as result.json has them, and to the memory at
the process's peak a product of powers is fitted by least squares of the logarithms.

    growth.py [--quick] [--save FIT]     runs, and prints the exponents
    growth.py --predict FIT faces=N moves=N area_mm2=N voxels=N [parts=N]
                                         prints what a fit that was saved says of another part, and what goes
                                         over the network where its measuring is shared out in so many parts
"""

import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

FACTORS = "faces", "moves", "area_mm2", "voxels"
# Exponents from here on are growth and not noise, in runs this small.
COUNTS = 0.2
# sizeof(model::Move); sizeof what stage_pieces.cpp packs of a sample; StageCheck::field_spacing_mm.
BYTES_A_MOVE, BYTES_A_SAMPLE, FIELD_SPACING_MM = 32, 41, 0.25
PHASES = ("model", "planning", "cutting", "reach", "certificate", "field", "unavoidable", "rays", "findings",
          "files", "peak_bytes", "output_bytes")


def cage(faces_a_side, side_mm):
    """A plate with two waves a side, a twentieth of it high."""
    n = faces_a_side
    height = lambda i, j: side_mm / 40 * math.sin(4 * math.pi * i / n) * math.cos(4 * math.pi * j / n)
    lines = [f"v {side_mm * (i / n - 0.5)} {side_mm * (j / n - 0.5)} {height(i, j)}"
             for j in range(n + 1) for i in range(n + 1)]
    at = lambda i, j: j * (n + 1) + i + 1
    lines += [f"f {at(i, j)} {at(i + 1, j)} {at(i + 1, j + 1)} {at(i, j + 1)}"
              for j in range(n) for i in range(n)]
    return "\n".join(lines) + "\n"


def job(side_mm, step_mm, tolerance_mm, voxel_mm):
    margin, high = 5, side_mm / 40
    return f"""name = "growth"
[surface]
cage = "plate.obj"
[stock]
shape = "box"
size = [{side_mm + 2 * margin}, {side_mm + 2 * margin}, {2 * high + 6}]
corner = [{-side_mm / 2 - margin}, {-side_mm / 2 - margin}, {-high - 5}]
[[tool]]
id = "ball"
type = "ball"
diameter = 6
flute_length = {max(25, 2 * high + 10)}
[[stage]]
name = "finish"
tool = "ball"
strategy = "zigzag"
step = {step_mm}
tolerance = {tolerance_mm}
feed = 1200
[stage.gate]
gouge = 0.05
uncut = 0.2
[simulation]
voxel = {voxel_mm}
[report]
pictures = false
"""


def run(program, faces_a_side, side_mm, step_mm, tolerance_mm, voxel_mm):
    """Sizes and seconds of one run."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "plate.obj").write_text(cage(faces_a_side, side_mm))
        (folder / "job.toml").write_text(job(side_mm, step_mm, tolerance_mm, voxel_mm))
        began = time.monotonic()
        ran = subprocess.run([program, "run", folder / "job.toml", "-o", folder / "out", "--quiet"],
                             capture_output=True, text=True)
        wall = time.monotonic() - began
        if ran.returncode > 2:
            sys.exit(f"growth: exit code {ran.returncode}: {ran.stderr.strip()}")
        result = json.load(open(folder / "out" / "result.json"))
        size = sum(f.stat().st_size for f in (folder / "out").rglob("*") if f.is_file())
    return figures(result, wall, size)


def figures(result, wall, output_bytes):
    stage = result["stages"][0]
    area = result["surface"]["area_mm2"]
    row = {"faces": result["surface"]["faces"], "moves": stage["toolpath"]["moves"], "area_mm2": area,
           "voxels": area / stage["simulation"]["voxel_mm"] ** 2,
           "model": result["surface"]["seconds"], "planning": stage["toolpath"]["seconds"],
           "cutting": stage["simulation"]["seconds"]}
    row |= {name: phase["seconds"] for name, phase in stage["deviation"]["phases"].items()}
    # The stage's own files, and the report behind it.
    row["files"] = wall - row["model"] - row["planning"] - row["cutting"] - stage["deviation"]["seconds"]
    row["peak_bytes"] = stage["simulation"]["peak_memory_bytes"]
    row["output_bytes"] = output_bytes
    return row


def solve(matrix, right):
    """Gauss with pivots; rows of the matrix are changed."""
    n = len(right)
    rows = [row + [b] for row, b in zip(matrix, right)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        if abs(rows[k][k]) < 1e-12:
            sys.exit("growth: the runs do not differ in every factor")
        for i in range(n):
            if i != k:
                share = rows[i][k] / rows[k][k]
                rows[i] = [a - share * b for a, b in zip(rows[i], rows[k])]
    return [rows[k][n] / rows[k][k] for k in range(n)]


def fit(runs, phase, factors=FACTORS):
    """Exponents of the factors, the constant's logarithm, and by how much a run is off at most."""
    rows = [[math.log(r[f]) for f in factors] + [1.0] for r in runs]
    ys = [math.log(max(r[phase], 1e-4)) for r in runs]
    normal = [[sum(r[i] * r[j] for r in rows) for j in range(len(rows[0]))] for i in range(len(rows[0]))]
    found = solve(normal, [sum(r[i] * y for r, y in zip(rows, ys)) for i in range(len(rows[0]))])
    worst = max(abs(sum(c * x for c, x in zip(found, r)) - y) for r, y in zip(rows, ys))
    return {"exponents": dict(zip(factors, found)), "constant": found[-1], "off_by": math.exp(worst),
            "largest": max(r[phase] for r in runs)}


def plan(quick):
    """(faces a side, side, step, tolerance, voxel): a base, and each factor by itself; where the area
    changes, step, tolerance and voxel go with it, so that moves and voxels stay."""
    n, side, step, tolerance, voxel = (3, 16, 1.0, 0.02, 0.8) if quick else (6, 60, 0.3, 0.004, 0.2)
    powers = (2,) if quick else (2, 4)
    base = (n, side, step, tolerance, voxel)
    runs = [base]
    runs += [(n * k, side, step, tolerance, voxel) for k in powers]
    runs += [(n, side, step / k, tolerance, voxel) for k in powers]
    runs += [(n, side * k, step * k, tolerance * k, voxel * k) for k in ((1.5,) if quick else (1.5, 2))]
    runs += [(n, side, step, tolerance, voxel / k) for k in powers]
    return runs


def measure(quick):
    house = pathlib.Path(__file__).resolve().parents[2]
    program = os.environ.get("LIMITGAUGE", house / "build/release/limitgauge")
    runs = []
    for sizes in plan(quick):
        runs.append(run(program, *sizes))
        print("  ".join(f"{f} {runs[-1][f]:.4g}" for f in FACTORS) + "  |  " +
              "  ".join(f"{p} {runs[-1][p]:.3g}" for p in PHASES), file=sys.stderr, flush=True)
    return {"runs": runs, "fits": {phase: fit(runs, phase) for phase in PHASES}}


def print_exponents(fits, factors=FACTORS):
    print(f"{'phase':14}" + "".join(f"{f:>10}" for f in factors) + f"{'off by':>9}{'largest':>12}")
    for phase, found in fits.items():
        print(f"{phase:14}" + "".join(f"{found['exponents'][f]:10.2f}" for f in factors) +
              f"{found['off_by']:8.2f}x{found['largest']:12.4g}")


def in_proportion(found, runs, phase, sizes):
    """From the run that took longest, in proportion to the factor that makes most of it: small parts hide
    growth behind what is fixed, so a factor that counts at all counts in full. What factors make adds up and
    does not multiply (a cut visits its moves, and its voxels)."""
    run = max(runs, key=lambda r: r[phase])
    grown = [(sizes[factor] / run[factor]) ** max(exponent, 1)
             for factor, exponent in found["exponents"].items() if exponent > COUNTS]
    return run[phase] * max(grown, default=1)


def print_traffic(sizes, parts):
    """What app/share hands over, uncompressed: to every task all moves so far, from those of the field each
    sample with the tip that touches it."""
    tasks = 2 * parts + 3
    stage, samples = BYTES_A_MOVE * sizes["moves"], sizes["area_mm2"] / FIELD_SPACING_MM ** 2
    print(f"tasks of a stage {tasks}")
    print(f"bytes to each task {stage:.3g}, to all {stage * tasks:.3g}")
    print(f"bytes of samples back {samples * BYTES_A_SAMPLE:.3g}")


def predict(file, sizes):
    sizes = {key: float(value) for key, value in (s.split("=") for s in sizes)}
    parts = int(sizes.pop("parts", 16))
    if set(sizes) != set(FACTORS):
        sys.exit(__doc__)
    saved = json.load(open(file))
    print(f"{'phase':14}{'by the fit':>12}{'in proportion':>15}")
    for phase, found in saved["fits"].items():
        if phase == "findings":
            continue  # none in a part that passes
        fitted = found["constant"] + sum(found["exponents"][f] * math.log(sizes[f]) for f in FACTORS)
        print(f"{phase:14}{math.exp(fitted):12.3g}{in_proportion(found, saved['runs'], phase, sizes):15.3g}")
    print_traffic(sizes, parts)


def main(arguments):
    if len(arguments) >= 2 and arguments[0] == "--predict":
        return predict(arguments[1], arguments[2:])
    quick = "--quick" in arguments
    rest = [a for a in arguments if a != "--quick"]
    if rest and (len(rest) != 2 or rest[0] != "--save"):
        sys.exit(__doc__)
    measured = measure(quick)
    print_exponents(measured["fits"])
    if rest:
        json.dump(measured, open(rest[1], "w"), indent=1)


if __name__ == "__main__":
    main(sys.argv[1:])
