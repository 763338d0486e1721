"""Reads the Markdown pages of the documentation: fenced blocks with what is said of them."""

import dataclasses
import pathlib
import re

COMMENT = re.compile(r'<!--\s*(.*?)\s*-->')
FENCE = re.compile(r'^```([A-Za-z]*)\s*$')
FILE_LINE = re.compile(r'^`([\w.-]+(?:/[\w.-]+)*)`:$')

LANGUAGES = {'sh', 'text', 'toml', 'obj', 'gcode', 'python', 'yaml', 'json', 'xml', 'csv', 'cpp', 'cmake'}


class PageError(Exception):
    """What is wrong with a page, with its line."""


@dataclasses.dataclass
class Block:
    line: int  # of the opening fence, from 1
    language: str
    text: str
    notes: dict  # of the comments before it, see run_commands.py
    file: str | None  # the name on the line before it


def parse_note(comment, where):
    """`exit: 1` and the like; whatever is unknown is an error, so that no slip goes unseen."""
    key, _, value = comment.partition(':')
    value = value.strip()
    known = {'exit': value.isdigit(), 'not run': len(value) > 10,
             'until interrupted': value == '', 'prints': value == '', 'same as': value != ''}
    if not known.get(key.strip()):
        raise PageError(f'{where}: unknown annotation "{comment}"')
    return key.strip(), value


def read_blocks(page: pathlib.Path):
    """The fenced blocks of a page, in order."""
    blocks, notes, file, block = [], {}, None, None
    for number, line in enumerate(page.read_text(encoding='utf-8').splitlines(), 1):
        where = f'{page.name}:{number}'
        fence = FENCE.match(line)
        if block is not None:
            if line.rstrip() == '```':
                blocks.append(block)
                block = None
            else:
                block.text += line + '\n'
        elif line.startswith('```'):
            if not fence or fence[1] not in LANGUAGES:
                raise PageError(f'{where}: a block needs one of the languages {sorted(LANGUAGES)}')
            block = Block(number, fence[1], '', notes, file)
            notes, file = {}, None
        elif COMMENT.fullmatch(line.strip()):
            key, value = parse_note(COMMENT.fullmatch(line.strip())[1], where)
            notes[key] = value
        elif '<!--' in line:
            raise PageError(f'{where}: a comment beside text: annotations stand on lines of their own')
        elif line.strip():
            if notes:
                raise PageError(f'{where}: an annotation before something that is no block')
            file = FILE_LINE.match(line.strip())[1] if FILE_LINE.match(line.strip()) else None
    if block is not None or notes:
        raise PageError(f'{page.name}: a block or an annotation at the end is not finished')
    return blocks


def prose(page: pathlib.Path):
    """The lines outside of blocks, with their numbers."""
    inside = False
    for number, line in enumerate(page.read_text(encoding='utf-8').splitlines(), 1):
        if line.startswith('```'):
            inside = not inside
        elif not inside:
            yield number, line
