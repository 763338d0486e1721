import assert from 'node:assert/strict';
import { test } from 'node:test';

import {
  decodeHistory, figureText, limitText, nearestRun, runName, scaleOf, standingOf,
} from '../src/history/data.js';
import { historyOption, runsInSight, zoomedAxes } from '../src/history/option.js';
import { panelExtent } from '../src/history/panels.js';
import { runLines } from '../src/history/run_text.js';

/** A history of a job with five runs, of which the fourth has no finish. */
function sampleHistory() {
  const run = (id, verdict, finish) => ({
    id, created: `2026-01-0${id}T12:00:00Z`, version: '0.1.0', commit: '', label: `run ${id}`, verdict,
    stages: [{ name: 'rough', verdict: 'pass' }, { name: 'finish', verdict: finish }],
  });
  const figure = (low, high, trend) => ({ low, high, limit: 0.01, ...(trend ? { trend } : {}) });
  const text = JSON.stringify({
    schema: 'limitgauge.history/1', file: 'h.sqlite', version: '0.1.0', found: 5,
    jobs: [{
      job: 'part',
      runs: [run(1, 'pass', 'pass'), run(2, 'pass', 'pass'), run(3, 'fail', 'fail'),
        run(4, 'fail', 'not_run'), run(5, 'pass', 'pass')],
      series: [
        { stage: '', metric: 'machining_time_s', label: 'machining time', unit: 's', source: 'planned',
          values: [60, 61, 62, 30, 61].map((s) => ({ low: s, high: s })) },
        { stage: 'finish', metric: 'uncut_mm', label: 'uncut', unit: 'mm', source: 'certified',
          values: [figure(0.004, 0.005), figure(0.004, 0.0051, 'same'), figure(0.03, 0.0312, 'worse'), null,
            figure(0.004, 0.005, 'better')] },
      ],
    }],
  });
  return decodeHistory({ getElementById: () => ({ textContent: text }) });
}
const colours = { ink: 'black', soft: 'grey', rule: 'silver', panel: 'white', bar: 'tan', fail: 'red',
  open: 'orange', pass: 'green', link: 'navy', font: 'sans-serif' };
const all = { byTime: false, zoom: [0, 100], pinned: null };

test('data of another form are refused', () => {
  assert.throws(() => decodeHistory({ getElementById: () => ({ textContent: '{"schema": "x"}' }) }), /unknown data/);
});

test('figures are in one unit a column, intervals rounded outwards', () => {
  const [time, uncut] = sampleHistory().jobs[0].series;
  assert.deepEqual([time.scale, uncut.scale], [{ factor: 1, symbol: 's' }, { factor: 1000, symbol: '\u00b5m' }]);
  assert.equal(figureText(uncut, uncut.values[1]), '[4.0, 5.1] \u00b5m');
  assert.equal(figureText(uncut, { low: 0.00412, high: 0.00518 }), '[4.1, 5.2] \u00b5m');
  assert.equal(figureText(uncut, { low: 0, high: 0 }), '[0, 0] \u00b5m');
  assert.equal(figureText(uncut, null), 'not measured');
  assert.equal(figureText(time, time.values[0]), '60.0 s');
  assert.equal(figureText(time, { low: 12345.6, high: 12345.6 }), '12346 s');
  assert.equal(limitText(uncut, 0.01), 'limit 10 \u00b5m');
  const coverage = { metric: 'coverage', unit: '', source: 'measured', values: [] };
  coverage.scale = scaleOf(coverage);
  assert.equal(figureText(coverage, { low: 0.99999, high: 0.99999 }), '99.99 %');
});

test('a run is known by its commit, its label or its number', () => {
  assert.equal(runName({ id: 3, commit: '0123456789abcdef0123', label: 'x' }), '0123456');
  assert.equal(runName({ id: 3, commit: 'release-1.2', label: 'x' }), 'release-1.2');
  assert.equal(runName({ id: 3, commit: '', label: 'x' }), 'x');
  assert.equal(runName({ id: 3, commit: '', label: '' }), 'run 3');
});

test('a figure is marked by its own limit: the cross stands at the one that failed', () => {
  const [time, uncut] = sampleHistory().jobs[0].series;
  // The third run failed by its uncut; its machining time has nothing to do with it.
  assert.equal(standingOf(uncut, uncut.values[2]), 'fail');
  assert.equal(standingOf(time, time.values[2]), 'no limit');
  assert.equal(standingOf(uncut, uncut.values[0]), 'pass');
  assert.equal(standingOf(uncut, { low: 0.009, high: 0.011, limit: 0.01 }), 'indeterminate');
  assert.equal(standingOf(uncut, null), 'no limit');
  const coverage = { metric: 'coverage' };
  assert.equal(standingOf(coverage, { low: 0.989, high: 0.989, limit: 0.99 }), 'fail');
  assert.equal(standingOf(coverage, { low: 0.99, high: 0.99, limit: 0.99 }), 'pass');
});

