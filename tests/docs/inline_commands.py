"""Looks at the commands within the text of a page: what they name must exist.

    `tests/defects.sh`                      the script is there
    `test_simulator "removed volume*"`      the test program is built and has such tests
    `limitgauge inspect P.ngc --moves`      the command has these options
"""

import functools
import re
import shlex
import subprocess

from pages import prose

TEST = re.compile(r'^(?:build/release/tests/\w+/)?test_(\w+)$')
SCRIPT = re.compile(r'^(?:\./|tests/)[\w./-]+\.(?:sh|py)$')
ASSIGNMENT = re.compile(r'^[A-Z_]+=\S*$')
PROGRAMS = {'limitgauge', 'build/release/limitgauge'}


def printed_by(*command):
    done = subprocess.run(command, text=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, check=False)
    return done.returncode, done.stdout


@functools.cache
def help_of(program, command):
    code, text = printed_by(program, *([command] if command else []), '--help')
    return text if code == 0 else None


def wrong_test(words, name, build):
    # A room may hold more than the executable of its own name.
    program = next(build.glob(f'tests/*/test_{name}'), None)
    if program is None:
        return f'there is no test_{name} in {build / "tests"}'
    code, text = printed_by(program, '--list-tests', *words[1:])
    if code not in (0, 255) and 'matching test case' not in text:
        return f'ended with {code}: {text}'
    count = re.search(r'^(\d+) (?:matching )?test case', text, re.MULTILINE)
    return None if count and int(count[1]) > 0 else 'no such test'


def wrong_program(words, build):
    command = words[1] if len(words) > 1 and not words[1].startswith('-') else ''
    if command == 'COMMAND':
        return None
    text = help_of(build / 'limitgauge', command)
    if text is None:
        return f'no command {command}'
    options = [word.partition('=')[0] for word in words[1:] if word.startswith('-')]
    missing = [option for option in options if not re.search(rf'(?<![\w-]){option}(?![\w-])', text)]
    return f'no option {", ".join(missing)}' if missing else None


def wrong_command(words, source, build):
    """What is wrong with one command, None where nothing is, or where it is none."""
    while words and ASSIGNMENT.match(words[0]):
        words = words[1:]
    if not words:
        return None
    if TEST.match(words[0]):
        return wrong_test(words, TEST.match(words[0])[1], build)
    if words[0] in PROGRAMS:
        return wrong_program(words, build)
    if SCRIPT.match(words[0]) and not (source / words[0]).is_file():
        return 'no such script'
    return None


def split(code):
    try:
        return shlex.split(code)
    except ValueError:
        return []


def wrong_inline_commands(page, source, build):
    wrong = []
    # A command may be broken over two lines of text.
    lines = list(prose(page))
    text = '\n'.join(line for _, line in lines)
    for match in re.finditer(r'`([^`]+)`', text):
        what = wrong_command(split(' '.join(match[1].split())), source, build)
        if what:
            number = lines[text[:match.start()].count('\n')][0]
            wrong.append(f'{page.name}:{number}: `{match[1]}`: {what}')
    return wrong
