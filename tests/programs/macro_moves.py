#!/usr/bin/env python3
"""Works out the moves of programs with macro B a second time, from Fanuc's and Haas's manuals alone, and
compares them with those that `limitgauge inspect --moves` prints.

    macro_moves.py [--limitgauge CMD] [PROGRAM.nc ...]

Without programs: every good one of fixtures/programs/controls/fanuc and haas that has a macro statement or a
call and none of the codes that are not known here (arcs, cycles, offsets). Exits 1 on a difference.
"""

import argparse
import math
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
KNOWN_G = {0, 1, 4, 17, 21, 40, 80, 90, 91, 94, 98, 99, 65}
MACRO = re.compile(r"#|GOTO|WHILE|M97|M98|G65", re.I)
ARGUMENTS = dict(zip("ABCIJKDEFHMQRSTUVWXYZ", [1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 13, *range(17, 27)]))
MOST_BLOCKS = 100_000


class NotKnown(Exception):
    """A program of things that this evaluator leaves out."""


class Vacant(float):
    """Nothing, and 0 in calculations."""


def away(value):
    return math.floor(value) if value < 0 else math.ceil(value)


FUNCTIONS = {
    "SIN": lambda v: math.sin(math.radians(v)), "COS": lambda v: math.cos(math.radians(v)),
    "TAN": lambda v: math.tan(math.radians(v)), "SQRT": math.sqrt, "ABS": abs, "FIX": math.trunc,
    "FUP": away, "ROUND": lambda v: math.copysign(math.floor(abs(v) + 0.5), v),
}
LEVELS = [["EQ", "NE", "GT", "GE", "LT", "LE"], ["+", "-", "OR", "XOR"], ["*", "/", "AND", "MOD"]]


def joined(operator, a, b):
    if operator in ("EQ", "NE"):
        if isinstance(a, Vacant) or isinstance(b, Vacant):
            same = isinstance(a, Vacant) and isinstance(b, Vacant)
        else:
            same = abs(a - b) < 1e-6
        return float(same == (operator == "EQ"))
    return float({
        "GT": lambda: a > b, "GE": lambda: a >= b, "LT": lambda: a < b, "LE": lambda: a <= b,
        "+": lambda: a + b, "-": lambda: a - b, "*": lambda: a * b, "/": lambda: a / b,
        "MOD": lambda: math.fmod(a, b), "AND": lambda: int(a) & int(b), "OR": lambda: int(a) | int(b),
        "XOR": lambda: int(a) ^ int(b),
    }[operator]())


class Reader:
    """Values in one line."""

    def __init__(self, text, machine):
        self.text, self.at, self.machine, self.in_address = text, 0, machine, False

    def rest(self):
        return self.text[self.at:]

    def value(self):
        rest = self.rest()
        if rest[0] in "+-":
            self.at += 1
            inner = self.value()
            return inner if rest[0] == "+" or isinstance(inner, Vacant) else -inner
        if rest[0] == "[":
            self.at += 1
            inner = self.calculation(0)
            self.at += 1
            return inner
        if rest[0] == "#":
            self.at += 1
            return self.machine.get(int(round(self.value())))
        name = re.match(r"[A-Z]+(?=\[)", rest)
        if name:
            self.at += name.end()
            argument = self.value()
            # In an address to the least increment, elsewhere to whole numbers.
            if name[0] == "ROUND" and self.in_address:
                return FUNCTIONS["ROUND"](argument * 1000) / 1000
            if name[0] == "ATAN":
                self.at += 1
                return math.degrees(math.atan2(argument, self.value()))
            return float(FUNCTIONS[name[0]](argument))
        number = re.match(r"\d*\.?\d*", rest)
        self.at += number.end()
        return float(number[0])

    def calculation(self, level):
        if level == len(LEVELS):
            return self.value()
        left = self.calculation(level + 1)
        while True:
            operator = next((o for o in LEVELS[level] if self.rest().startswith(o)), None)
            if operator is None:
                return left
            self.at += len(operator)
            left = joined(operator, left, self.calculation(level + 1))


