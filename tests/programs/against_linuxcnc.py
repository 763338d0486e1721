#!/usr/bin/env python3
"""Compares the motions of programs as Limitgauge and as LinuxCNC read them.

    against_linuxcnc.py [--limitgauge CMD] [--rs274 CMD] [--random N] [--seed S] [PROGRAM.ngc ...]

Without programs: all of fixtures/programs/good. `PROGRAM.tbl` beside a program is its tool table
(mm). A program whose comments say `against LinuxCNC: REASON` is left out, and the reason printed.
With --random, that many programs are made up instead, the same ones for the same seed.

Exits 0 where all agree, 1 on a difference, 77 where LinuxCNC's rs274 is not installed.
"""

import argparse
import concurrent.futures
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

from canonical import canonical_moves, limitgauge_moves, read_tools, run_rs274
from random_programs import random_program

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SKIPPED = 77
LEFT_OUT = re.compile(r"against LinuxCNC: ([^)\n]*)")


def run_limitgauge(command, path, table):
    arguments = ["inspect", str(path), "--moves"]
    if table is not None:
        arguments += ["--tool-table", str(table)]
    done = subprocess.run(
        [*command, *arguments], capture_output=True, encoding="latin-1", timeout=60, check=False
    )
    if done.returncode != 0:
        raise ValueError("limitgauge: " + done.stderr.strip())
    return limitgauge_moves(done.stdout)


def difference(ours, theirs, with_lines):
    """What is wrong with our motion beside theirs; empty where they agree."""
    if with_lines and ours.line and theirs.line and ours.line != theirs.line:
        return "line"
    if ours.kind != theirs.kind:
        return "kind"
    slack = theirs.slack
    if any(abs(a - b) > slack for a, b in zip(ours.to, theirs.to)):
        return "end"
    if ours.kind != "arc":
        return ""
    if ours.plane != theirs.plane:
        return "plane"
    if any(abs(a - b) > slack for a, b in zip(ours.centre, theirs.centre)):
        return "centre"
    return "" if ours.turns == theirs.turns else "turns"


def compare(ours, theirs, with_lines):
    """A report of the first difference; empty where all agree."""
    for index, (one, other) in enumerate(zip(ours, theirs)):
        wrong = difference(one, other, with_lines)
        if wrong:
            return f"motion {index + 1}, {wrong}:\n    limitgauge {one.text()}\n    LinuxCNC   {other.text()}"
    if len(ours) == len(theirs):
        return ""
    longer, rest = ("limitgauge", ours) if len(ours) > len(theirs) else ("LinuxCNC", theirs)
    more = rest[min(len(ours), len(theirs))]
    return f"{len(ours)} motions against {len(theirs)}; only in {longer}: {more.text()}"


def compare_program(path, options):
    text = path.read_text(encoding="latin-1")
    table = path.with_suffix(".tbl")
    tools = read_tools(table.read_text()) if table.exists() else {}
    try:
        theirs = canonical_moves(
            run_rs274(options.rs274, text, tools), {n: z for n, (z, _) in tools.items()}
        )
    except ValueError as error:
        theirs = str(error)
    try:
        ours = run_limitgauge(options.limitgauge, path, table if tools else None)
    except ValueError as error:
        ours = str(error)
    if isinstance(ours, str) and isinstance(theirs, str):
        return "" if options.random else f"both refuse it:\n    {ours}\n    {theirs}"
    if isinstance(ours, str):
        return f"{ours}\n    LinuxCNC reads {len(theirs)} motions"
    if isinstance(theirs, str):
        return f"{theirs}\n    limitgauge reads {len(ours)} motions"
    # Under cutter compensation LinuxCNC's motions come out lines later than their own.
    with_lines = not re.search(r"[gG]\s*4\s*[12]", text)
    return compare(ours, theirs, with_lines)


def reason_left_out(path):
    match = LEFT_OUT.search(path.read_text(encoding="latin-1"))
    return match[1].strip() if match else ""


def report(programs, options):
    """Compares every program; the number that differ."""
    differing = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for path, text in zip(programs, pool.map(lambda p: compare_program(p, options), programs)):
            if text:
                differing += 1
                print(f"{path}: {text}")
    print(f"{len(programs)} programs compared, {differing} differ")
    return differing


def compare_random(options):
    """Programs that differ are kept for a look; the number of them."""
    folder = pathlib.Path(options.keep or tempfile.mkdtemp(prefix="against_linuxcnc."))
    folder.mkdir(parents=True, exist_ok=True)
    programs = []
    for number in range(options.seed, options.seed + options.random):
        path = folder / f"random-{number}.ngc"
        text, table = random_program(number)
        path.write_text(text)
        if table:
            path.with_suffix(".tbl").write_text(table)
        programs.append(path)
    differing = report(programs, options)
    if not options.keep and differing == 0:
        shutil.rmtree(folder)
    return differing


def arguments():
    parser = argparse.ArgumentParser(description="Compares the motions of programs with LinuxCNC's.")
    parser.add_argument("programs", nargs="*", type=pathlib.Path)
    parser.add_argument("--limitgauge", default=str(ROOT / "build/release/limitgauge"))
    parser.add_argument("--rs274", default="rs274", help="LinuxCNC's stand-alone interpreter")
    parser.add_argument("--random", type=int, default=0, metavar="N")
    parser.add_argument("--seed", type=int, default=1, help="number of the first random program")
    parser.add_argument("--keep", metavar="DIR", help="where random programs are written and stay")
    options = parser.parse_args()
    options.limitgauge = shlex.split(options.limitgauge)
    options.rs274 = shlex.split(options.rs274)
    return options


def main():
    options = arguments()
    if shutil.which(options.rs274[0]) is None:
        print("skipped: LinuxCNC's rs274 is not installed (Debian: linuxcnc-uspace)")
        return SKIPPED
    if shutil.which(options.limitgauge[0]) is None:
        sys.exit(f"{options.limitgauge[0]} is no program; expected limitgauge, built (--limitgauge)")
    if options.random:
        return 1 if compare_random(options) else 0
    programs = options.programs or sorted((ROOT / "fixtures/programs/good").glob("*.ngc"))
    compared = []
    for path in programs:
        reason = reason_left_out(path)
        if reason:
            print(f"{path.name}: left out: {reason}")
        else:
            compared.append(path)
    return 1 if report(compared, options) else 0


if __name__ == "__main__":
    sys.exit(main())