test('a figure is printed on the side of its limit that it lies on', () => {
  const [, uncut] = sampleHistory().jobs[0].series, limit = 0.005;
  assert.equal(figureText(uncut, { low: 0.004, high: 0.0049996, limit }), '[4.0, 4.9996] \u00b5m');
  assert.equal(figureText(uncut, { low: 0.0050001, high: 0.006, limit }), '[5.0001, 6.0] \u00b5m');
  assert.equal(figureText(uncut, { low: 0.0045, high: 0.005, limit }), '[4.5, 5.0] \u00b5m');
  assert.equal(figureText(uncut, { low: 0.0045, high: 0.0050000001, limit }), '[4.5, 5.01] \u00b5m');
});

test('the nearest run is found by number and by time', () => {
  const { runs } = sampleHistory().jobs[0];
  assert.deepEqual([-3, 0.4, 0.6, 99].map((at) => nearestRun(runs, at, false).id), [1, 1, 2, 5]);
  assert.equal(nearestRun(runs, Date.parse('2026-01-03T20:00:00Z'), true).id, 3);
});

test('what is in sight is what the zoom leaves, with a neighbour on each side', () => {
  const [job] = sampleHistory().jobs;
  assert.deepEqual(runsInSight(job, all), [0, 4]);
  assert.deepEqual(runsInSight(job, { ...all, zoom: [75, 100] }), [2, 4]);
  assert.deepEqual(runsInSight(job, { ...all, byTime: true, zoom: [0, 10] }), [0, 1]);
});

test('an axis takes in intervals, zero and a near limit, and fits what is in sight', () => {
  const [job] = sampleHistory().jobs, uncut = job.series[1];
  const [low, high] = panelExtent(uncut, 0, 4);
  assert.ok(low === 0 && high > 31.2 && high < 35);
  const [, near] = panelExtent(uncut, 0, 1);
  assert.ok(near > 10 && near < 11, 'the limit is in sight');
  const tiny = { ...uncut, values: [{ low: 0, high: 1e-8, limit: 1 }] };
  assert.ok(panelExtent(tiny, 0, 0)[1] >= 0.05 * uncut.scale.factor, 'next to nothing is next to nothing');
  const [least, most] = panelExtent(job.series[0], 0, 2);
  assert.ok(least > 59 && least < 60 && most > 62 && most < 63);
  assert.deepEqual(panelExtent({ ...uncut, values: [null] }, 0, 0), [0, 1]);
  assert.ok(zoomedAxes(job, { ...all, zoom: [0, 25] }).yAxis[1].max < 34);
});

test('gaps, limits, bands and the pinned run are drawn', () => {
  const [job] = sampleHistory().jobs;
  const { series, grid, xAxis } = historyOption(job, { ...all, pinned: job.runs[2] }, colours, 1000);
  assert.deepEqual([grid.length, xAxis.length], [2, 2]);
  const [time, band, limit, uncut] = series;
  assert.deepEqual([time.type, band.type, limit.step, uncut.type], ['line', 'custom', 'middle', 'line']);
  assert.equal(uncut.data[3].value[1], null);
  assert.equal(limit.data[0][1], 10);
  assert.equal(uncut.data[2].itemStyle.color, 'red');
  assert.notEqual(uncut.data[2].symbol, uncut.data[0].symbol);
  assert.deepEqual(uncut.markLine.data, [{ xAxis: 2 }]);
  const last = xAxis[1].axisLabel.formatter;
  assert.equal(last('4'), 'run 5\n#5');
});

test('no line leads across a change of meaning, which is marked', () => {
  const [job] = sampleHistory().jobs;
  Object.assign(job.series[1].values[2], { trend: 'new meaning' });
  const { series } = historyOption(job, all, colours, 1000);
  const [, , , before, after] = series;
  const drawn = ({ data }) => data.map(({ value }) => value[1] !== null);
  assert.deepEqual(drawn(before), [true, true, false, false, false]);
  assert.deepEqual(drawn(after), [false, false, true, false, true]);
  assert.deepEqual(before.markLine.data.map(({ xAxis }) => xAxis), [2]);
  assert.deepEqual(after.markLine.data, []);
  assert.match(runLines(job, job.runs[2]).at(-1), /new meaning$/);
});

test('the words of a run name every figure', () => {
  const [job] = sampleHistory().jobs;
  assert.deepEqual(runLines(job, job.runs[2]), [
    'run 3 \u00b7 \u2715 failed', 'run 3', '2026-01-03 12:00 UTC', 'machining time: 62.0 s',
    'finish uncut: [30.0, 31.2] \u00b5m, limit 10 \u00b5m, worse']);
  assert.equal(runLines(job, job.runs[3]).at(-1), 'finish uncut: not measured');
});
