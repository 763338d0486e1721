#!/usr/bin/env python3
"""The tables of docs/tuning.md and docs/tolerances.md, from the figures of their studies.

    tables.py cut STUDY.csv OUT.csv   keeps the columns that the page needs
    tables.py print                   the tables, by name
    tables.py check PAGE.md           ends with 1 where one of the page's is not in it as it is
"""
import csv
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
KEPT = ('machining_time_s', 'finish.uncut_mm.low', 'finish.uncut_mm.high', 'finish.gouge_mm.high',
        'finish.robust_gouge_mm.low', 'finish.robust_gouge_mm.high', 'finish.robust_uncut_mm.low',
        'finish.robust_uncut_mm.high')
ALLOWANCE, STEP, TOLERANCE = ('stage.semi-finish.allowance', 'stage.finish.step',
                              'stage.finish.tolerance')
PAPER = {ALLOWANCE: '0.2', STEP: '0.1', TOLERANCE: '0.005'}


def rows(name):
    with open(HERE / name, newline='', encoding='utf-8') as file:
        return list(csv.DictReader(file))


def cut(study, out):
    with open(study, newline='', encoding='utf-8') as file:
        table = list(csv.DictReader(file))
    keys = [key for key in table[0] if re.match(r'(stage|simulation|verification|tolerances)\.', key)]
    names = ['case', 'status', 'reason', *keys, *(name for name in KEPT if name in table[0])]
    with open(out, 'w', newline='', encoding='utf-8') as file:
        writer = csv.DictWriter(file, names, extrasaction='ignore', lineterminator='\n')
        writer.writeheader()
        writer.writerows(table)


def up(mm, digits=1):
    """Micrometres, rounded away from what the certificate promises."""
    scale = 10 ** digits
    return f'{-(-float(mm) * 1000 * scale // 1) / scale:.{digits}f}'


def down(mm, digits=1):
    scale = 10 ** digits
    return f'{float(mm) * 1000 * scale // 1 / scale:.{digits}f}'


def seconds(text):
    return f'{float(text):,.0f}'


def markdown(head, body):
    lines = ['| ' + ' | '.join(head) + ' |', '|' + '---|' * len(head)]
    return '\n'.join(lines + ['| ' + ' | '.join(line) + ' |' for line in body])


def grid():
    """Certified uncut of every step-over and tolerance at the paper's allowance."""
    table = [row for row in rows('aircraft.csv') if row[ALLOWANCE] == PAPER[ALLOWANCE]]
    tolerances = sorted({row[TOLERANCE] for row in table}, key=float)
    body = []
    for step in sorted({row[STEP] for row in table}, key=float):
        of_step = {row[TOLERANCE]: row for row in table if row[STEP] == step}
        cells = []
        for tolerance in tolerances:
            row = of_step[tolerance]
            sign = {'pass': '✓', 'fail': '✗ ≥'}.get(row['status'], '?')
            end = down(row['finish.uncut_mm.low']) if row['status'] == 'fail' else up(row['finish.uncut_mm.high'])
            cells.append(f'{sign} {end}')
        body.append([f'{step} mm', seconds(of_step[PAPER[TOLERANCE]]['machining_time_s']) + ' s', *cells])
    return markdown(['step-over', 'machining time', *(f'tolerance {t} mm' for t in tolerances)], body)


def best(table, accuracy='finish.uncut_mm.high', time='machining_time_s'):
    """The front of the passing cases: each takes less time than all that are more accurate."""
    front, least = [], float('inf')
    for row in sorted(table, key=lambda r: (float(r[time]), float(r[accuracy]))):
        if float(row[accuracy]) < least:
            front.append(row)
            least = float(row[accuracy])
    return front


def passing():
    return [row for row in rows('aircraft.csv') if row['status'] == 'pass']


def line_of(row):
    return [row['case'], f'{row[ALLOWANCE]} mm', f'{row[STEP]} mm', f'{row[TOLERANCE]} mm',
            seconds(row['machining_time_s']) + ' s', up(row['finish.uncut_mm.high'], 2) + ' µm']


def front():
    return markdown(['case', 'semi-finish allowance', 'step-over', 'tolerance', 'machining time',
                     'certified uncut'], [line_of(row) for row in best(passing())])


def wasted(row, table):
    return any(float(o['machining_time_s']) < float(row['machining_time_s']) and
               float(o['finish.uncut_mm.high']) <= float(row['finish.uncut_mm.high']) and
               float(o['finish.gouge_mm.high']) <= float(row['finish.gouge_mm.high']) for o in table)


def paper_row():
    return next(row for row in rows('aircraft.csv') if all(row[k] == v for k, v in PAPER.items()))


