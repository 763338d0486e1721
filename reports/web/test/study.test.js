import assert from 'node:assert/strict';
import { test } from 'node:test';

import { createBoard, filteredRows } from '../src/study/board.js';
import { sortedRows, tableColumns } from '../src/study/columns.js';
import { curvesOf } from '../src/study/curves.js';
import { caseLines, decodeStudy, resultPath } from '../src/study/data.js';
import { paretoFront } from '../src/study/front.js';
import {
  axisPlace, parallelHeight, parallelOption, parallelQuantities,
} from '../src/study/parallel_option.js';
import { scatterOption } from '../src/study/scatter_option.js';
import { clockText, durationText, percentText, shownFigure } from '../src/study/quantity_text.js';

const markup = '<img src=x onerror=window.hostile=1>';

/** Twelve cases of a step and a strategy; the last but one failed, the last was lost. */
function sampleData() {
  const steps = [0.1, 0.2, 0.4], of = Array.from({ length: 12 }, (_, row) => Math.floor(row / 4));
  const time = of.map((i, row) => 60 / steps[i] + (row % 4)), uncut = of.map((i) => steps[i] ** 2 / 24);
  time[11] = uncut[11] = null;
  return {
    format: 'limitgauge.study-page/1', cases: Array.from({ length: 12 }, (_, row) => row),
    status: [0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 1, 4],
    reasons: { texts: ['', markup], of: [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1] },
    keys: [
      { key: 'stage.finish.step', settings: steps.map((step) => [String(step), step]), of },
      {
        key: 'stage.finish.strategy', settings: [['zigzag', null], [markup, null]],
        of: of.map((_, row) => row % 2),
      },
    ],
    figures: [
      { id: 'machining_time_s', label: 'machining time', unit: 's', values: time },
      { id: 'finish.uncut_mm.high', label: 'finish: certified uncut', unit: 'mm', values: uncut },
    ],
    objectives: [0, 1], fronts: [{ figures: [0, 1], rows: [] }],
    responses: [{ key: 0, figure: 1, rows: [0, 4, 8], fit: [] }], recommended: 4, own: 0,
  };
}

const colours = new Proxy({}, { get: (_, name) => String(name) });

test('data: values stand in one unit, what is missing is null', () => {
  const study = decodeStudy(sampleData());
  const [step, strategy, time, uncut, verdict] = study.quantities;
  assert.equal(uncut.title, 'finish: certified uncut, µm');
  assert.ok(Math.abs(uncut.value(0) - 0.01 / 24 * 1000) < 1e-12);
  assert.equal(uncut.text(11), '–');
  assert.equal(time.value(11), null);
  assert.deepEqual([step.value(5), step.text(5), strategy.value(1), strategy.text(1)],
    [0.2, '0.2', 1, markup]);
  assert.equal(verdict.text(11), '– lost');
  assert.throws(() => decodeStudy({ format: 'limitgauge.study-page/2' }), /not known/);
});

test('a result is found where the program puts it', () => {
  assert.equal(resultPath(0), 'cases/0000/0000/result.json');
  assert.equal(resultPath(12345), 'cases/12300/12345/result.json');
});

test('figures are said as in the tables', () => {
  assert.deepEqual([0.05, 12.44, 70, 3725].map(durationText),
    ['0.05 s', '12.4 s', '1 min 10 s', '1 h 02 min']);
  assert.deepEqual([45, 150, 3720].map((s) => clockText(s)), ['45 s', '2:30', '1:02:00']);
  assert.deepEqual([clockText(150.26, 1), clockText(179.999, 1), clockText(62, 2)],
    ['2:30.3', '3:00.0', '1:02.00']);
  assert.equal(percentText(0.99999), '99.99 %');
  const shown = shownFigure({ id: 'x', label: 'moves', unit: '', values: [12345, null] });
  assert.deepEqual([shown.title, shown.cell(12345), shown.cell(null)], ['moves', '12345', '–']);
});

