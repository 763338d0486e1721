#!/usr/bin/env python3
"""What planning takes at its peak, and how long: the aircraft's job and wavy plates of many faces.

    plan_memory.py [PROGRAM...] [--runs 3]

Programs (default: build/release/limitgauge) plan each job in turn, so that what else the machine does
meets them alike. Prints medians of the resident peak and of the seconds, and their ratios to the first.
"""
import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import growth

HOUSE = pathlib.Path(__file__).resolve().parents[2]
# Faces a side, side, step, tolerance, mm: one face 2.4 mm wide, as in a dense cage.
PLATES = (100, 240, 0.5, 0.01), (200, 480, 0.25, 0.005)


def jobs(folder):
    """Name and file of each job."""
    yield "aircraft", HOUSE / "fixtures/jobs/aircraft.toml"
    for faces, side, step, tolerance in PLATES:
        place = folder / f"plate{faces}"
        place.mkdir()
        (place / "plate.obj").write_text(growth.cage(faces, side))
        (place / "job.toml").write_text(growth.job(side, step, tolerance, voxel_mm=0.5))
        yield f"plate of {faces * faces} faces", place / "job.toml"


def planned(program, job, out):
    """Resident peak, MB, and seconds of one plan."""
    began = time.monotonic()
    child = subprocess.Popen([program, "plan", job, "-o", out, "--force", "--quiet"],
                             stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(child.pid, 0)
    if status != 0:
        sys.exit(f"plan_memory: {program} could not plan {job}")
    return used.ru_maxrss * 1024 / 1e6, time.monotonic() - began


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("programs", nargs="*", default=[HOUSE / "build/release/limitgauge"])
    parser.add_argument("--runs", type=int, default=3)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for name, job in jobs(folder):
            runs = [[planned(program, job, folder / "out") for program in asked.programs]
                    for _ in range(asked.runs)]
            medians = [[statistics.median(run[p][k] for run in runs) for k in (0, 1)]
                       for p in range(len(asked.programs))]
            for program, (peak, seconds) in zip(asked.programs, medians):
                print(f"{name}: {peak:.0f} MB ({peak / medians[0][0]:.2f}), "
                      f"{seconds:.2f} s ({seconds / medians[0][1]:.2f})  {program}", flush=True)


if __name__ == "__main__":
    main()
