"""Random programs that are valid, or nearly so: what two interpreters are compared on.

Every program is its seed's alone. Where a state makes the tool's place in the work frame hard to
know (a new offset, a loop), the generator forgets it and goes to a stated place before it needs it.
"""

import math
import random

LETTERS = "XYZ"
OFFSETS = "IJK"
PLANES = {17: (0, 1, 2), 18: (2, 0, 1), 19: (1, 2, 0)}
SYSTEMS = ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"]
TABLE = "T1 P1 Z40 D6\nT2 P2 Z62.5 D8\nT3 P3 Z35.25 D3\n"


class Writer:
    """The rows of a program, and what the machine stands at after them."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.rows = []
        self.position = None  # in the work frame and the unit in force
        self.incremental = False
        self.centre_absolute = False
        self.plane = 17
        self.inch = False
        self.inverse_time = False
        self.turned = False  # some work frame is rotated: arcs are made in G17 only
        self.motion = None
        self.tools = False
        self.depth = 0
        self.labels = 0
        self.parameters = 0
        self.subroutines = []

    # Numbers

    def value(self, low=-40.0, high=40.0):
        if self.inch:
            low, high = low / 25, high / 25
        return round(self.random.uniform(low, high), self.random.choice([0, 1, 2, 3, 4]))

    def text(self, value):
        """One of the ways in which a number may be written."""
        way = self.random.random()
        if way < 0.04:
            part = round(self.random.uniform(-9, 9), 2)
            return f"[{value - part:.6f}+{self.bracketed(part)}]"
        if way < 0.07:
            self.parameters += 1
            number = 100 + self.parameters
            self.rows.append(f"#{number}={value:.6f}")
            return f"#{number}"
        plain = f"{value:.6f}".rstrip("0")
        if way < 0.4 and value >= 0:
            plain = "+" + plain
        if way < 0.7:
            plain = plain.rstrip(".")
        return plain

    @staticmethod
    def bracketed(value):
        return f"{value:.6f}" if value >= 0 else f"[{value:.6f}]"

    def word(self, letter, value):
        return letter + self.text(value)

    # Places

    def forget(self):
        self.position = None

    def go_to_known_place(self):
        """States every axis in G90."""
        self.position = [self.value() for _ in LETTERS]
        words = " ".join(self.word(*pair) for pair in zip(LETTERS, self.position))
        self.rows.append(f"G90 G0 {words}")
        self.incremental, self.motion = False, 0

    def step_to(self, target):
        """Axis words that lead to `target`, from a position that is known."""
        return [
            self.word(LETTERS[axis], target[axis] - (self.position[axis] if self.incremental else 0))
            for axis in range(3)
            if target[axis] != self.position[axis] or self.random.random() < 0.3
        ]

    def code(self, motion):
        """The G word of a motion; where it is in force already, sometimes none."""
        if self.motion == motion and self.random.random() < 0.5:
            return ""
        self.motion = motion
        return self.random.choice([f"G{motion} ", f"G0{motion} ", f"g{motion}"])

    def feed(self, motion):
        if motion == 0 or not self.inverse_time:
            return ""
        return f" F{self.random.randint(1, 90)}"

    # Statements

    def straight(self):
        motion = self.random.choice([0, 1, 1])
        axes = [axis for axis in range(3) if self.random.random() < 0.6] or [2]
        values = {axis: self.value() / (4 if self.incremental else 1) for axis in axes}
        values = {axis: round(value, 4) for axis, value in values.items()}
        words = " ".join(self.word(LETTERS[axis], value) for axis, value in values.items())
        self.rows.append(f"{self.code(motion)}{words}{self.feed(motion)}")
        if self.position is None:
            return
        for axis, value in values.items():
            self.position[axis] = value + (self.position[axis] if self.incremental else 0)

    def arc(self):
        if self.position is None:
            self.go_to_known_place()
        if self.turned and self.plane != 17:
            self.select_plane(17)
        motion = self.random.choice([2, 3])
        first, second, normal = PLANES[self.plane]
        if self.random.random() < 0.3:
            words, target = self.arc_by_radius(first, second)
        else:
            words, target = self.arc_by_centre(first, second)
        if self.random.random() < 0.3:
            target[normal] = round(target[normal] + self.value(-4, 4), 4)
        turns = f" P{self.random.randint(1, 4)}" if self.random.random() < 0.15 else ""
        ends = self.step_to(target)
        if "R" in words and not any(w[0] in (LETTERS[first], LETTERS[second]) for w in ends):
            ends.append(self.word(LETTERS[first], 0 if self.incremental else target[first]))
            if not self.incremental and target[first] == self.position[first]:
                ends.append(self.word(LETTERS[second], target[second]))
        self.rows.append(f"{self.code(motion)}{' '.join(ends)} {words}{turns}{self.feed(motion)}")
        self.position = target

    def arc_by_centre(self, first, second):
        radius, begin = abs(self.value(0.5, 20)) + 0.05, self.random.uniform(0, 2 * math.pi)
        centre = [
            round(self.position[first] - radius * math.cos(begin), 4),
            round(self.position[second] - radius * math.sin(begin), 4),
        ]
        target = list(self.position)
        if self.random.random() < 0.8:
            angle = self.random.uniform(0, 2 * math.pi)
            target[first] = round(centre[0] + radius * math.cos(angle), 4)
            target[second] = round(centre[1] + radius * math.sin(angle), 4)
        offsets = []
        for axis, where in ((first, centre[0]), (second, centre[1])):
            offset = where if self.centre_absolute else where - self.position[axis]
            offsets.append(self.word(OFFSETS[axis], offset))
        return " ".join(offsets), target

    def arc_by_radius(self, first, second):
        target = list(self.position)
        target[first] = round(target[first] + self.value(-15, 15), 4)
        target[second] = round(target[second] + self.value(1, 15) + 0.1, 4)
        chord = math.dist((target[first], target[second]), (self.position[first], self.position[second]))
        radius = round(chord / 2 * self.random.uniform(1.001, 3) + 1e-4, 4)
        return self.word("R", self.random.choice([radius, radius, -radius])), target

    def select_plane(self, plane):
        self.rows.append(f"G{plane}")
        self.plane = plane

    def change_modes(self):
        choice = self.random.randint(0, 7)
        if choice == 0:
            self.select_plane(self.random.choice([17, 18, 19]))
        elif choice == 1:
            self.incremental = not self.incremental
            self.rows.append("G91" if self.incremental else "G90")
        elif choice == 2:
            self.centre_absolute = not self.centre_absolute
            self.rows.append("G90.1" if self.centre_absolute else "G91.1")
        elif choice == 3:
            self.inch = not self.inch
            self.state_unit()
            self.forget()
        elif choice == 4:
            self.inverse_time = not self.inverse_time
            self.rows.append("G93" if self.inverse_time else "G94 F200")
        else:
            self.rows.append(self.random.choice(["G61", "G64 P0.01", "G4 P0.1", "M8", "(note)", "M3 S500"]))

    def state_unit(self):
        """Without a length offset: rs274 alone leaves its figure as it is when the unit changes."""
        if self.tools:
            self.rows.append("G49")
        self.rows.append("G20" if self.inch else "G21")

    def change_frame(self):
        axes = [axis for axis in range(3) if self.random.random() < 0.6] or [0]
        words = " ".join(self.word(LETTERS[axis], self.value()) for axis in axes)
        system = self.random.randint(0, 9)
        turn = ""
        if self.random.random() < 0.3:
            self.turned = True
            turn = f" R{self.random.choice([0, 30, 45, 90, -120.5, 180, 12.345])}"
        self.rows.append(
            self.random.choice(
                [
                    f"G10 L2 P{system} {words}{turn}",
                    f"G10 L2 P{system} {words}{turn}",
                    f"G10 L20 P{system} {words}",
                    self.random.choice(SYSTEMS),
                    self.random.choice(SYSTEMS),
                    f"G92 {words}",
                    f"G92.{self.random.randint(1, 3)}",
                    f"G52 {words}",
                ]
            )
        )
        self.forget()

    def machine_move(self):
        axes = [axis for axis in range(3) if self.random.random() < 0.6] or [1]
        words = " ".join(self.word(LETTERS[axis], self.value()) for axis in axes)
        code = self.random.choice(["G28", "G30", "G53 G0", "G53 G1"])
        if code.startswith("G53"):
            if self.incremental:
                self.incremental = False
                self.rows.append("G90")
            self.motion = int(code[-1])
            self.rows.append(f"{code} {words}{self.feed(self.motion)}")
        elif self.random.random() < 0.3:
            self.rows.append(code + ".1")
        else:
            self.rows.append(f"{code} {words if self.random.random() < 0.7 else ''}".rstrip())
        self.forget()

    def change_tool(self):
        """A change goes before a stated place: rs274 alone, without a machine, forgets where it
        stands when the frame has changed since its last motion."""
        tool = self.random.randint(1, 3)
        if not self.tools or self.random.random() < 0.5:
            self.tools = True
            self.rows.append(self.random.choice([f"T{tool} M6", f"T{tool} M6 G43", f"T{tool}\nM6"]))
            self.go_to_known_place()
            return
        self.rows.append(
            self.random.choice([f"G43 H{tool}", "G43", "G49", f"G43.1 Z{self.text(self.value(0, 60))}"])
        )
        self.forget()

    def cycles(self):
        """A run of canned cycles, some words of which stay from block to block."""
        if self.inverse_time:
            self.rows.append("G94 F200")
            self.inverse_time = False
        self.go_to_known_place()
        code = self.random.choice([73, 81, 81, 82, 83, 85, 86, 88, 89, 87])
        if self.plane == 17 and self.random.random() < 0.15:
            code = self.random.choice([74, 84])  # LinuxCNC exchanges axes in the other planes
        level = self.random.choice(["", "G98 ", "G99 "])
        if code in (74, 84, 86, 87, 88):  # LinuxCNC wants to see the spindle turn
            self.rows.append("S900 M4" if code == 74 else "S900 M3")
        first, second, normal = PLANES[self.plane]
        for hole in range(self.random.randint(1, 4)):
            if hole and self.random.random() < 0.15:
                self.incremental = not self.incremental
                self.rows.append("G91" if self.incremental else "G90")
                stated = True
            else:
                stated = hole == 0
            words = [self.word(LETTERS[first], self.value(-20, 20)),
                     self.word(LETTERS[second], self.value(-20, 20))]
            if self.random.random() < 0.4:
                words.pop(self.random.randint(0, 1))
            if stated or self.random.random() < 0.2:
                clear = self.value(-5, 10)
                depth = round(self.value(0.5, 12) + 0.1, 4)
                bottom = -depth if self.incremental else clear - depth
                words += [self.word("R", clear), self.word(LETTERS[normal], bottom)]
                words += self.cycle_words(code, depth, bottom, first, second)
            if self.random.random() < 0.2 and code != 74:  # LinuxCNC does not repeat G74
                words.append(f"L{self.random.randint(1, 3)}")
            self.random.shuffle(words)
            start = level + f"G{code} " if stated or self.random.random() < 0.3 else ""
            self.rows.append(start + " ".join(words))
        self.rows.append(self.random.choice(["G80", "G0 " + self.word("Z", self.value())]))
        self.motion = None
        self.forget()

    def cycle_words(self, code, depth, bottom, first, second):
        words = []
        if code in (73, 83):
            words.append(self.word("Q", round(depth / self.random.uniform(0.7, 6) + 0.01, 4)))
        if code in (74, 82, 84, 86, 88, 89):
            words.append(f"P{self.random.randint(0, 5) / 10}")
        if code == 87:
            normal = 3 - first - second
            sides = {first: self.value(-3, 3), second: self.value(-3, 3),
                     normal: round(bottom + depth / 2, 4) if not self.incremental else round(depth / 2, 4)}
            words += [self.word(OFFSETS[axis], value) for axis, value in sorted(sides.items())]
        return words

    def compensated_contour(self):
        """A contour beside which the cutter is kept; it need not fit."""
        self.inverse_time = self.inverse_time and self.rows.append("G94 F200") is not None
        if self.plane == 19 or self.turned:
            self.select_plane(17)
        self.go_to_known_place()
        first, second, _ = PLANES[self.plane]
        unit = 1 / 25.4 if self.inch else 1.0
        radius = self.random.choice([0.5, 1, 2, 3, 4]) * unit
        heading = self.random.uniform(0, 2 * math.pi)
        side = self.random.choice([41, 42])
        self.rows.append(f"G{side}.1 D{2 * radius:.6f}")
        for leg in range(self.random.randint(2, 9)):
            heading += self.random.uniform(-1.9, 1.9)
            length = radius * self.random.uniform(1.5, 9) if leg else radius * self.random.uniform(1.2, 9)
            kind = self.random.random()
            if kind < 0.25 and leg:
                heading = self.compensated_arc(first, second, heading, length)
            elif kind < 0.32 and leg:
                self.rows.append(f"{self.code(1)}" + self.normal_step())
            else:
                target = list(self.position)
                target[first] = round(target[first] + length * math.cos(heading), 4)
                target[second] = round(target[second] + length * math.sin(heading), 4)
                self.compensated_line(target, self.random.choice([1, 1, 1, 1, 0]))
        self.leave_contour(first, second)

    def normal_step(self):
        normal = PLANES[self.plane][2]
        height = self.value(-5, 5)
        step = height - self.position[normal] if self.incremental else height
        self.position[normal] = height
        return self.word(LETTERS[normal], step)

    def compensated_line(self, target, motion):
        words = self.step_to(target) or [self.word("X", 0 if self.incremental else target[0])]
        self.rows.append(f"{self.code(motion)}{' '.join(words)}")
        self.position = target

    def compensated_arc(self, first, second, heading, radius):
        """An arc that begins along the heading, or nearly; the heading at its end."""
        motion = self.random.choice([2, 3])
        sign = 1 if motion == 3 else -1
        heading += self.random.choice([0, 0, 0.5, -0.5, 1.2])
        centre = [round(self.position[first] - sign * radius * math.sin(heading), 4),
                  round(self.position[second] + sign * radius * math.cos(heading), 4)]
        sweep = sign * self.random.uniform(0.2, 5)
        begin = math.atan2(self.position[second] - centre[1], self.position[first] - centre[0])
        target = list(self.position)
        target[first] = round(centre[0] + radius * math.cos(begin + sweep), 4)
        target[second] = round(centre[1] + radius * math.sin(begin + sweep), 4)
        offsets = [
            self.word(OFFSETS[axis], where if self.centre_absolute else where - self.position[axis])
            for axis, where in ((first, centre[0]), (second, centre[1]))
        ]
        ends = self.step_to(target)
        self.rows.append(f"{self.code(motion)}{' '.join(ends)} {' '.join(offsets)}")
        self.position = target
        return heading + sweep

    def leave_contour(self, first, second):
        self.rows.append("G40")
        target = list(self.position)
        target[first] = round(target[first] + self.value(-9, 9), 4)
        target[second] = round(target[second] + self.value(1, 9) + 0.1, 4)
        self.compensated_line(target, self.random.choice([0, 1]))

    def block(self):
        """Some statements more than once, or only if, or as a subroutine."""
        self.labels += 1
        self.depth += 1
        label = f"o{self.labels}"
        kind = self.random.choice(["repeat", "while", "if", "sub"])
        rows, self.rows = self.rows, []
        if kind != "if":  # every round has to begin alike
            self.reset_modes()
        self.motion = None
        self.forget()
        for _ in range(self.random.randint(1, 3)):
            self.statement()
        body, self.rows = self.rows, rows
        self.depth -= 1
        self.motion = None
        self.forget()
        self.enclose(kind, label, body)
        if kind != "if":
            self.reset_modes()

    def reset_modes(self):
        self.rows.append("G90 G17 G91.1 G94 F200")
        self.state_unit()
        self.incremental = self.centre_absolute = self.inverse_time = False
        self.plane = 17

    def enclose(self, kind, label, body):
        times, counter = self.random.randint(0, 3), 60 + self.labels
        if kind == "repeat":
            self.rows += [f"{label} repeat [{times}]", *body, f"{label} endrepeat"]
        elif kind == "while":
            self.rows += [f"#{counter}=0", f"{label} while [#{counter} lt {times}]", *body,
                          f"#{counter}=[#{counter}+1]", f"{label} endwhile"]
        elif kind == "if":
            self.rows += [f"{label} if [1 GT 0]", *body, f"{label} else", "G0 X999", f"{label} endif"]
        else:
            name = f"o<part{self.labels}>"
            self.subroutines += [f"{name} sub", *body, f"{name} endsub"]
            self.rows.append(f"{name} call [1] [2]")

    def statement(self):
        choices = [self.straight] * 6 + [self.arc] * 5 + [self.change_modes] * 2
        choices += [self.change_frame, self.machine_move, self.cycles, self.compensated_contour]
        if self.depth == 0:
            choices += [self.change_tool, self.block]
        self.random.choice(choices)()


def random_program(seed):
    """Program number `seed` and its tool table, empty where it needs none."""
    writer = Writer(seed)
    writer.rows.append("G21 G90 G17 G94 F200 (random)")
    writer.go_to_known_place()
    for _ in range(writer.random.randint(3, 25)):
        writer.statement()
    rows = writer.subroutines + writer.rows + ["M2"]
    return "\n".join(rows) + "\n", TABLE if writer.tools else ""
