"""Random programs that are valid, or nearly so: what two interpreters are compared on.

Every program is its seed's alone. Where a state makes the tool's place in the work frame hard to
know (a new offset, a loop), the generator forgets it and goes to a stated place before it needs it.
"""

import math

from random_values import random_expression
from random_writer import LETTERS, OFFSETS, PLANES, Writer

SYSTEMS = ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"]
TABLE = "T1 P1 Z40 D6\nT2 P2 Z62.5 D8\nT3 P3 Z35.25 D3\n"


class ProgramWriter(Writer):
    """Statements of every kind, by chance."""

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
            self.rows.append("G92.1")  # LinuxCNC loses its place otherwise, Limitgauge refuses it
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
            if self.plane == 17 and self.random.random() < 0.1:
                words = [self.polar_words()]
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
        number = self.labels
        kinds = ["repeat", "while", "do", "if", "else"] + ["sub"] * (self.depth == 1)
        kind = self.random.choice(kinds)
        rows, self.rows = self.rows, []
        if kind not in ("if", "else"):  # every round has to begin alike
            self.reset_modes()
        self.motion = None
        self.forget()
        for _ in range(self.random.randint(1, 3)):
            self.statement()
        body, self.rows = self.rows, rows
        self.depth -= 1
        self.motion = None
        self.forget()
        self.enclose(kind, number, body)
        if kind not in ("if", "else"):
            self.reset_modes()

    def reset_modes(self):
        self.rows.append("G90 G17 G91.1 G94 F200")
        self.state_unit()
        self.incremental = self.centre_absolute = self.inverse_time = False
        self.plane = 17

    def enclose(self, kind, number, body):
        label, counter, times = f"o{number}", 60 + number, self.random.randint(0, 3)
        if kind == "repeat":
            self.rows += [f"{label} repeat [{times}]", *body, f"{label} endrepeat"]
        elif kind == "while":
            self.rows += [f"#{counter}=0", f"{label} while [#{counter} lt {times}]", *body,
                          f"#{counter}=[#{counter}+1]", f"{label} endwhile"]
        elif kind == "do":
            self.rows += [f"#{counter}=0", f"{label} do", *body, f"#{counter}=[#{counter}+1]",
                          f"{label} while [#{counter} lt {times}]"]
        elif kind == "if":
            self.rows += [f"{label} if [1 GT 0]", *body, f"{label} else", "G0 X999", f"{label} endif"]
        elif kind == "else":
            self.rows += [f"{label} if [{times} GT 5]", "G0 X998", f"{label} elseif [{times} LT 5]",
                          *body, f"{label} endif"]
        else:
            name = f"o<part{number}>"
            self.subroutines += [f"{name} sub", *body, f"{name} endsub"]
            self.rows.append(f"{name} call [1] [2]")

    def calculation(self):
        """A place that is calculated, by way of a parameter or at once."""
        axis = self.random.choice(LETTERS)
        text = random_expression(self.random)
        while len(text) > 150:  # LinuxCNC's lines end at 255
            text = random_expression(self.random)
        text = f"[{text}] MOD 40"
        if self.random.random() < 0.5:
            name = self.random.choice(["#30", "#4000", "#<value>", "#<_Global Value>"])
            self.rows.append(f"{name} = [{text}]")
            text = name
        self.rows.append(f"{self.code(0)}{axis}[{text}]")
        self.forget()

    def statement(self):
        choices = [self.straight] * 6 + [self.arc] * 5 + [self.change_modes] * 2
        choices += [self.change_frame, self.machine_move, self.cycles, self.compensated_contour]
        choices += [self.calculation, self.polar]
        if self.depth == 0:
            choices += [self.change_tool, self.block]
        if self.depth == 1:
            choices.append(self.block)
        self.random.choice(choices)()


def random_program(seed):
    """Program number `seed` and its tool table, empty where it needs none."""
    writer = ProgramWriter(seed)
    writer.rows.append("G21 G90 G17 G94 F200 (random)")
    writer.go_to_known_place()
    for _ in range(writer.random.randint(3, 25)):
        writer.statement()
    rows = writer.subroutines + writer.rows + ["M2"]
    return "\n".join(rows) + "\n", TABLE if writer.tools else ""
