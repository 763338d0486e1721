"""Random RS274/NGC expressions that have a value, and the same one in every interpreter."""

LOGICAL = ["EQ", "NE", "LT", "LE", "GT", "GE", "AND", "OR", "XOR"]


def random_expression(random, depth=0):
    """A value in brackets or without; never near where it jumps, save by a very rare accident."""
    if depth > 3 or random.random() < 0.25:
        return f"{random.uniform(0, 9):.{random.randint(0, 3)}f}"
    kind = random.random()
    inner = [random_expression(random, depth + 1) for _ in range(random.randint(2, 4))]
    if kind < 0.4:
        return operators(random, inner)
    if kind < 0.55:  # whole numbers only: how near is equal differs between versions
        left, right = (f"ROUND[{value}]" for value in inner[:2])
        return f"[{left} {random.choice(LOGICAL)} {right}]"
    return function(random, inner[0], inner[1])


def operators(random, values):
    text = values[0]
    for value in values[1:]:
        operator = random.choice(["+", "-", "*", "+", "-", "/", "MOD", "**"])
        if operator == "/":
            value = f"[ABS[{value}]+1]"
        elif operator == "MOD":
            value = f"[ABS[{value}]+3]"
        elif operator == "**":
            value = str(random.choice([0, 1, 2]))
        text += random.choice([" ", ""]) + f"{operator} {value}"
    return f"[{text}]"


def function(random, value, other):
    return random.choice(
        [
            f"ABS[{value}]", f"SQRT[ABS[{value}]]", f"LN[ABS[{value}]+1]", f"EXP[SIN[{value}]]",
            f"SIN[{value}]", f"cos[{value}]", f"TAN[ATAN[{value}]/[2]]", f"ATAN[{value}]/[{other}]",
            f"ASIN[SIN[{value}]*0.9]", f"ACOS[COS[{value}]*0.9]", f"FIX[{value}+0.31]",
            f"FUP[{value}-0.37]", f"ROUND[{value}+0.23]", f"[-{value}]", f"[+{value}]",
        ]
    )  # fmt: skip