class Machine:
    """Fanuc's and Haas's order of blocks, and straight moves in millimetres."""

    def __init__(self, text, control):
        self.control = control
        lines = [re.sub(r"\([^)]*\)|\s", "", line).upper() for line in text.split("\n")]
        self.lines = [re.sub(r"^/\d?", "", line) for line in lines]
        self.shared, self.locals = {}, [{}]
        self.place, self.motion, self.incremental = [0.0, 0.0, 0.0], None, False
        self.moves, self.calls, self.loops = [], [], []

    def get(self, number):
        if number == 0:
            return Vacant()
        if number >= 1000:
            raise NotKnown(f"#{number}")
        kept = self.locals[-1] if number <= 33 else self.shared
        return kept.get(number, Vacant()) if number <= 33 else kept[number]

    def set(self, number, value):
        (self.locals[-1] if number <= 33 else self.shared)[number] = value

    def program(self, number):
        return next(i for i, line in enumerate(self.lines) if re.match(rf"[O:]0*{number}$", line))

    def bounds(self, at):
        begin = max((i for i in range(at + 1) if re.match(r"[O:]\d", self.lines[i])), default=-1)
        end = next((i for i in range(at + 1, len(self.lines)) if re.match(r"[O:]\d", self.lines[i])),
                   len(self.lines))
        return begin + 1, end

    def block(self, number, at):
        begin, end = self.bounds(at)
        return next(i for i in range(begin, end) if re.match(rf"N0*{number}(?!\d)", self.lines[i]))

    def run(self):
        at, blocks = 0, 0
        while at is not None and at < len(self.lines):
            blocks += 1
            if blocks > MOST_BLOCKS:
                raise NotKnown("without end")
            at = self.carry_out(at, re.sub(r"^N\d+", "", self.lines[at]))
        return self.moves

    def carry_out(self, at, line):
        if line in ("", "%") or re.match(r"[O:]\d", line):
            return at + 1
        if line.startswith("IF"):
            reader = Reader(line[2:], self)
            if not reader.value():
                return at + 1
            rest = reader.rest()
            return self.carry_out(at, rest[4:] if rest.startswith("THEN") else rest)
        if line.startswith("GOTO"):
            return self.block(int(Reader(line[4:], self).value()), at)
        if line.startswith("WHILE"):
            reader = Reader(line[5:], self)
            holds = reader.value()
            number = reader.rest()[2:]
            return at + 1 if holds else self.lines.index("END" + number, at) + 1
        if line.startswith("END"):
            return next(i for i in range(at, -1, -1) if self.lines[i].endswith("DO" + line[3:]))
        if line.startswith("#"):
            name, value = line[1:].split("=", 1)
            self.set(int(Reader(name, self).value()), Reader(value, self).calculation(0))
            return at + 1
        return self.words(at, line)

    def words(self, at, line):
        found, reader = [], Reader(line, self)
        while reader.rest():
            letter = reader.rest()[0]
            reader.at += 1
            reader.in_address = letter in "XYZIJKRQABC"
            begin, value = reader.at, reader.value()
            # What is calculated is rounded to the least increment.
            if letter in "XYZ" and not isinstance(value, Vacant) and re.search(r"[#\[]", line[begin:reader.at]):
                value = FUNCTIONS["ROUND"](value * 1000) / 1000
            found.append((letter, value))
        moves = {letter: v for letter, v in found if letter in "XYZ" and not isinstance(v, Vacant)}
        codes = [v for letter, v in found if letter == "M"]
        if ("G", 65) in found:
            return self.call_macro(at, found)
        for code in (v for letter, v in found if letter == "G"):
            if code not in KNOWN_G:
                raise NotKnown(f"G{code}")
            self.motion = code if code in (0, 1) else self.motion
            self.incremental = code == 91 if code in (90, 91) else self.incremental
        if any(letter in "AIJKRQDH" for letter, _ in found) or ("G", 4) in found and moves:
            raise NotKnown(line)
        if moves:
            for axis, v in moves.items():
                i = "XYZ".index(axis)
                self.place[i] = v + (self.place[i] if self.incremental else 0)
            self.moves.append((at + 1, "feed" if self.motion else "rapid", *self.place))
        return self.jump(at, codes, dict(found))

    def jump(self, at, codes, words):
        if 30 in codes or 2 in codes:
            return None
        if 98 in codes or 97 in codes:
            number, times = int(words["P"]), int(words.get("L", 1))
            if 98 in codes and number >= 10_000 and "L" not in words:
                number, times = number % 10_000, number // 10_000
            to = self.program(number) if 98 in codes else self.block(number, at)
            self.calls.append((at, to, times, None))
            return to
        if 99 in codes:
            begin, to, times, arguments = self.calls.pop()
            left = self.locals.pop() if arguments is not None else None
            if "P" in words:
                return self.block(int(words["P"]), begin)
            if times == 1:
                return begin + 1
            if arguments is not None:
                # Haas hands arguments over once, and the next run finds what this one left.
                self.locals.append(left if self.control == "haas" else dict(arguments))
            self.calls.append((begin, to, times - 1, arguments))
            return to
        return at + 1

    def call_macro(self, at, found):
        arguments, sets, last, words = {}, 0, "", dict(found)
        for letter, value in found:
            if letter in "GPL":
                continue
            shift = 0
            if letter in "IJK":
                sets += sets == 0 or letter <= last
                last, shift = letter, 3 * (sets - 1)
            arguments[ARGUMENTS[letter] + shift] = value
        to = self.program(int(words["P"]))
        self.calls.append((at, to, int(words.get("L", 1)), arguments))
        self.locals.append(dict(arguments))
        return to


