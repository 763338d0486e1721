#!/usr/bin/env python3
"""examples_test.py PROGRAM SOURCE - the CI examples as they would run: their shell steps are taken out of
the YAML and run one after the other in a fresh checkout, with stand-ins for gh and curl that write down what
they are asked, and answer as the service would. A job gets worse in it, and better again."""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import yaml

STAND_IN = r'''#!/usr/bin/env python3
"""Answers for NAME; what it was called with goes into $CALLS, a JSON a line."""
import json, os, pathlib, shutil, sys
name, args = pathlib.Path(sys.argv[0]).name, sys.argv[1:]
service = pathlib.Path(os.environ['SERVICE'])
sent = [a.split('body@', 1)[-1].split('body=@', 1)[-1] for a in args if 'body@' in a or 'body=@' in a]
body = pathlib.Path(sent[0]).read_text() if sent else None
with open(os.environ['CALLS'], 'a') as log:
    log.write(json.dumps({'name': name, 'args': args, 'body': body}) + '\n')
kept = service / 'result.json'
if name == 'gh' and args[:2] == ['run', 'list']:
    print('4711' if kept.exists() else '')
elif name == 'gh' and args[:2] == ['run', 'download']:
    to = pathlib.Path(args[args.index('--dir') + 1]) / 'out'
    to.mkdir(parents=True)
    shutil.copy(kept, to / 'result.json')
elif name == 'gh' and args[0] == 'api':
    if body is None:
        print((service / 'comment-id').read_text() if (service / 'comment-id').exists() else '', end='')
elif name == 'curl' and '--output' in args and body is None:
    if not kept.exists():
        sys.exit(22)
    shutil.copy(kept, args[args.index('--output') + 1])
elif name == 'curl' and body is None:
    if (service / 'comment-id').exists():
        print('[{"id":9,"type":null,"body":"other"},{"id":12,"type":null,"body":"\\u003c!-- limitgauge --\\u003e"}]')
'''

FAILURES = []


def check(holds, what, context=''):
    if not holds:
        FAILURES.append(what)
        print(f'FAILED: {what}\n{context}', file=sys.stderr)


class Workshop:
    """A checkout with the job, and a service that has what earlier pipelines left."""

    def __init__(self, program, source, folder):
        self.folder = folder
        self.bin, self.work, self.service = folder / 'bin', folder / 'work', folder / 'service'
        for made in (self.bin, self.work / 'parts', self.service):
            made.mkdir(parents=True)
        for name in ('gh', 'curl'):
            (self.bin / name).write_text(STAND_IN)
            (self.bin / name).chmod(0o755)
        # Nothing is installed by a test: a tool that is missing must not be asked for.
        (self.bin / 'apt-get').write_text('#!/bin/sh\necho "apt-get was called" >&2\nexit 1\n')
        (self.bin / 'apt-get').chmod(0o755)
        (self.bin / 'limitgauge').symlink_to(program)
        fixtures = source / 'fixtures/foreign'
        (self.work / 'parts/plate.obj').write_text((fixtures / 'plate.obj').read_text())
        before, rough = (fixtures / 'plate.ngc').read_text().split('(ROUGH)')
        (self.work / 'parts/plate.ngc').write_text(before + rough.split('(FINISH)')[1])
        job = (fixtures / 'plate.toml').read_text().replace('0.25', '1')
        job += '[verification]\nresolution = 0.002\n[report]\npictures = false\n'
        stages = job.split('[[stage]]')
        job = '[[stage]]'.join([stages[0], stages[2]])  # the finish alone: it leaves nothing standing
        (self.work / 'parts/part.toml').write_text(job)

    def environment(self, more):
        kept = {k: v for k, v in os.environ.items() if k in ('HOME', 'LANG', 'TMPDIR')}
        return kept | {'PATH': f'{self.bin}:/usr/bin:/bin', 'SERVICE': str(self.service),
                       'CALLS': str(self.folder / 'calls')} | more

    def forget(self):
        """Another pipeline: a fresh checkout, a new list of calls."""
        for left in ('out', 'compare', 'base', 'base-result.json', 'comment.md', 'note.md'):
            subprocess.run(['rm', '-rf', str(self.work / left)], check=True)
        (self.folder / 'calls').write_text('')

    def calls(self):
        return [json.loads(line) for line in (self.folder / 'calls').read_text().splitlines()]

    def posted(self):
        return [c for c in self.calls() if c['body'] is not None]

    def keep_result(self):
        (self.service / 'result.json').write_text((self.work / 'out/result.json').read_text())

    def sink(self, depth):
        """The finish's inner rows, deeper by `depth`."""
        program = self.work / 'parts/plate.ngc'
        text = program.read_text()
        program.write_text(text.replace('N165 G1 Z0. F400.', f'N165 G1 Z-{depth} F400.'))


def expression(value, known):
    """What a runner puts for ${{ ... }}."""
    return re.sub(r'\$\{\{ *(.*?) *\}\}', lambda m: known[m.group(1)], str(value))


