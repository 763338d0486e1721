"""What is done to the program, a try a call."""

import os
import resource
import shutil
import signal
import socket
import sqlite3
import subprocess
import time

from bench import FIXTURES, JOB, limit, names, require, require_whole

STUDY = FIXTURES / 'studies/quick-dome.toml'
RUN = ['run', JOB, '-o', 'out', '--no-pictures', '--threads', '2']
# Processes of nobody, whom limits hold that do not hold root.
NOBODY = 65534


def stopping_commands(bench, result):
    """Each of the commands, with the seconds that it may take."""
    return bench.random.choice([
        (RUN, 3), (['plan', JOB, '-o', 'out', '--threads', '2'], 1),
        (['run', FIXTURES / 'jobs/aircraft.toml', '-o', 'out', '--no-pictures'], 30),
        (['verify', '--cage', FIXTURES / 'cages/quick-dome.obj', '--stock', 'box:26,26,9@-13,-13,-4', '--tool',
          'flat:D=6', '--program', result / 'rough/toolpath.ngc', '-o', 'out'], 3),
        (['study', STUDY, '-o', 'out', '--cache', 'cache'], 15),
        (['inspect', FIXTURES / 'cages/aircraft.obj'], 0.5),
        (['compare', result, result, '-o', 'out'], 0.2),
        (['view', result, '--no-browser'], 1)])


