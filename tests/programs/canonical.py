"""LinuxCNC's canonical calls as motions of the tool's tip in the machine's frame, mm.

LinuxCNC's stand-alone interpreter, rs274, prints end points in the work frame and the unit in
force, and each change of frame as a call of its own. Here those calls are kept track of, so that
its motions can be laid beside those of `limitgauge inspect --moves`.
"""

import math
import os
import re
import subprocess
import tempfile
from dataclasses import dataclass, field

MM_PER_INCH = 25.4  # rs274 without an INI file is a machine in inches: so is its tool table
PLANES = {"XY": 17, "XZ": 18, "YZ": 19}
AXES = {17: (0, 1, 2), 18: (2, 0, 1), 19: (1, 2, 0)}


@dataclass
class Move:
    """One canonical motion. `line` is 0 where it is not known."""

    kind: str
    to: tuple
    line: int = 0
    plane: int = 17
    centre: tuple = ()
    turns: float = 0
    slack: float = 1e-6  # how far rounding may have put it from the truth, mm

    def text(self):
        numbers = [f"{value:.4f}" for value in self.to + tuple(self.centre)]
        if self.kind != "arc":
            return f"{self.line} {self.kind} " + " ".join(numbers)
        return f"{self.line} arc {self.plane} " + " ".join(numbers) + f" {self.turns:g}"


@dataclass
class Machine:
    """What the calls before a motion have set, in mm and degrees."""

    unit: float = 1.0
    origin: tuple = (0.0, 0.0, 0.0)
    g92: tuple = (0.0, 0.0, 0.0)
    rotation: float = 0.0
    offset: tuple = (0.0, 0.0, 0.0)
    plane: int = 17
    selected: int = 0
    tool: int = 0
    position: tuple = (0.0, 0.0, 0.0)  # in the work frame, mm
    lengths: dict = field(default_factory=dict)  # of tools, by number; empty: no table
    decimals: int = 4  # that rs274 prints

    def to_machine(self, point):
        x, y, z = (p + g for p, g in zip(point, self.g92))
        sine, cosine = math.sin(math.radians(self.rotation)), math.cos(math.radians(self.rotation))
        turned = (x * cosine - y * sine, x * sine + y * cosine, z)
        # A tool that is not in a table is as long as the length offset in use says.
        length = self.lengths.get(self.tool, self.offset[2])
        x, y, z = (t + o + f for t, o, f in zip(turned, self.origin, self.offset))
        return (x, y, z - length)

    def slack(self, point):
        """Each number is rounded in its unit, 6 decimals are ours; an angle's error has a lever."""
        half = 0.5 * 10**-self.decimals
        reach = math.hypot(point[0] + self.g92[0], point[1] + self.g92[1])
        turned = math.radians(half) * reach if self.rotation else 0.0
        return 4 * half * max(self.unit, 1.0) + turned + 1e-6


