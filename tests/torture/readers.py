"""The twelve readers of what strangers write: a file of each, and the command that reads it."""

import pathlib
import shutil
import struct
import subprocess

import mutate
from bench import FIXTURES, JOB, require

# A file that is read in spite of its mutation may be work for minutes: stopped then, and no fault.
MOST_SECONDS = 3
CAGE = FIXTURES / 'cages/quick-dome.obj'
BOX = [(x, y, z) for z in (-4.0, 5.0) for y in (-13.0, 13.0) for x in (-13.0, 13.0)]
FACES = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2),
         (2, 4, 6), (1, 3, 5), (3, 7, 5)]


def obj():
    return ''.join(f'v {x} {y} {z}\n' for x, y, z in BOX) + ''.join(
        f'f {a + 1} {b + 1} {c + 1}\n' for a, b, c in FACES)


def stl():
    data = bytes(80) + struct.pack('<I', len(FACES))
    for face in FACES:
        data += struct.pack('<12fH', 0, 0, 0, *(c for corner in face for c in BOX[corner]), 0)
    return data


def ply():
    return (f'ply\nformat ascii 1.0\nelement vertex {len(BOX)}\nproperty float x\nproperty float y\n'
            f'property float z\nelement face {len(FACES)}\nproperty list uchar int vertex_indices\nend_header\n'
            + ''.join(f'{x} {y} {z}\n' for x, y, z in BOX) + ''.join(f'3 {a} {b} {c}\n' for a, b, c in FACES))


def job_text(name, cage):
    return name.read_text().replace('../cages/quick-dome.obj', str(cage)).replace('../jobs/quick-dome.toml', str(JOB))


class Readers:
    """Each reader's file, whole."""

    def __init__(self, bench):
        self.bench = bench
        self.folder = bench.fresh()
        ended = bench.run(self.folder, 'run', JOB, '-o', 'out', '--no-pictures', '--history', 'runs.sqlite', '--set',
                          'post.cl_data=true')
        require(ended.code == 0, f'the job does not run: {ended.errors}')
        program = self.folder / 'out/rough/toolpath.ngc'
        verify = ['verify', '--cage', CAGE, '--tool', 'flat:D=6', '--program', program, '-o', 'result', '--no-pictures',
                  '--threads', '2']
        inspect = ['inspect']
        rows = FIXTURES / 'programs/good/comp-arcs.ngc'
        self.seeds = {
            'cage.obj': (CAGE.read_bytes(), inspect),
            'job.toml': (job_text(JOB, CAGE).encode(), ['plan', '-o', 'result', '--threads', '2']),
            'study.toml': (job_text(FIXTURES / 'studies/quick-dome.toml', CAGE).encode(),
                           ['study', '-o', 'result', '--cache', 'result-cache', '--threads', '2']),
            'program.ngc': (program.read_bytes()[:20000], inspect),
            'path.apt': (program.with_suffix('.apt').read_bytes()[:20000], inspect),
            'tools.tbl': (rows.with_suffix('.tbl').read_bytes(), ['inspect', rows, '--tool-table']),
            'stock.stl': (stl(), [*verify, '--stock', 'mesh:']),
            'stock.ply': (ply().encode(), [*verify, '--stock', 'mesh:']),
            'stock.obj': (obj().encode(), [*verify, '--stock', 'mesh:']),
            'stock.vdb': ((self.folder / 'out/rough/stock.vdb').read_bytes(), [*verify, '--stock', 'vdb:']),
            'result.json': ((self.folder / 'out/result.json').read_bytes(),
                            ['compare', self.folder / 'out/result.json']),
            'runs.sqlite': ((self.folder / 'runs.sqlite').read_bytes(), ['history', '-o', 'result']),
        }

    def try_one(self):
        bench = self.bench
        name = bench.random.choice(sorted(self.seeds))
        content, command = self.seeds[name]
        folder = bench.fresh()
        file = folder / name
        file.write_bytes(mutate.mutated(bench.random, content))
        words = [*command[:-1], command[-1] + str(file)] if str(command[-1]).endswith(':') else [*command, file]
        process = bench.start(folder, *words)
        try:
            process.wait(MOST_SECONDS)
            ended = bench.end(process)
        except subprocess.TimeoutExpired:
            ended = bench.stop(process, 2)
        self.judge(folder, name, ended)
        bench.count(f'readers {name}')
        shutil.rmtree(folder)

    def judge(self, folder, name, ended):
        require(ended.code in (0, 1, 2, 3, 4), f'exit code {ended.code} on {folder / name}')
        require(not any(ord(c) < 32 and c not in '\n\t' for c in ended.out + ended.errors),
                f'control characters are printed on {folder / name}')
        left = sorted(str(p.name) for p in pathlib.Path(folder).iterdir() if p.name not in (name, 'result-cache'))
        if ended.code == 3:
            require(ended.errors.strip(), f'no word of why {folder / name} is refused')
            require(left == [], f'{left} written though {folder / name} is refused')
        if ended.code == 4 and 'interrupted' not in ended.errors:
            self.bench.count('readers beyond the machine')