class Scenarios:
    """The tries by name. Each cleans up after itself unless it finds a fault."""

    def __init__(self, bench, variants, readers):
        self.bench, self.variants, self.readers = bench, variants, readers

    def kill(self):
        bench, folder = self.bench, self.bench.fresh()
        command = bench.random.choice([RUN, RUN, ['plan', JOB, '-o', 'out'],
                                       ['study', STUDY, '-o', 'out', '--cache', bench.folder / 'kill-cache']])
        process = bench.start(folder, *command)
        killed = bench.wait_a_while(process, 4)
        process.kill()
        process.communicate()
        bench.count('kill killed' if killed else 'kill ended before')
        if (folder / 'out').exists():
            require_whole(folder / 'out')
        time.sleep(0.3)  # Workers of a study follow it.
        step = bench.random.choice(self.variants.STEPS)
        ended = bench.run(folder, *self.variants.command(step, 'next'))
        require(ended.code in (0, 1, 2), f'the next run in {folder} fails: {ended.errors}')
        self.variants.require_of_one(folder / 'next')
        require([n for n in names(folder) if n.startswith('.')] == [], f'leftovers in {folder}: {names(folder)}')
        shutil.rmtree(folder)

    def stop(self):
        bench, folder = self.bench, self.bench.fresh()
        command, most = stopping_commands(bench, self.readers.folder / 'out')
        process = bench.start(folder, *command)
        if not bench.wait_a_while(process, most):
            bench.count('stop ended before')
            bench.end(process)
            shutil.rmtree(folder)
            return
        how = bench.random.choice([signal.SIGINT, signal.SIGTERM])
        process.send_signal(how)
        began = time.monotonic()
        out, errors = process.communicate(timeout=60)
        seconds = time.monotonic() - began
        require(seconds < bench.most_to_stop, f'{command} ended {seconds:.2f} s after it was told to')
        # Before it has taken hold of its signals, the system ends it.
        at_once = process.returncode == -how
        require(at_once or process.returncode in (0, 1, 2, 4), f'{command}: {process.returncode}, {errors}')
        if (folder / 'out').exists():
            require_whole(folder / 'out')
        bench.count(f'stop {command[0]}')
        shutil.rmtree(folder)

    def together(self):
        """Several runs, one name. Whoever does not get it has its results beside it."""
        bench, folder = self.bench, self.bench.fresh()
        force = bench.random.random() < 0.5
        if force:
            bench.run(folder, *self.variants.command('0.4', 'out'))
        processes = []
        for _ in range(bench.random.randrange(2, 5)):
            command = self.variants.command(bench.random.choice(self.variants.STEPS), 'out')
            processes.append(bench.start(folder, *command, *(['--force'] if force else [])))
        victim = processes[-1] if bench.random.random() < 0.4 else None
        if victim:
            bench.wait_a_while(victim, 6)
            victim.kill()
        ended = [bench.end(p) for p in processes]
        codes = [e.code for e in ended]
        published = [e for e in ended if e.code in (0, 1, 2)]
        beside = [n for n in names(folder) if n.startswith('out.unpublished')]
        told = [e for e in ended if e.code == 4 and 'the results are in' in e.errors]
        require(len(beside) >= len(told), f'{folder}: results are lost, {codes} {names(folder)}')
        require(force or len(published) <= 1, f'{folder}: two runs have one name, {codes}')
        require((folder / 'out').exists() or victim, f'{folder}: nobody has the name, {codes}')
        for name in (['out'] if (folder / 'out').exists() else []) + beside:
            self.variants.require_of_one(folder / name)
        bench.counts['together runs'] += len(processes)
        bench.counts['together kept beside'] += len(beside)
        shutil.rmtree(folder)

    def cache(self):
        bench, folder = self.bench, self.bench.fresh()
        command = ['study', STUDY, '--cache', 'cache', '--threads', '2', '-o']
        processes = [bench.start(folder, *command, f'out{i}') for i in range(3)]
        for process in processes[1:]:
            bench.wait_a_while(process, 6)
            process.kill()
        ended = bench.end(processes[0])
        for process in processes[1:]:
            process.communicate()
        require(ended.code in (0, 1, 2), f'the study in {folder} fails: {ended.errors}')
        # The first one's own figures, made without any help.
        if not hasattr(self, 'table'):
            bench.run(folder, 'study', STUDY, '--cache', 'other', '--threads', '2', '-o', 'alone')
            self.table = self.rows(folder / 'alone')
        require(self.rows(folder / 'out0') == self.table, f'another table in {folder}')
        ended = bench.run(folder, *command, 'again')
        require(self.rows(folder / 'again') == self.table, f'another table in {folder}')
        bench.counts['cache studies'] += 4
        shutil.rmtree(folder)

    @staticmethod
    def rows(folder):
        """The table but for what a clock has a say in."""
        lines = [line.split(',') for line in (folder / 'study.csv').read_text().splitlines()]
        kept = [i for i, name in enumerate(lines[0]) if name not in ('seconds', 'reused', 'attempts')]
        return [[line[i] for i in kept] for line in lines]

    def history(self):
        bench, folder = self.bench, self.bench.fresh()
        processes = [bench.start(folder, *self.variants.command('0.8', f'out{i}'), '--history', 'runs.sqlite')
                     for i in range(4)]
        for process in processes[2:]:
            bench.wait_a_while(process, 4)
            process.kill()
        told = []
        for process in processes:
            ended = bench.end(process)
            told += [line.rsplit(' ', 1)[1] for line in ended.out.splitlines() if line.startswith('history: ')]
        bench.run(folder, 'history', 'runs.sqlite', '-o', 'listing')
        with sqlite3.connect(folder / 'runs.sqlite') as database:
            require(database.execute('PRAGMA integrity_check').fetchone()[0] == 'ok', f'{folder}: damaged')
            ids = [str(row[0]) for row in database.execute('SELECT id FROM run')]
        require(len(set(told)) == len(told), f'{folder}: one number twice, {told}')
        require(set(told) <= set(ids), f'{folder}: lost runs, told {told}, kept {ids}')
        require(len(ids) <= len(processes), f'{folder}: more runs than there were, {ids}')
        left = [n for n in names(folder) if n.startswith(('runs.sqlite-', '.runs'))]
        require(left == [], f'{folder}: {left}')
        bench.counts['history appends'] += len(ids)
        shutil.rmtree(folder)

    def disk(self):
        bench, folder = self.bench, self.bench.fresh()
        most = int(10 ** bench.random.uniform(1, 6.5))
        ended = bench.run(folder, *RUN, before=limit(resource.RLIMIT_FSIZE, most))
        require(ended.code in (0, 4), f'{folder}: exit code {ended.code}, {ended.errors}')
        require((folder / 'out').exists() == (ended.code == 0), f'{folder}: {ended.code}, {names(folder)}')
        if ended.code == 0:
            require_whole(folder / 'out')
        else:
            require('error: cannot write' in ended.errors or 'File too large' in ended.errors,
                    f'{folder}: no file or reason, {ended.errors}')
        require(set(names(folder)) <= {'out', 'out.incomplete'}, f'{folder}: {names(folder)}')
        bench.count('disk full' if ended.code else 'disk large enough')
        shutil.rmtree(folder)

    def limits(self):
        bench, folder = self.bench, self.bench.fresh()
        what, most = bench.random.choice([
            (resource.RLIMIT_NOFILE, bench.random.randrange(3, 14)),
            (resource.RLIMIT_NPROC, bench.random.randrange(1, 12)),
            (resource.RLIMIT_AS, bench.random.randrange(120, 1000) * 1000000)])
        folder.chmod(0o777)

        def before():
            resource.setrlimit(what, (most, most))
            if what == resource.RLIMIT_NPROC and os.geteuid() == 0:
                os.setuid(NOBODY)

        try:
            ended = bench.run(folder, 'run', bench.job, *RUN[2:], before=before)
        except (PermissionError, subprocess.SubprocessError):
            bench.count('limits that cannot be set here')
            return
        loader = ended.code == 127 and 'shared lib' in ended.errors
        require(loader or ended.code in (0, 4), f'{folder}: exit code {ended.code}, {ended.errors}')
        require((folder / 'out').exists() == (ended.code == 0), f'{folder}: {names(folder)}')
        require(ended.code == 0 or ended.errors.strip(), f'{folder}: no reason')
        bench.count('limits met' if ended.code else 'limits wide enough')
        shutil.rmtree(folder)

    def output(self):
        bench, folder = self.bench, self.bench.fresh()
        reading, writing = os.pipe()
        os.close(reading)
        out = bench.random.choice([writing, os.open('/dev/full', os.O_WRONLY)])
        process = bench.start(folder, *RUN, '--history', 'runs.sqlite', out=out)
        os.close(writing)
        ended = bench.end(process)
        require(ended.code == 4 and 'standard output' in ended.errors, f'{folder}: {ended.code}, {ended.errors}')
        require_whole(folder / 'out')
        with sqlite3.connect(folder / 'runs.sqlite') as database:
            require(database.execute('SELECT count(*) FROM run').fetchone()[0] == 1, f'{folder}: not in the history')
        bench.count('output lost')
        shutil.rmtree(folder)

    def view(self):
        bench = self.bench
        process = bench.start(bench.folder, 'view', self.readers.folder / 'out', '--no-browser')
        line = process.stdout.readline().decode()
        port = int(line.split(':')[3].split('/')[0])
        slow = []
        for i in range(bench.random.randrange(20, 200)):
            client = socket.create_connection(('127.0.0.1', port), timeout=10)
            client.send([b'', b'GET', b'GET /report.html HTTP/1.1\r\nHost: 127.0.0.1:%d\r\n\r\n' % port][i % 3])
            slow.append(client)
        began = time.monotonic()
        with socket.create_connection(('127.0.0.1', port), timeout=10) as client:
            client.sendall(b'GET /result.json HTTP/1.1\r\nHost: 127.0.0.1:%d\r\nConnection: close\r\n\r\n' % port)
            answer = b''.join(iter(lambda: client.recv(65536), b''))
        require(b' 200 OK' in answer[:20], f'not served beside {len(slow)} slow clients: {answer[:100]}')
        bench.counts['view clients'] += len(slow) + 1
        ended = bench.stop(process, signal.SIGINT)
        require(ended.code == 0, f'view ends with {ended.code}')
        for client in slow:
            client.close()

    def read(self):
        for _ in range(20):
            self.readers.try_one()
