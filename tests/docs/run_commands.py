#!/usr/bin/env python3
"""Runs the commands of one page of the documentation as a reader would, from top to bottom.

The page's ```sh blocks run in a fresh folder in which everything of the source tree is reachable under
its own name, and build/release is the build under test. A block that follows a line like `part.obj`: is
written to that file instead. Comments before a block say what differs:

    <!-- exit: 1 -->             the block is one command, and ends with this code
    <!-- until interrupted -->   the block is one command that waits: it is interrupted, and must end well
    <!-- not run: REASON -->     why a test cannot run it
    <!-- prints -->              a ```text block: each of its lines was printed by the last ```sh block;
                                 … stands for anything
    <!-- same as: FILE -->       a block of any other language: it is that file, word for word

Commands within the text are looked at, too: see inline_commands.py.
"""

import argparse
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

from inline_commands import wrong_inline_commands
from pages import PageError, read_blocks

BLOCK_SECONDS = 300
BEFORE_INTERRUPT_SECONDS = 2


def make_workshop(folder: pathlib.Path, source: pathlib.Path, build: pathlib.Path):
    for entry in source.iterdir():
        if entry.name != 'build' and not entry.name.startswith('.'):
            (folder / entry.name).symlink_to(entry)
    (folder / 'build').mkdir()
    (folder / 'build' / 'release').symlink_to(build)


def logical_lines(text):
    lines = text.replace('\\\n', ' ').splitlines()
    return [line for line in lines if line.strip() and not line.lstrip().startswith('#')]


def environment():
    """The reader's own, but for the display: no test is to open a browser on it."""
    return {k: v for k, v in os.environ.items() if k not in ('DISPLAY', 'WAYLAND_DISPLAY')}


def run_block(block, folder):
    """Exit code and all that was printed."""
    done = subprocess.run(['bash', '-eo', 'pipefail', '-c', block.text], cwd=folder, env=environment(),
                          text=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=BLOCK_SECONDS, check=False)
    return done.returncode, done.stdout


def run_until_interrupted(block, folder):
    """As if the reader pressed Ctrl-C; ending on its own is no waiting."""
    process = subprocess.Popen(['bash', '-c', 'exec ' + block.text.replace('\\\n', ' ')], cwd=folder,
                               text=True, env=environment(), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, start_new_session=True)
    time.sleep(BEFORE_INTERRUPT_SECONDS)
    if process.poll() is not None:
        return -1, process.communicate()[0] + '\nended before it was interrupted'
    os.kill(process.pid, signal.SIGINT)
    try:
        printed, _ = process.communicate(timeout=10)
    except subprocess.TimeoutExpired:
        process.kill()
        return -1, process.communicate()[0] + '\ndid not end when it was interrupted'
    return process.returncode, printed


def missing_lines(text, printed):
    """Lines of `text` that were not printed, blanks aside."""
    lines = [' '.join(line.split()) for line in printed.splitlines()]
    missing = []
    for wanted in text.splitlines():
        pattern = '.*'.join(re.escape(part) for part in ' '.join(wanted.split()).split('…'))
        if wanted.strip() and not any(re.fullmatch(pattern, line) for line in lines):
            missing.append(wanted)
    return missing


def require_form(block):
    """What can be wrong with a block before it runs."""
    if block.language == 'sh' and block.file:
        raise PageError('a command where a file was announced')
    if 'same as' in block.notes and block.language == 'sh':
        raise PageError('"same as" is for what is not run')
    if 'prints' in block.notes and block.language != 'text':
        raise PageError('"prints" is for text')
    if block.language != 'sh' and set(block.notes) - {'prints', 'same as'}:
        raise PageError('an annotation for commands before something else')
    alone = block.notes.get('exit', '0') != '0' or 'until interrupted' in block.notes
    if alone and len(logical_lines(block.text)) != 1:
        raise PageError('a block that ends so must hold one command')


def write_file(block, folder):
    file = folder / block.file
    if file.parent.resolve() != file.parent or file.is_symlink():
        raise PageError(f'{block.file} would be written into the source tree')
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(block.text, encoding='utf-8')


def require_same(block, folder):
    file = folder / block.notes['same as']
    if not file.is_file() or file.read_text(encoding='utf-8') != block.text:
        raise PageError(f'is not what {block.notes["same as"]} is')


def work_through(page, folder):
    printed = ''
    for block in read_blocks(page):
        try:
            require_form(block)
            if 'same as' in block.notes:
                require_same(block, folder)
            elif block.file:
                write_file(block, folder)
            elif 'prints' in block.notes:
                missing = missing_lines(block.text, printed)
                if missing:
                    raise PageError('not printed: ' + '\n'.join(missing) + '\nbut:\n' + printed)
            elif block.language == 'sh' and 'not run' in block.notes:
                print(f'{page.name}:{block.line}: not run: {block.notes["not run"]}')
            elif block.language == 'sh':
                run = run_until_interrupted if 'until interrupted' in block.notes else run_block
                code, printed = run(block, folder)
                print(f'{page.name}:{block.line}:\n{block.text}{printed}')
                if code != int(block.notes.get('exit', 0)):
                    raise PageError(f'ended with {code}')
        except PageError as error:
            raise PageError(f'{page.name}:{block.line}: {error}') from None


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('page', type=pathlib.Path)
    parser.add_argument('--source', type=pathlib.Path, required=True, help='top of the source tree')
    parser.add_argument('--build', type=pathlib.Path, required=True, help='the build under test')
    options = parser.parse_args()
    source, build = options.source.resolve(), options.build.resolve()
    with tempfile.TemporaryDirectory(prefix='limitgauge-docs-') as name:
        folder = pathlib.Path(name).resolve()
        make_workshop(folder, source, build)
        try:
            work_through(options.page, folder)
            wrong = wrong_inline_commands(options.page, source, build)
        except PageError as error:
            wrong = [str(error)]
    for line in wrong:
        print(line, file=sys.stderr)
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