test('filters: in any range of a quantity, in one of each; what is missing is in none', () => {
  const study = decodeStudy(sampleData());
  const rows = (ranges, statuses = [0, 1, 2, 3, 4]) =>
    filteredRows(study, { ranges: new Map(ranges), statuses: new Set(statuses) });
  assert.deepEqual(rows([['key stage.finish.step', [[0.15, 0.3]]]]), [4, 5, 6, 7]);
  assert.deepEqual(rows([['key stage.finish.step', [[0, 0.1], [0.4, 1]]],
    ['key stage.finish.strategy', [[0, 0]]]]),
    [0, 2, 8, 10]);
  assert.deepEqual(rows([['figure machining_time_s', [[-Infinity, Infinity]]]]).includes(11), false);
  assert.deepEqual(rows([], [1, 4]), [8, 10, 11]);
  assert.deepEqual(rows([['verdict', [[1.5, 2.5]]]]), [9]);
});

test('board: who follows is told, and by whom it was changed', () => {
  const board = createBoard(decodeStudy(sampleData())), heard = [];
  board.onFilter((from) => heard.push([from, board.rows().length]));
  board.onChoice(() => heard.push(board.chosen()));
  board.setRanges('key stage.finish.step', [[0.1, 0.1]], 'chart');
  board.setStatus(0, false);
  board.clear();
  board.choose(3);
  board.setRanges('key stage.finish.step', []);
  assert.deepEqual(heard, [['chart', 4], [undefined, 0], [undefined, 12], 3]);
});

test('front: nothing is beaten, whatever the order; of equal ones the first', () => {
  const points = [[3, 1], [1, 3], [2, 2], [2, 3], [1, 3], [4, 1], [0, null], [2.5, 1.5]];
  const front = paretoFront(points.map((_, i) => i), (i) => points[i][0], (i) => points[i][1]);
  assert.deepEqual(front, [1, 2, 7, 0]);
  const beaten = (a, b) => b[0] <= a[0] && b[1] <= a[1] && (b[0] < a[0] || b[1] < a[1]);
  const many = Array.from({ length: 500 }, (_, i) => [(i * 7919) % 503, (i * 104729) % 499]);
  const found = new Set(paretoFront(many.map((_, i) => i), (i) => many[i][0], (i) => many[i][1]));
  many.forEach((point, i) => assert.equal(found.has(i), !many.some((other) => beaten(point, other))));
});

test('curves: mean, range and a line for each setting of the others', () => {
  const study = decodeStudy(sampleData()), rows = Array.from({ length: 12 }, (_, row) => row);
  const { means, lines } = curvesOf(study, 0, study.figures[0], rows);
  assert.deepEqual(means.map(({ at, least, most, count }) => [at, least, most, count]),
    [[0.1, 600, 603, 4], [0.2, 300, 303, 4], [0.4, 150, 152, 3]]);
  assert.ok(Math.abs(means[0].mean - 601.5) < 1e-9);
  assert.equal(lines.length, 2);
  assert.deepEqual(curvesOf(study, 0, study.figures[0], []), { means: [], lines: [], points: [] });
});

test('curves of settings drawn from a range: points, and means of parts of it', () => {
  const data = sampleData(), count = 100;
  data.cases = Array.from({ length: count }, (_, i) => i);
  data.status = data.cases.map(() => 0);
  data.keys = [{ key: 'a', settings: data.cases.map((i) => [String(i), i]), of: data.cases }];
  data.figures = [{ id: 'f', label: 'f', unit: '', values: data.cases.map((i) => 2 * i) }];
  const study = decodeStudy(data), { means, points } = curvesOf(study, 0, study.figures[0], data.cases);
  assert.equal(points.length, count);
  assert.equal(means.length, 8);
  means.forEach(({ at, mean }) => assert.ok(Math.abs(mean - 2 * at) < 1e-9));
});

