"""Files as they come out of broken disks, broken programs and bad intentions."""

INTERESTING = (b'', b'0', b'-1', b'1e17', b'1e308', b'nan', b'-inf', b'0x10', b'99999999999999999999', b'\x00',
               b'\xff\xfe', b'\x1b[31m', b'"', b'[', b'\n', b'\r\n', b'#', b'%', b'../', b'\xc2\x9b')


def flip(random, data):
    at = random.randrange(len(data))
    data[at] ^= 1 << random.randrange(8)


def cut(random, data):
    del data[random.randrange(len(data)):]


def drop(random, data):
    at = random.randrange(len(data))
    del data[at:at + random.randrange(1, 64)]


def repeat(random, data):
    at = random.randrange(len(data))
    data[at:at] = data[at:at + random.randrange(1, 256)]


def move(random, data):
    at, length = random.randrange(len(data)), random.randrange(1, 128)
    piece = data[at:at + length]
    del data[at:at + length]
    to = random.randrange(len(data) + 1)
    data[to:to] = piece


def put(random, data):
    at = random.randrange(len(data) + 1)
    data[at:at + random.randrange(0, 8)] = random.choice(INTERESTING)


def extreme(random, data):
    """A length or a count as the largest number of its kind."""
    at = random.randrange(len(data))
    data[at:at + 4] = random.choice((b'\xff\xff\xff\xff', b'\xff\xff\xff\x7f', b'\x00\x00\x00\x80'))


def mutated(random, content):
    """One to four of these, one after the other."""
    data = bytearray(content)
    for _ in range(random.randrange(1, 5)):
        if data:
            random.choice((flip, flip, cut, drop, repeat, move, put, put, extreme))(random, data)
    return bytes(data)
