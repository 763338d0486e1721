"""What every scenario needs: the program, its conditions, and what may never be seen of it."""

import collections
import hashlib
import json
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import tempfile
import time

SOURCE = pathlib.Path(__file__).resolve().parents[2]
FIXTURES = SOURCE / 'fixtures'
JOB = FIXTURES / 'jobs/quick-dome.toml'

# A command that has not ended by then hangs.
MOST_TO_END = 600

# Of the standard library and of the libraries that the program is linked with, and of nobody else.
FOREIGN_WORDS = ('std::', 'terminate called', 'filesystem error', 'basic_string', 'vector::', 'stoi',
                 'Assertion', 'Sanitizer', 'internal error', 'what():')


class Fault(Exception):
    """Something was lost, mixed or left hanging."""


class Ended:
    """A command that has ended."""

    def __init__(self, code, out, errors, seconds):
        self.code, self.out, self.errors, self.seconds = code, out, errors, seconds


class Bench:
    """The program, the moments (a seed has them), the place, and the counts."""

    def __init__(self, program, seed, patience):
        self.random = random.Random(seed)
        self.most_to_stop = patience
        self.counts = collections.Counter()
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix='limitgauge-torture-'))
        self.folder.chmod(0o755)
        # What anybody may run and read, wherever the sources lie, and whoever builds there meanwhile.
        self.program = shutil.copy2(program, self.folder / 'limitgauge')
        self.job = self.copy('jobs', JOB)
        self.copy('cages', FIXTURES / 'cages/quick-dome.obj')
        self.number = 0

    def copy(self, name, file):
        folder = self.folder / name
        folder.mkdir(mode=0o755)
        return shutil.copyfile(file, folder / file.name)

    def fresh(self):
        """A folder of one try."""
        self.number += 1
        folder = self.folder / f'try-{self.number}'
        folder.mkdir()
        return folder

    def count(self, what):
        self.counts[what] += 1

    def start(self, folder, *words, before=None, out=subprocess.PIPE):
        return subprocess.Popen([self.program, *map(str, words)], cwd=folder, stdin=subprocess.DEVNULL,
                                stdout=out, stderr=subprocess.PIPE, preexec_fn=before)

    def end(self, process, most=MOST_TO_END):
        """Waits for a process and looks at how it ended; a hang and a crash are faults."""
        began = time.monotonic()
        try:
            out, errors = process.communicate(timeout=most)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            raise Fault(f'has not ended within {most} s: {process.args}') from None
        ended = Ended(process.returncode, text(out), text(errors), time.monotonic() - began)
        if ended.code < 0 and ended.code != -signal.SIGKILL:
            raise Fault(f'ended by signal {-ended.code}: {process.args}\n{ended.errors}')
        for word in FOREIGN_WORDS:
            if word in ended.errors:
                raise Fault(f'says "{word}": {process.args}\n{ended.errors}')
        return ended

    def run(self, folder, *words, before=None):
        return self.end(self.start(folder, *words, before=before))

    def stop(self, process, how):
        """Sends the signal; the process must end soon."""
        process.send_signal(how)
        return self.end(process, self.most_to_stop)

    def wait_a_while(self, process, most):
        """A random time, or until it has ended; true where it still runs."""
        try:
            process.wait(self.random.uniform(0, most))
            return False
        except subprocess.TimeoutExpired:
            return True

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)


def text(data):
    return (data or b'').decode('utf-8', 'replace')


def require(holds, what):
    if not holds:
        raise Fault(what)


def limit(what, most):
    """For `before`: in the process that becomes the program."""
    return lambda: resource.setrlimit(what, (most, most))


def names(folder):
    return sorted(os.listdir(folder))


def sums(folder):
    """SHA-256 of every file below `folder`, by its path, the manifest left out."""
    found = {}
    for file in sorted(pathlib.Path(folder).rglob('*')):
        if file.is_file() and file.name != 'manifest.sha256':
            found[str(file.relative_to(folder))] = hashlib.sha256(file.read_bytes()).hexdigest()
    return found


def require_whole(folder):
    """All that the manifest names, and nothing else."""
    stated = {}
    for line in (folder / 'manifest.sha256').read_text().splitlines():
        stated[line[66:]] = line[:64]
    require(stated == sums(folder), f'{folder} is not what its manifest says')


class Variants:
    """The same job with other step-overs: whose files are these?"""

    STEPS = ('0.4', '0.6', '0.8')

    def __init__(self, bench):
        self.sums, self.results = {}, {}
        for step in self.STEPS:
            folder = bench.fresh()
            ended = bench.run(folder, *self.command(step, 'out'))
            require(ended.code in (0, 1, 2), f'the job does not run: {ended.errors}')
            self.sums[step] = self.stage_sums(folder / 'out')
            self.results[step] = figures(folder / 'out')
            shutil.rmtree(folder)

    @staticmethod
    def command(step, output):
        return ['run', JOB, '-o', output, '--no-pictures', '--threads', '2', '--set', f'stage.finish.step={step}']

    @staticmethod
    def stage_sums(folder):
        return {name: value for name, value in sums(folder).items() if '/' in name}

    def require_of_one(self, folder):
        """Whole, and all of one variant."""
        require_whole(folder)
        found = self.stage_sums(folder)
        owners = [step for step in self.STEPS if self.sums[step] == found]
        require(owners, f'{folder} has stages of several runs')
        require(figures(folder) == self.results[owners[0]], f'{folder} has one run\'s stages and another\'s verdict')


def figures(folder):
    """What result.json says that no clock has a say in."""
    stages = json.loads((folder / 'result.json').read_text())['stages']
    return [[stage['verdict'], stage['deviation']['gouge_mm'], stage['deviation']['uncut_mm'],
             stage['toolpath']['moves']] for stage in stages]
