import assert from 'node:assert/strict';
import { test } from 'node:test';

import {
  binnedVolume, findingTimes, histogramAxis, histogramBars, leastDecade, placeWords, processBins,
} from '../src/charts/bins.js';
import { clockInterval } from '../src/charts/clock_axis.js';
import { histogramOption, limitMarks, percentilesOf, unitOf } from '../src/charts/histogram_option.js';
import { leastRate, processOption } from '../src/charts/process_option.js';
import { clockMark } from '../src/base/figure_text.js';
import { sampleReport } from './sample.js';

/** Segments of the given seconds, feeds and rates; a rapid where the feed is 0. */
function pathOf(seconds, feeds, rates) {
  let time = 0;
  return {
    kind: Uint8Array.from(feeds, (feed) => (feed > 0 ? 1 : 0)), feed_mm_min: Float32Array.from(feeds),
    rate_mm3_min: rates && Float32Array.from(rates), end_s: Float32Array.from(seconds, (s) => (time += s)),
    move: Uint32Array.from(seconds, (_, i) => 10 * i), line: Uint32Array.from(seconds, (_, i) => i + 1),
  };
}

test('bins hold the largest and the mean in time, whatever the segments are', () => {
  const { width_s, rate, feed } = processBins(pathOf([1, 2, 3, 2], [0, 600, 300, 0], [0, 120, 60, 0]), 4);
  assert.equal(width_s, 2);
  assert.deepEqual(rate.map(({ max, mean }) => [max, mean]), [[120, 60], [120, 90], [60, 60], [0, 0]]);
  assert.deepEqual(feed,
    [{ max: 600, mean: 600 }, { max: 600, mean: 450 }, { max: 300, mean: 300 }, null]);
});

test('no more bins than asked for, none longer than the path', () => {
  const { path } = sampleReport().stages[0];
  assert.equal(processBins(path).feed.length, 600);
  assert.equal(processBins(pathOf([1, 2], [5, 5], [1, 1])).feed.length, 2);
  assert.deepEqual(processBins(pathOf([], [], [])), { width_s: 0, rate: null, feed: [] });
  assert.equal(processBins(pathOf([1, 2], [5, 5], null)).rate, null);
});

test('the bins lose nothing of what was removed', () => {
  const { path } = sampleReport().stages[0];
  let volume = 0;
  for (let i = 0; i < path.end_s.length; ++i)
    volume += (path.rate_mm3_min[i] * (path.end_s[i] - (i > 0 ? path.end_s[i - 1] : 0))) / 60;
  for (const most of [1, 7, 100, 600, 5000])
    assert.ok(Math.abs(binnedVolume(processBins(path, most)) - volume) < 1e-9 * volume, `${most} bins`);
});

test('the largest of all bins is the largest of all segments', () => {
  const { path } = sampleReport().stages[0];
  const { rate, feed } = processBins(path, 50);
  assert.equal(Math.max(...rate.map(({ max }) => max)), Math.max(...path.rate_mm3_min));
  assert.equal(Math.max(...feed.map(({ max }) => max)), 1200);
  for (const { max, mean } of rate) assert.ok(mean <= max + 1e-9);
});

test('findings stand at the end of the segment that holds their move, in time', () => {
  const path = pathOf([1, 2, 3], [0, 600, 300], null);
  const finding = (id, move) => ({ id, kind: 'near_miss', words: 'near miss', line: 1, move });
  const times = findingTimes(path, [finding('P1', 15), finding('P2', 0), finding('P3', 99)]);
  assert.deepEqual(times.map(({ id, time_s }) => [id, time_s]), [['P2', 1], ['P1', 6]]);
});

test('histogram: empty bins go, sides are told by the middle, the area stays', () => {
  const { histogram, limits } = sampleReport().stages[1];
  const bars = histogramBars({ ...histogram, area_mm2: [2, 0, 390, 10] }, limits);
  assert.deepEqual(bars.map(({ low_mm, side }) => [low_mm, side]),
    [[-0.05, 'gouge'], [0, 'inside'], [0.025, 'uncut']]);
  assert.equal(bars.reduce((sum, { area_mm2 }) => sum + area_mm2, 0), 402);
  assert.deepEqual(histogramBars(histogram, {}).map(({ side }) => side), Array(4).fill('inside'));
});

test('a bin that holds a limit is on neither side of it', () => {
  const limits = { gouge_mm: 0.01, uncut_mm: 0.02 };
  const words = (low_mm, high_mm, stated = limits) => placeWords({ low_mm, high_mm }, stated);
  assert.equal(words(-0.02, -0.01), 'beyond the gouge limit');
  assert.equal(words(-0.02, 0), 'across the gouge limit');
  assert.equal(words(-0.01, 0.02), 'within the limits');
  assert.equal(words(0.019, 0.021), 'across the uncut limit');
  assert.equal(words(0.02, 0.021), 'beyond the uncut limit');
  assert.equal(words(0, 1, {}), 'no limit stated');
});

test('the axis takes in zero and near limits, not far ones', () => {
  const of = (edges_mm, limits) => histogramAxis({ edges_mm }, limits);
  const near = of([0.001, 0.011], { gouge_mm: 0.01, uncut_mm: 0.015 });
  assert.ok(near.low_mm < -0.01 && near.low_mm > -0.012 && near.high_mm > 0.015 && near.high_mm < 0.017);
  const far = of([-0.001, 0.001], { gouge_mm: 1, uncut_mm: 1 });
  assert.ok(far.low_mm > -0.0012 && far.high_mm < 0.0012);
});

