#!/usr/bin/env python3
"""The tools that hold the pages against the program must find what is wrong with a page."""

import pathlib
import sys
import tempfile
import textwrap
import unittest

import check_links
from inline_commands import wrong_inline_commands
from pages import PageError, read_blocks
from run_commands import make_workshop, work_through

HELP = '#!/bin/sh\n[ "$1" = run ] || [ "$1" = --help ] || exit 3\necho "  --set  --force"\n'
TESTS = '#!/bin/sh\ncase $2 in good*) echo "1 matching test case";; *) echo "0 matching test cases";; esac\n'


def write_script(file, text):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    file.chmod(0o755)


class Bench(unittest.TestCase):
    """A source tree and a build that hold next to nothing."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        top = pathlib.Path(scratch.name).resolve()
        self.source, self.build, self.work = top / 'source', top / 'build', top / 'work'
        for folder in (self.source / 'tests', self.build, self.work):
            folder.mkdir(parents=True)
        (self.source / 'tests' / 'there.sh').write_text('')
        write_script(self.build / 'limitgauge', HELP)
        write_script(self.build / 'tests' / 'own' / 'test_own', TESTS)
        make_workshop(self.work, self.source, self.build)

    def page(self, text):
        file = self.source / 'page.md'
        file.write_text(textwrap.dedent(text), encoding='utf-8')
        return file

    def run_page(self, text):
        work_through(self.page(text), self.work)

    def refused(self, text, why):
        with self.assertRaisesRegex(PageError, why):
            self.run_page(text)


class Commands(Bench):
    def test_a_page_in_order(self):
        self.run_page('''
            `a.txt`:

            ```text
            one
            two
            ```

            ```sh
            cat a.txt
            build/release/limitgauge run
            ```

            <!-- prints -->
            ```text
            t…o
              --set …
            ```

            <!-- exit: 3 -->
            ```sh
            build/release/limitgauge \\
                bad
            ```

            <!-- not run: waits for somebody -->
            ```sh
            exit 7
            ```

            <!-- until interrupted -->
            ```sh
            python3 -c 'import signal, sys; signal.signal(2, lambda *a: sys.exit(0)); signal.pause()'
            ```

            <!-- same as: tests/there.sh -->
            ```python
            ```
            ''')
        self.assertEqual((self.work / 'a.txt').read_text(), 'one\ntwo\n')

    def test_exit_codes(self):
        self.refused('```sh\nfalse\n```\n', 'page.md:1: ended with 1')
        self.refused('```sh\nfalse\ntrue\n```\n', 'ended with 1')
        self.refused('```sh\nfalse | true\n```\n', 'ended with 1')
        self.refused('<!-- exit: 1 -->\n```sh\ntrue\n```\n', 'ended with 0')
        self.refused('<!-- exit: 1 -->\n```sh\ntrue\nfalse\n```\n', 'one command')

    def test_commands_that_do_not_wait(self):
        self.refused('<!-- until interrupted -->\n```sh\ntrue\n```\n', 'ended with -1')

    def test_what_was_not_printed(self):
        block = '```sh\necho one\n```\n<!-- prints -->\n```text\n'
        self.refused(block + 'two\n```\n', 'not printed: two')
        self.refused(block + 'on\n```\n', 'not printed: on')

    def test_files(self):
        self.refused('`tests/there.sh`:\n```text\n1\n```\n', 'into the source tree')
        self.refused('<!-- same as: tests/there.sh -->\n```python\n1\n```\n', 'is not what')
        self.refused('`a.txt`:\n```sh\ntrue\n```\n', 'where a file was announced')

    def test_annotations(self):
        self.refused('<!-- exits: 1 -->\n```sh\ntrue\n```\n', 'unknown annotation')
        self.refused('<!-- exit: one -->\n```sh\ntrue\n```\n', 'unknown annotation')
        self.refused('<!-- not run: -->\n```sh\ntrue\n```\n', 'unknown annotation')
        self.refused('<!-- exit: 1 -->\ntext\n```sh\ntrue\n```\n', 'no block')
        self.refused('<!-- exit: 1 -->\n```text\n1\n```\n', 'before something else')
        self.refused('<!-- exit: 1 -->', 'not finished')

    def test_blocks(self):
        self.refused('```\n./demo.sh\n```\n', 'needs one of the languages')
        self.refused('```sh\ntrue\n', 'not finished')
        self.assertEqual([b.language for b in read_blocks(self.page('```sh\n```\n```toml\n```\n'))],
                         ['sh', 'toml'])


class CommandsInText(Bench):
    def wrong(self, text):
        return wrong_inline_commands(self.page(text), self.source, self.build)

    def test_what_exists(self):
        self.assertEqual(self.wrong('`limitgauge run A --set a=1`, `limitgauge COMMAND --help`'), [])
        self.assertEqual(self.wrong('`A=1 build/release/tests/own/test_own\n"good one*"`'), [])
        self.assertEqual(self.wrong('`tests/there.sh`, `anything else`, `--set`'), [])

    def test_what_does_not(self):
        for command in ('limitgauge fly', 'limitgauge run --sett a', 'test_own "bad*"', 'test_none "x"',
                        'tests/missing.sh'):
            self.assertEqual(len(self.wrong(f'one\n`{command}`')), 1, command)
            self.assertIn('page.md:2', self.wrong(f'one\n`{command}`')[0])


class Links(Bench):
    def wrong(self, text):
        (self.source / 'other.md').write_text('# A heading, with `code`\n# Twice\n# Twice\n')
        return check_links.wrong_links(self.page(text), self.source)

    def test_what_exists(self):
        good = ('[a](other.md) [b](other.md#a-heading-with-code) [c](other.md#twice-1) [d](tests) '
                '<img src="tests/there.sh"> [e](https://example.org/x) `[f](none)`\n'
                '# Own\n[g](#own)')
        self.assertEqual(self.wrong(good), ([], 6))

    def test_what_does_not(self):
        for link in ('[a](none.md)', '[a](other.md#none)', '[a](#none)', '<img src="none.png">',
                     '![a](none.png)', '[a](../outside)', '[a](other.md#twice-2)'):
            self.assertEqual(len(self.wrong(link)[0]), 1, link)


if __name__ == '__main__':
    sys.exit(unittest.main())
