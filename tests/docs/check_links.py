#!/usr/bin/env python3
"""Every relative link, anchor and image of the pages leads somewhere.

With --installed, only those to pages and pictures count: others lead into the source tree, which is not there.
"""

import argparse
import pathlib
import re
import sys
import urllib.parse

from pages import prose

LINK = re.compile(r'\]\(([^)\s]+)\)')
IMAGE = re.compile(r'(?:src|href)="([^"]+)"')
CODE = re.compile(r'`[^`]*`')
PAGES_AND_PICTURES = ('.md', '.png', '.jpg', '.svg')
OUTSIDE = ('http://', 'https://', 'mailto:')


def anchor_of(heading):
    """As GitHub makes them: small letters, no punctuation, hyphens for blanks."""
    text = re.sub(r'\[([^\]]*)\]\([^)]*\)', r'\1', heading).strip().lower()
    return re.sub(r'[^\w\- ]', '', text).replace(' ', '-')


def anchors(page):
    found = {}
    for _, line in prose(page):
        if not re.match(r'#{1,6} ', line):
            continue
        anchor = anchor_of(line.lstrip('#'))
        found[anchor] = found.get(anchor, -1) + 1
    return {a if n == 0 else f'{a}-{n}' for a, last in found.items() for n in range(last + 1)}


def text_outside_code(page):
    """Lines without what stands in backquotes; a span over two lines is taken out as well."""
    lines = list(prose(page))
    text = '\n'.join(line for _, line in lines)
    blank = CODE.sub(lambda m: re.sub(r'[^\n]', ' ', m[0]), text)
    return zip((number for number, _ in lines), blank.split('\n'))


def wrong_target(target, page, top):
    path, _, anchor = urllib.parse.unquote(target).partition('#')
    file = (page.parent / path).resolve() if path else page
    if not file.is_relative_to(top):
        return 'leads out of the source tree'
    if not file.exists():
        return 'is not there'
    if anchor and file.suffix == '.md' and anchor not in anchors(file):
        return 'has no such heading'
    return None


def wrong_links(page, top, installed=False):
    wrong, count = [], 0
    for number, line in text_outside_code(page):
        for target in LINK.findall(line) + IMAGE.findall(line):
            if target.startswith(OUTSIDE):
                continue
            if installed and not target.partition('#')[0].endswith(PAGES_AND_PICTURES):
                continue
            count += 1
            what = wrong_target(target, page, top)
            if what:
                wrong.append(f'{page.relative_to(top)}:{number}: {target} {what}')
    return wrong, count


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('source', type=pathlib.Path, help='top of the source tree')
    parser.add_argument('--installed', action='store_true', help='it is share/doc/limitgauge')
    options = parser.parse_args()
    top = options.source.resolve()
    pages = sorted(p for p in top.rglob('*.md')
                   if not {'build', 'node_modules'} & set(p.relative_to(top).parts))
    wrong, count = [], 0
    for page in pages:
        found, links = wrong_links(page, top, options.installed)
        wrong += found
        count += links
    print(f'{len(pages)} pages, {count} links')
    for line in wrong:
        print(line, file=sys.stderr)
    return 1 if wrong or count == 0 else 0


if __name__ == '__main__':
    sys.exit(main())