test('table: sorted by any column, what is missing last either way', () => {
  const study = decodeStudy(sampleData()), columns = tableColumns(study);
  const rows = Array.from({ length: 12 }, (_, row) => row), time = columns.at(-2);
  assert.deepEqual(columns.map(({ title }) => title), ['Case', 'Verdict', 'stage.finish.step',
    'stage.finish.strategy', 'machining time', 'finish: certified uncut, µm']);
  assert.deepEqual(sortedRows(rows, time.order, false).slice(0, 2), [8, 9]);
  assert.equal(sortedRows(rows, time.order, false).at(-1), 11);
  assert.equal(sortedRows(rows, time.order, true).at(-1), 11);
  // By verdict: passed by time, undecided, failed, lost.
  assert.deepEqual(sortedRows(rows, columns[1].order, false), [4, 5, 6, 7, 0, 1, 2, 3, 9, 8, 10, 11]);
});

test('parallel coordinates: a line a case and status, axes lie where it is narrow', () => {
  const board = createBoard(decodeStudy(sampleData())), { study } = board;
  const wide = parallelOption(board, colours, 1000), narrow = parallelOption(board, colours, 360);
  assert.equal(wide.parallelAxis.length, parallelQuantities(study).length);
  assert.equal(wide.series.slice(0, 5).flatMap(({ data }) => data).length, 12);
  assert.ok(Number.isNaN(wide.series[4].data[0].value[2]), 'a figure that is not there has no place');
  assert.deepEqual([wide.parallel.layout, narrow.parallel.layout], ['horizontal', 'vertical']);
  assert.ok(parallelHeight(study, 360) >= 5 * 60);
  assert.ok(axisPlace(study, 'verdict', 1000).x > axisPlace(study, 'key stage.finish.step', 1000).x);
  board.setStatus(0, false);
  assert.equal(parallelOption(board, colours, 1000).series[0].data.length, 0);
});

test('scatter: of a figure that is to be large the front joins the largest', () => {
  const data = sampleData();
  data.figures[1] = {
    id: 'finish.margin.low', label: 'finish: tolerance margin, proven', unit: '', better: 'higher',
    values: data.figures[0].values.map((time, row) => (time === null ? null : time / 100 - row % 4)),
  };
  const study = decodeStudy(data), [x, y] = study.figures;
  const { series } = scatterOption(createBoard(study), { x, y }, colours, 800);
  const front = series.find(({ name }) => name === 'front').data;
  assert.deepEqual(front.map(([time]) => time), [150, 300, 600]);
  assert.ok(front.every(([, margin], i) => i === 0 || margin > front[i - 1][1]));
});

test('scatter: what is filtered away stays as a shade, the front joins what is not beaten', () => {
  const board = createBoard(decodeStudy(sampleData())), { study } = board;
  const axes = { x: study.figures[0], y: study.figures[1] };
  board.setRanges('key stage.finish.step', [[0.1, 0.1]]);
  const { series } = scatterOption(board, axes, colours, 800);
  const left = series.slice(0, 5).flatMap(({ data }) => data);
  const kept = series.slice(5, 10).flatMap(({ data }) => data);
  assert.deepEqual([left.length, kept.length], [7, 4]);
  const front = series.find(({ name }) => name === 'front');
  assert.deepEqual(front.data.map(([x]) => x), [150, 300, 600]);
  assert.ok(['recommended', 'own'].every((name) => series.some((s) => s.name === name)));
  const plain = scatterOption(board, { x: study.keys[0], y: study.figures[1] }, colours, 800);
  assert.equal(plain.series.some(({ name }) => name === 'front'), false);
});

test('a case in lines: number, verdict, settings, figures, reason', () => {
  const lines = caseLines(decodeStudy(sampleData()), 8);
  assert.deepEqual(lines, ['case 8: failed', 'stage.finish.step = 0.4', 'stage.finish.strategy = zigzag',
    'machining time: 2 min 30 s', 'finish: certified uncut: 6.67 µm', markup]);
});
