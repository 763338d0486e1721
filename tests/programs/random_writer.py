"""What random programs are made of: numbers, places, straight moves and arcs."""

import math
import random

LETTERS = "XYZ"
OFFSETS = "IJK"
PLANES = {17: (0, 1, 2), 18: (2, 0, 1), 19: (1, 2, 0)}


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

    def polar_words(self):
        """X and Y by distance and angle, either, or both; the tool may stand anywhere but at the origin."""
        turn = self.random.choice([0, 30, 90, -45, 360 / 7, 200, -400])
        words = [f"^{turn:.6f}"] if self.random.random() < 0.7 else []
        if not words or self.random.random() < 0.6:
            words.insert(0, self.word("@", self.value(-3, 12) if self.incremental else self.value(1, 30)))
        return " ".join(words)

    def polar(self):
        if self.plane != 17:
            self.select_plane(17)
        if self.position is None or math.hypot(*self.position[:2]) < 1e-3:
            self.position = [7.25, -3.5, 1.0]
            self.rows.append("G90 G0 X7.25 Y-3.5 Z1")
            self.incremental, self.motion = False, 0
        motion = self.random.choice([0, 1, 1])
        self.rows.append(f"{self.code(motion)}{self.polar_words()}{self.feed(motion)}")
        self.forget()

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