def printed_moves(command, path):
    control = path.parent.parent.name
    done = subprocess.run([*command, "inspect", str(path), "--moves", "--control", control],
                          capture_output=True, encoding="latin-1", timeout=60, check=False)
    if done.returncode != 0:
        raise ValueError(done.stderr.strip())
    rows = [line.split() for line in done.stdout.splitlines()]
    return [(int(row[0]), row[1], *map(float, row[2:])) for row in rows]


def difference(path, command):
    """What is wrong; empty where all agree, nothing where the program is left out."""
    text = path.read_text(encoding="latin-1")
    if not MACRO.search(re.sub(r"\([^)]*\)", "", text)):
        return None
    try:
        own = Machine(text, path.parent.parent.name).run()
    except NotKnown:
        return None
    printed = printed_moves(command, path)
    for one, other in zip(own, printed):
        near = all(abs(a - b) < 1e-6 for a, b in zip(one[2:], other[2:]))
        if one[:2] != other[:2] or len(one) != len(other) or not near:
            return f"worked out {one}, printed {other}"
    return "" if len(own) == len(printed) else f"{len(own)} moves worked out, {len(printed)} printed"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--limitgauge", default=str(ROOT / "build/release/limitgauge"))
    parser.add_argument("programs", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    folder = ROOT / "fixtures/programs/controls"
    programs = options.programs or sorted([*folder.glob("fanuc/good/*.nc"), *folder.glob("haas/good/*.nc")])
    found = {path: difference(path, shlex.split(options.limitgauge)) for path in programs}
    compared = [path for path, wrong in found.items() if wrong is not None]
    for path in compared:
        if found[path]:
            print(f"{path}: {found[path]}")
    differing = sum(1 for path in compared if found[path])
    print(f"{len(compared)} programs compared, {differing} differ")
    return 1 if differing or not compared else 0


if __name__ == "__main__":
    sys.exit(main())