class GitHub:
    def __init__(self, source):
        self.flow = yaml.safe_load((source / 'examples/ci/github-actions.yml').read_text())
        self.steps = self.flow['jobs']['accuracy']['steps']
        for step in self.steps:
            if 'uses' in step:
                check(re.fullmatch(r'actions/[a-z-]+@[0-9a-f]{40}', step['uses']), 'actions are pinned', step['uses'])

    def run(self, shop, more=None, event='pull_request'):
        shop.forget()
        known = {'github.token': 'secret', 'github.repository': 'o/r', 'github.event.pull_request.number': '5',
                 'github.base_ref || github.ref_name': 'main'}
        settings = {k: expression(v, known) for k, v in self.flow['env'].items()} | (more or {})
        said, status = '', 0
        carried = shop.folder / 'github-env'
        carried.write_text('')
        summary = shop.folder / 'summary'
        summary.write_text('')
        for step in self.steps:
            if 'run' not in step or (status and step.get('if') != 'always()'):
                continue
            if step.get('if') == "github.event_name == 'pull_request'" and event != 'pull_request':
                continue
            lines = [line.split('=', 1) for line in carried.read_text().splitlines()]
            own = {k: expression(v, known) for k, v in step.get('env', {}).items()}
            env = shop.environment(settings | dict(lines) | own | {
                'GITHUB_ENV': str(carried), 'GITHUB_STEP_SUMMARY': str(summary)})
            done = subprocess.run(['bash', '--noprofile', '--norc', '-eo', 'pipefail', '-c', step['run']],
                                  cwd=shop.work, env=env, text=True, capture_output=True, timeout=300)
            said += f"== {step['name']}: {done.returncode}\n{done.stdout}{done.stderr}"
            status = status or done.returncode
        return status, said

    def is_update(self, call):
        return 'PATCH' in call['args']


class GitLab:
    def __init__(self, source):
        self.job = yaml.safe_load((source / 'examples/ci/gitlab-ci.yml').read_text())['limitgauge']

    def run(self, shop, more=None, event='pull_request'):
        shop.forget()
        settings = {k: str(v).replace('$CI_PROJECT_DIR', str(shop.work)) for k, v in self.job['variables'].items()}
        pipeline = {'CI_PROJECT_DIR': str(shop.work), 'CI_API_V4_URL': 'https://gl/api/v4', 'CI_PROJECT_ID': '3',
                    'CI_JOB_TOKEN': 'job', 'CI_COMMIT_BRANCH': 'main', 'LIMITGAUGE_TOKEN': 'secret'}
        if event == 'pull_request':
            pipeline |= {'CI_MERGE_REQUEST_IID': '5', 'CI_MERGE_REQUEST_TARGET_BRANCH_NAME': 'main'}
        script = '\n'.join(self.job['before_script'] + self.job['script'])
        done = subprocess.run(['bash', '-eo', 'pipefail', '-c', script], cwd=shop.work, text=True,
                              env=shop.environment(settings | pipeline | (more or {})), capture_output=True,
                              timeout=300)
        return done.returncode, done.stdout + done.stderr

    def is_update(self, call):
        return 'PUT' in call['args']


def try_service(name, service, program, source, folder):
    shop = Workshop(program, source, folder)
    status, said = service.run(shop, event='push')
    check(status == 0, f'{name}: the first run on the base branch passes', said)
    check(not shop.posted(), f'{name}: nothing is posted for a push', said)
    shop.keep_result()

    status, said = service.run(shop)
    check(status == 0, f'{name}: an unchanged job stays green', said)
    posts = shop.posted()
    check(len(posts) == 1, f'{name}: one comment is posted', said)
    body = posts[0]['body'] if posts else ''
    check(body.startswith('<!-- limitgauge -->\n### Limitgauge: plate'), f'{name}: the comment is marked', body)
    check('same: no figure changed' in body, f'{name}: the comment says that no figure changed', body)
    check(posts and not service.is_update(posts[0]), f'{name}: the first comment is a new one', said)

    # Within the gates, but worse: 5 µm of 10.
    shop.sink('0.005')
    (shop.service / 'comment-id').write_text('12\n')
    status, said = service.run(shop)
    check(status == 1, f'{name}: a regression is red', said)
    check('gates: 0, comparison: 1' in said, f'{name}: the gates pass, the comparison does not', said)
    posts = shop.posted()
    body = posts[0]['body'] if posts else ''
    check('| finish | gouge |' in body and '**worse**' in body, f'{name}: the comment names the figure', body)
    check(re.search(r'finish: deepest gouge .*line \d+', body), f'{name}: the comment names the line', body)
    check(posts and service.is_update(posts[0]), f'{name}: the comment is changed in place', said)

    # A result kept in the repository is taken in place of the service's.
    (shop.work / 'parts/part-baseline.json').write_text((shop.work / 'out/result.json').read_text())
    status, said = service.run(shop)
    check(status == 0, f'{name}: an approved baseline makes it green', said)
    check(not any('download' in c['args'] or '--output' in c['args'] and c['body'] is None and '/artifacts/' in
                  ' '.join(c['args']) for c in shop.calls()), f'{name}: nothing is fetched then', said)

    status, said = service.run(shop, {'JOB': 'parts/none.toml'})
    check(status in (1, 3) and 'there is no such file' in said, f'{name}: a job that cannot be read ends it', said)
    check(not shop.posted(), f'{name}: and posts nothing', said)


def main(program, source):
    source = pathlib.Path(source)
    for name, service in (('GitHub', GitHub(source)), ('GitLab', GitLab(source))):
        with tempfile.TemporaryDirectory() as folder:
            try_service(name, service, pathlib.Path(program).resolve(), source, pathlib.Path(folder))
    print(f'{len(FAILURES)} failures')
    return 1 if FAILURES else 0


sys.exit(main(*sys.argv[1:]))
