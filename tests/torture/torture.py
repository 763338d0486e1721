#!/usr/bin/env python3
"""torture.py PROGRAM MINUTES [--seed N] [SCENARIO...] - see README.md."""

import argparse
import signal
import subprocess
import sys
import time

from bench import Bench, Fault, Variants
from readers import Readers
from scenarios import Scenarios

# Tries of each for one of the rarest: what takes long is done more seldom.
SHARES = {'kill': 6, 'stop': 10, 'together': 4, 'cache': 1, 'history': 3, 'disk': 6, 'limits': 8, 'output': 2,
          'view': 3, 'readers': 12}


def arguments():
    parser = argparse.ArgumentParser(prog='torture.sh')
    parser.add_argument('program')
    parser.add_argument('minutes', type=float)
    parser.add_argument('--seed', type=int, default=int(time.time()))
    # What is promised are two seconds, of a machine that is not busy with much else.
    parser.add_argument('--patience', type=float, default=2.5)
    parser.add_argument('scenarios', nargs='*', metavar='SCENARIO', default=[])
    return parser.parse_intermixed_args()


def attempt(bench, name, work):
    """False where a fault was found."""
    try:
        work()
        bench.count(f'{name}: tries')
        return True
    except (Fault, subprocess.TimeoutExpired, OSError) as fault:
        print(f'FAULT in {name}: {fault}', flush=True)
        return False


def report(bench, faults, seconds):
    print(f'--- {seconds / 60:.1f} minutes')
    for what, count in sorted(bench.counts.items()):
        print(f'{count:7}  {what}')
    print(f'{faults:7}  faults' + (f', kept in {bench.folder}' if faults else ''))


def main():
    asked = arguments()
    # In the background of a script SIGINT is ignored, and so it would be by all that is started here.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    print(f'seed {asked.seed}', flush=True)
    bench = Bench(asked.program, asked.seed, asked.patience)
    began, faults = time.monotonic(), 0
    variants = Variants(bench)
    scenarios = Scenarios(bench, variants, Readers(bench))
    works = {name: getattr(scenarios, 'read' if name == 'readers' else name) for name in asked.scenarios or SHARES}
    until = began + 60 * asked.minutes
    # Each once at least, however short the time is.
    order = list(works)
    while order or time.monotonic() < until:
        name = order.pop(0) if order else bench.random.choices(list(works), [SHARES[n] for n in works])[0]
        faults += not attempt(bench, name, works[name])
    report(bench, faults, time.monotonic() - began)
    if not faults:
        bench.close()
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