def standing():
    """The figures that the text speaks of."""
    table, paper = passing(), paper_row()
    cheapest = min(table, key=lambda r: float(r['machining_time_s']))
    as_good = [r for r in table if float(r['finish.uncut_mm.high']) <= float(paper['finish.uncut_mm.high'])]
    quickest = min(as_good, key=lambda r: float(r['machining_time_s']))
    same_time = [r for r in table if r[STEP] == paper[STEP]]
    finest = min(same_time, key=lambda r: float(r['finish.uncut_mm.high']))
    return markdown(['', 'case', 'semi-finish allowance', 'step-over', 'tolerance', 'machining time',
                     'certified uncut'],
                    [["the paper's settings", *line_of(paper)],
                     ['the cheapest that passes', *line_of(cheapest)],
                     ['as accurate as the paper, and quickest', *line_of(quickest)],
                     ["the paper's step-over, most accurate", *line_of(finest)]])


def counts():
    table = rows('aircraft.csv')
    passed = passing()
    return markdown(['cases', 'pass', 'fail', 'undecided', 'bought for nothing'],
                    [[str(len(table)), str(len(passed)),
                      str(sum(r['status'] == 'fail' for r in table)),
                      str(sum(r['status'] == 'indeterminate' for r in table)),
                      str(sum(wasted(r, passed) for r in passed))]])


def instruments():
    verdicts = {'pass': 'pass', 'fail': 'fail', 'indeterminate': 'undecided'}
    body = []
    for row in rows('instruments.csv'):
        finish = f"[{down(row['finish.uncut_mm.low'])}, {up(row['finish.uncut_mm.high'])}] µm" \
            if row['finish.uncut_mm.high'] else 'not run'
        gouge = f"{up(row['finish.gouge_mm.high'], 2)} µm" if row['finish.gouge_mm.high'] else 'not run'
        width = row['verification.resolution'].strip('"')
        body.append([row['simulation.voxel'] + ' mm', width if width == 'auto' else f'{float(width):g} mm',
                     verdicts.get(row['status'], row['status']), finish, gouge])
    return markdown(['voxel', 'width asked for', 'verdict', 'finish: uncut', 'finish: gouge at most'],
                    body)


def over_tolerances(row, figure, limit_mm):
    """What the gate sees of a figure: proven within its limit, or proven beyond."""
    low, high = (float(row[f'finish.robust_{figure}_mm.{end}']) for end in ('low', 'high'))
    if low > limit_mm:
        return f'✗ ≥ {down(low)}'
    return f'{"✓" if high <= limit_mm else "?"} {up(high)}'


def bears():
    """Gouge and uncut of the finish over every zero and radius, µm."""
    table = rows('tolerances.csv')
    zeros = list(dict.fromkeys(row['tolerances.zero'] for row in table))
    radii = sorted({row['tolerances.tool.ball3.radius'] for row in table}, key=float)
    body = []
    for zero in zeros:
        of_zero = {row['tolerances.tool.ball3.radius']: row for row in table
                   if row['tolerances.zero'] == zero}
        x, y, z = (float(value) for value in zero.strip('[]').split(','))
        assert x == y == z
        body.append([f'±{1000 * x:g} µm', *(over_tolerances(of_zero[r], 'gouge', 0.01) + ' · ' +
                                            over_tolerances(of_zero[r], 'uncut', 0.01) for r in radii)])
    return markdown(['zero, each axis', *(f'radius ±{1000 * float(r):g} µm' for r in radii)], body)


TABLES = {f.__name__: f for f in (counts, grid, front, standing, instruments, bears)}
OF_PAGE = {'tolerances.md': ('bears',)}


def check(page):
    text = pathlib.Path(page).read_text(encoding='utf-8')
    elsewhere = {name for names in OF_PAGE.values() for name in names}
    wanted = OF_PAGE.get(pathlib.Path(page).name, TABLES.keys() - elsewhere)
    missing = [name for name in TABLES if name in wanted and f'\n\n{TABLES[name]()}\n\n' not in text]
    for name in missing:
        print(f'{page}: the table {name} of the studies is not there:\n{TABLES[name]()}')
    return 1 if missing else 0


def main(arguments):
    if arguments[:1] == ['cut'] and len(arguments) == 3:
        cut(*arguments[1:])
        return 0
    if arguments == ['print']:
        for name, table in TABLES.items():
            print(f'{name}\n\n{table()}\n')
        return 0
    if arguments[:1] == ['check'] and len(arguments) == 2:
        return check(arguments[1])
    print(__doc__, file=sys.stderr)
    return 2


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
