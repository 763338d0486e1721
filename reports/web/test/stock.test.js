import assert from 'node:assert/strict';
import { test } from 'node:test';
import { lazily } from '../src/data/lazy.js';
import { decodeStock } from '../src/data/stock.js';
import { Blob32 } from '../src/data/blocks.js';
import { colourChoices } from '../src/path/values.js';
import { removalTimes, stockChoices } from '../src/stock/colours.js';
import { stockHit } from '../src/stock/stock_hit.js';
import { createPicker } from '../src/view/scene/pick.js';
import { cutCurve } from '../src/view/section/section.js';

/** A pyramid of 10 x 10 mm, 5 mm high, without its floor; each side was cut by a pass of its own. */
const stock = lazily({ triangles: 4 }, {
  positions: () => Float32Array.of(0, 0, 0, 10, 0, 0, 10, 10, 0, 0, 10, 0, 5, 5, 5),
  cells: () => Uint32Array.of(0, 1, 4, 4, 1, 2, 4, 4, 2, 3, 4, 4, 3, 0, 4, 4),
  maker: () => Uint32Array.of(0, 1, 2, 2),
  move: () => Uint32Array.of(0, 3, 0, 9),
  line: () => Uint32Array.of(0, 14, 20, 29),
});
const path = (end_s, move) => ({ end_s: Float32Array.from(end_s), move: Uint32Array.from(move) });
const stages = [{ path: path([1, 4], [1, 4]) }, { path: path([2, 6], [0, 9]) }];

test('times of removal go on from stage to stage, and the raw stock has none', () => {
  const [raw, ...cut] = removalTimes(stock, stages);
  assert.ok(Number.isNaN(raw));
  assert.deepEqual(cut, [4, 6, 10]);
});

test('a stock can be coloured by tool, line and time', () => {
  const choices = stockChoices(stock, stages);
  assert.deepEqual(choices.map(({ key }) => key), ['tool', 'line', 'time', 'plain']);
  const line = choices[1];
  assert.deepEqual([line.low, line.high], [14, 29]);
  const uncut = { ...stock, maker: new Uint32Array(4), line: new Uint32Array(4) };
  assert.ok(stockChoices(uncut, stages)[1].reason);
});

test('a picker names the triangle that it hit', () => {
  const picker = createPicker(stock);
  for (const [x, y, cell] of [[5, 1, 0], [9, 5, 1], [5, 9, 2], [1, 5, 3]]) {
    const hit = picker.first({ origin: [x, y, 50], direction: [0, 0, -1] });
    assert.equal(hit.cell, cell);
    assert.ok(Math.abs(hit.point_mm[2] - 1) < 1e-6);
  }
});

test('what a section opens is met on its plane', () => {
  const picker = createPicker(stock);
  const ray = { origin: [50, 5, 1], direction: [-1, 0, 0] };
  const whole = stockHit(stock, picker, [0, 0, 0, 1], ray);
  assert.equal(whole.cell, 1);
  assert.ok(Math.abs(whole.point_mm[0] - 9) < 1e-6);
  const cut = stockHit(stock, picker, [-1, 0, 0, 6], ray);
  assert.equal(cut.cell, null);
  assert.deepEqual(cut.point_mm, [6, 5, 1]);
  assert.equal(stockHit(stock, picker, [-1, 0, 0, 6], { ...ray, origin: [50, 5, 20] }), null);
});

test('a section of triangles is what a plane cuts of them', () => {
  const pieces = cutCurve(stock, new Float32Array(5), 2, 2.5)
    .filter(({ from, to }) => Math.hypot(...from.map((c, k) => c - to[k])) > 1e-9);
  const span = pieces.reduce((sum, { from, to }) => sum + Math.hypot(to[0] - from[0], to[1] - from[1]), 0);
  assert.ok(Math.abs(span - 20) < 1e-5);
});

test('a path can be coloured by its lines, where it has any', () => {
  const drawn = {
    kind: Uint8Array.of(0, 1, 1), line: Uint32Array.of(3, 7, 12), feed_mm_min: Float32Array.of(0, 5, 5),
    end_s: Float32Array.of(1, 2, 3), rate_mm3_min: null,
  };
  const choice = (path) => colourChoices(path).find(({ key }) => key === 'line');
  assert.deepEqual([choice(drawn).low, choice(drawn).high], [7, 12]);
  assert.ok(choice({ ...drawn, line: new Uint32Array(3) }).reason);
});

test('a stock whose makers are too few is refused', () => {
  const block = (count) => ({ at: 0, count, type: 'u32', order: 0 });
  const json = { position: { block: block(9), step_mm: 1 }, triangle: block(3), maker: block(0), move: block(1),
    line: block(1) };
  assert.throws(() => decodeStock(json, new Blob32(new Uint8Array(64))), /another number of makers/);
});
