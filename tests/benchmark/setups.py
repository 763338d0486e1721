#!/usr/bin/env python3
"""What setups cost: processor time of a planned job as it stands, with the part turned, and with a
change of setup before every stage.

    setups.py [JOB] [--runs 5] [--program LIMITGAUGE]

The part and its stock turn about Z, by angles at which nothing lies along the axes any more, so that
the engine has the same to plan and the verifier the same to prove; what differs is what setups cost:
stock that leans, its turning over, reach from more than one way to stand. Pictures are left out on
every side. Prints medians, their ratios to the job as it stands, and by how much certified ends differ.
"""
import argparse
import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent.parent
FIRST_DEG, STEP_DEG = 30, 45


def turned_job(text, folder, setup_of_stage):
    """The job with a setup for each number among setup_of_stage, as many as it has stages."""
    head, *stages = text.replace('cage = "', 'cage = "%s/' % folder).split("[[stage]]")
    setups = "".join('[[setup]]\nname = "%d"\nrotate = [{ axis = [0, 0, 1], angle = %d }]\n'
                     % (k, FIRST_DEG + STEP_DEG * k) for k in sorted(set(setup_of_stage)))
    return head + setups + "".join('[[stage]]\nsetup = "%d"%s' % pair for pair in zip(setup_of_stage, stages))


def run(program, job, out):
    """The result, and the processor time in seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program, "run", job, "-o", out, "--no-pictures", "--quiet", "--force"],
                          capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode > 1:
        sys.exit(done.stderr)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return json.loads((out / "result.json").read_text()), used


def ends(result):
    return [stage["deviation"][figure][end] for stage in result["stages"]
            for figure in ("gouge_mm", "uncut_mm") for end in ("low", "high")]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("job", type=pathlib.Path, nargs="?",
                        default=REPOSITORY / "fixtures/jobs/quick-dome.toml")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--program", default=os.environ.get(
        "LIMITGAUGE", REPOSITORY / "build/release/limitgauge"))
    said = parser.parse_args()
    text, folder = said.job.read_text(), said.job.resolve().parent
    stages = text.count("[[stage]]")
    kinds = {
        "as it stands": text.replace('cage = "', 'cage = "%s/' % folder),
        "turned": turned_job(text, folder, [0] * stages),
        "turned before every stage": turned_job(text, folder, list(range(stages))),
    }
    seconds, results = {kind: [] for kind in kinds}, {}
    with tempfile.TemporaryDirectory() as scratch:
        for _ in range(said.runs):  # by turns, so that a busy machine slows all of them
            for kind, job in kinds.items():
                file = pathlib.Path(scratch) / "job.toml"
                file.write_text(job)
                results[kind], used = run(said.program, file, pathlib.Path(scratch) / "out")
                seconds[kind].append(used)
    plain = statistics.median(seconds["as it stands"])
    for kind in kinds:
        off_mm = max(abs(a - b) for a, b in zip(ends(results[kind]), ends(results["as it stands"])))
        median = statistics.median(seconds[kind])
        print("%-26s %6.2f s, %.2f times; %s, ends differ by up to %.3f µm" %
              (kind, median, median / plain, results[kind]["verdict"], off_mm * 1000))


main()