def numbers_of(text):
    return [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?", text)]


def canonical_moves(output, lengths):
    """The motions in what rs274 printed. `lengths` of tools in mm by number."""
    decimals = max((len(d) for d in re.findall(r"\.(\d+)", output)), default=4)
    machine, moves = Machine(lengths=lengths, decimals=decimals), []
    machine.tool = next(iter(lengths)) if len(lengths) == 1 else 0  # limitgauge's rule
    for row in output.splitlines():
        match = re.match(r"\s*\d+ N(\d+|\.+)\s*(\w+)\((.*)\)\s*$", row)
        if not match:
            continue
        line = int(match[1]) if match[1].isdigit() else 0
        carry_out(machine, moves, line, match[2], match[3])
    return moves


def carry_out(machine, moves, line, call, text):
    if call == "SELECT_PLANE":
        machine.plane = PLANES[text[-2:]]
        return
    if call == "USE_LENGTH_UNITS":
        machine.unit = MM_PER_INCH if text.endswith("INCHES") else 1.0
        return
    values = numbers_of(text)
    lengths = tuple(value * machine.unit for value in values)
    if call == "SET_G5X_OFFSET":
        machine.origin = lengths[1:4]
    elif call == "SET_G92_OFFSET":
        machine.g92 = lengths[:3]
    elif call == "SET_XY_ROTATION":
        machine.rotation = values[0]
    elif call == "USE_TOOL_LENGTH_OFFSET":
        machine.offset = lengths[:3]
    elif call == "SELECT_TOOL":
        machine.selected = int(values[0])
    elif call == "CHANGE_TOOL":  # which prints the place in the magazine
        machine.tool = machine.selected
    elif call == "CHANGE_TOOL_NUMBER":  # the same
        machine.tool = (list(machine.lengths) or range(1, 100))[int(values[0]) - 1]
    elif call in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED"):
        kind = "rapid" if call == "STRAIGHT_TRAVERSE" else "feed"
        add(machine, moves, Move(kind, lengths[:3], line))
    elif call == "ARC_FEED":
        add(machine, moves, arc(machine, line, lengths, values[4]))
    elif call == "RIGID_TAP":
        raise ValueError("rs274 taps rigidly, which nothing here stands for")


def arc(machine, line, lengths, turns):
    first, second, normal = AXES[machine.plane]
    to, centre = [0.0] * 3, list(machine.position)
    to[first], to[second], to[normal] = lengths[0], lengths[1], lengths[5]
    centre[first], centre[second] = lengths[2], lengths[3]
    return Move("arc", tuple(to), line, machine.plane, tuple(centre), turns)


def add(machine, moves, move):
    machine.position = move.to
    move.slack = machine.slack(move.to)
    if move.kind == "arc":
        first, second, _ = AXES[move.plane]
        move.slack += machine.slack(move.centre)
        centre = machine.to_machine(move.centre)
        move.centre = (centre[first], centre[second])
    move.to = machine.to_machine(move.to)
    moves.append(move)


def limitgauge_moves(output):
    """The motions that `limitgauge inspect --moves` printed."""
    moves = []
    for row in output.splitlines():
        words = row.split()
        line, kind = int(words[0]), words[1]
        if kind != "arc":
            moves.append(Move(kind, tuple(map(float, words[2:5])), line))
            continue
        values = [float(word) for word in words[3:]]
        moves.append(
            Move("arc", tuple(values[:3]), line, int(words[2]), tuple(values[3:5]), values[5])
        )
    return moves


def read_tools(table):
    """Length and diameter in mm by number, of a tool table in LinuxCNC's text."""
    tools = {}
    for row in table.splitlines():
        words = dict(re.findall(r"([A-Za-z])\s*([-+.\d]+)", row.split(";")[0]))
        if "T" in words:
            tools[int(words["T"])] = (float(words.get("Z", 0)), float(words.get("D", 0)))
    return tools


def numbered(program):
    """The program with each line's number as its N word, by which rs274 tells motions apart."""
    rows = []
    for number, row in enumerate(program.split("\n"), start=1):
        match = re.match(r"\s*(/?)\s*(?:[nN]\s*[\d.]+)?(.*)", row.rstrip("\r"), re.DOTALL)
        rest = match[2]
        if re.match(r"\s*($|[oO%(;])", rest):
            rows.append(row)
        else:
            rows.append(f"{match[1]}N{number} {rest.lstrip()}")
    return "\n".join(rows)


def run_rs274(command, program, tools):
    """What rs274 prints for the program's text; raises ValueError where it complains."""
    text = numbered(program)
    if not text.lstrip().startswith("%"):
        text += "\nM2\n"  # rs274 wants an end, limitgauge does not
    if not tools:  # any T and H may be asked for; the lengths cancel
        tools_text = "".join(f"T{n} P{n} Z0 D0\n" for n in range(1, 100))
    else:
        tools_text = "".join(
            f"T{n} P{n} Z{z / MM_PER_INCH:.12f} D{d / MM_PER_INCH:.12f}\n"
            for n, (z, d) in tools.items()
        )
    with tempfile.TemporaryDirectory() as folder:
        for name, content in (("p.ngc", text), ("t.tbl", tools_text), ("v.var", parameters())):
            with open(os.path.join(folder, name), "w", encoding="latin-1", newline="") as out:
                out.write(content)
        arguments = ["-g", "-n", "2", "-t", "t.tbl", "-v", "v.var", "p.ngc"]
        done = subprocess.run(
            [*command, *arguments],
            cwd=folder, env=os.environ | {"HOME": folder},  # it shares $HOME/.tool.mmap otherwise
            capture_output=True, encoding="latin-1", timeout=60, check=False,
        )
    complaint = done.stderr.replace("executing\n", "").strip()
    if done.returncode != 0 or complaint:
        raise ValueError("rs274: " + complaint.replace("\n", " | "))
    return done.stdout


def parameters():
    """LinuxCNC's parameter file of a fresh machine."""
    needed = [5161 + i for i in range(9)] + [5181 + i for i in range(9)] + [5210 + i for i in range(10)]
    needed += [5221 + 20 * system + i for system in range(9) for i in range(10)]
    values = {number: 0 for number in needed} | {5220: 1}
    return "".join(f"{number} {values[number]}\n" for number in sorted(values))