test('a logarithmic axis begins at the power of ten below the least bar', () => {
  assert.equal(leastDecade([{ area_mm2: 0.02 }, { area_mm2: 500 }]), 0.01);
  assert.equal(leastDecade([{ area_mm2: 1 }]), 1);
});

test('units: micrometres where everything is below 0.1 mm', () => {
  assert.equal(unitOf({ low_mm: -0.05, high_mm: 0.09 }).symbol, '\u00b5m');
  assert.equal(unitOf({ low_mm: -0.05, high_mm: 0.2 }).symbol, 'mm');
});

test('marks of a time axis are round and few', () => {
  for (const total of [0.9, 12, 61, 599, 2400, 7300, 90000, 1e6])
    for (const most of [3, 10])
      assert.ok(total / clockInterval(total, most) <= most, `${total} s, ${most} marks`);
  assert.equal(clockInterval(2400, 10), 300);
  assert.deepEqual([0, 0.5, 30, 90, 120, 5400, 7200].map(clockMark),
    ['0', '0.5 s', '30 s', '1 min 30 s', '2 min', '1 h 30 min', '2 h']);
});

test('percentiles stand where the data have them', () => {
  assert.deepEqual(percentilesOf({}), []);
  assert.deepEqual(percentilesOf({ percentiles: { p01_mm: -0.1, p99_mm: 0.2 } }),
    [{ name: 'p01', at_mm: -0.1 }, { name: 'p99', at_mm: 0.2 }]);
});

const colours = {
  ink: 'black', soft: 'grey', rule: 'silver', panel: 'white', bar: 'grey', gouge: 'blue', uncut: 'red',
  fail: 'red', open: 'orange', link: 'navy', font: 'sans-serif',
};

test('the histogram marks zero and the percentiles, a limit on its place or at the side where it lies', () => {
  const stage = { ...sampleReport().stages[1], percentiles: { p01_mm: -0.02, p50_mm: 0, p99_mm: 0.02 } };
  const bars = histogramBars(stage.histogram, stage.limits);
  const { series } = histogramOption({ bars, stage, logarithmic: false }, colours, 1000);
  assert.deepEqual(series[1].markLine.data.map(({ xAxis, label }) => [Math.round(xAxis), label.formatter]),
    [[0, undefined], [-20, 'p01'], [0, 'p50'], [20, 'p99']]);
  const unit = { perMm: 1000, symbol: '\u00b5m' }, axis = { low_mm: -0.03, high_mm: 0.03 };
  assert.deepEqual(limitMarks({ gouge_mm: 0.01, uncut_mm: 0.02 }, axis, unit), [
    { at: -10, inside: true, row: 0, text: 'gouge limit 10 \u00b5m' },
    { at: 20, inside: true, row: 1, text: 'uncut limit 20 \u00b5m' }]);
  assert.deepEqual(limitMarks({ gouge_mm: 0.5, uncut_mm: 0.9 }, axis, unit).map(({ inside, text }) => [inside, text]),
    [[false, '\u2190 gouge limit 500 \u00b5m'], [false, 'uncut limit 900 \u00b5m \u2192']]);
});

test('the words of the limits have rows of their own and stay inside the chart at any scale', () => {
  const stage = sampleReport().stages[1], bars = histogramBars(stage.histogram, stage.limits);
  for (const width_px of [320, 1000])
    for (const limits of [{ gouge_mm: 1e-6, uncut_mm: 1e-6 }, { gouge_mm: 0.01, uncut_mm: 0.02 }, { gouge_mm: 9, uncut_mm: 9 }]) {
      const { series, grid } = histogramOption({ bars, stage: { ...stage, limits }, logarithmic: false }, colours, width_px);
      const words = [0, 1].map((dataIndex) => series[2].renderItem(
        { dataIndex, coordSys: { y: grid.top, height: 200 } },
        { coord: ([x]) => [width_px * (0.5 + x / 100), 0] }).children[0]);
      assert.ok(words[1].y - words[0].y >= 16, 'a row each');
      for (const { x, style } of words) {
        const half = (style.text.length * 7.4) / 2;
        assert.ok(x - half >= 0 && x + half <= width_px, `${style.text} at ${x} of ${width_px} px`);
      }
      assert.ok(grid.top >= words[1].y + 16, 'above the plot');
    }
});

test('a logarithmic removal rate begins at a power of ten, no more than five below the largest', () => {
  const rates = (...means) => means.map((mean) => ({ mean, max: 2 * mean }));
  assert.equal(leastRate(rates(30, 4000)), 10);
  assert.equal(leastRate(rates(0, 4000)), 1000);
  assert.ok(Math.abs(leastRate(rates(1e-9, 4000)) - 0.1) < 1e-12);
  const { path, ...stage } = sampleReport().stages[0];
  path.rate_mm3_min.fill(0, 0, 400);
  const chart = { bins: processBins(path, 50), total_s: 43, stage, findings: [], logarithmic: true };
  const { series, yAxis } = processOption(chart, colours, 1000);
  assert.deepEqual([yAxis[0].type, yAxis[1].type, series[0].data[0]], ['log', 'value', [0, null]]);
});

test('the process has a panel for each figure that the data have', () => {
  const stage = sampleReport().stages[0];
  const series = (path) => {
    const bins = processBins(path, 50);
    return processOption({ bins, total_s: 43, stage, findings: [] }, colours, 1000).series;
  };
  assert.equal(series(stage.path).length, 4);
  assert.equal(series({ ...stage.path, rate_mm3_min: null }).length, 2);
  const [shaded] = series(stage.path);
  assert.equal(shaded.data.length, 51);
  assert.deepEqual(shaded.data[50], [43, shaded.data[49][1]]);
});
