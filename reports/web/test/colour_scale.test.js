import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BAND, colour, gateSide, position, roundedUp, scaleFor, ticks_mm } from '../src/view/colour/colour_scale.js';

const stage = {
  limits: { gouge_mm: 0.01, uncut_mm: 0.02 },
  gouge_mm: { low: 0.049, high: 0.05 }, uncut_mm: { low: 0.029, high: 0.03 },
};

test('full scales are 1, 2, 5 times a power of ten', () => {
  assert.deepEqual([0.011, 0.02, 0.021, 0.5, 7].map(roundedUp).map((v) => Number(v.toPrecision(12))),
    [0.02, 0.02, 0.05, 0.5, 10]);
});

test('a side reaches at least to twice its limit and to what was measured', () => {
  assert.deepEqual(gateSide(0.01, 0.005), { limit_mm: 0.01, end_mm: 0.02, hasLimit: true });
  assert.equal(gateSide(0.01, 0.03).end_mm.toPrecision(6), '0.0500000');
  assert.equal(gateSide(undefined, 0.03).hasLimit, false);
  assert.equal(gateSide(0, 0).end_mm, 1e-6);
});

test('limits stand in the middle of their side, ends at one', () => {
  const scale = scaleFor(stage);
  assert.equal(position(scale, -0.01), -0.5);
  assert.equal(position(scale, 0.02), 0.5);
  assert.equal(position(scale, 0), 0);
  assert.equal(position(scale, -1), -1);
  assert.ok(Math.abs(position(scale, -0.03) + 0.75) < 1e-12);
  assert.deepEqual(ticks_mm(scale), [-0.05, -0.01, 0, 0.02, 0.04]);
});

test('the colour jumps at the limit, which itself still passes', () => {
  const scale = scaleFor(stage);
  assert.deepEqual(colour(scale, 0), [247, 247, 247]);
  assert.deepEqual(colour(scale, 0.02), [244, 165, 130]);
  assert.deepEqual(colour(scale, -0.01), [146, 197, 222]);
  colour(scale, 0.02 + 1e-9).forEach((c, k) => assert.ok(Math.abs(c - [214, 96, 77][k]) < 1e-3));
  colour(scale, -0.01 - 1e-9).forEach((c, k) => assert.ok(Math.abs(c - [67, 147, 195][k]) < 1e-3));
  assert.deepEqual(colour(scale, 9), [103, 0, 31]);
  assert.deepEqual(colour(scale, -9), [5, 48, 97]);
});

test('without a limit there is no jump', () => {
  const scale = scaleFor({ limits: {}, gouge_mm: { high: 0.1 }, uncut_mm: { high: 0.1 } });
  const near = colour(scale, 0.05 + 1e-9);
  colour(scale, 0.05).forEach((c, k) => assert.ok(Math.abs(c - near[k]) < 1e-3));
  assert.deepEqual(colour(scale, 0.1), [103, 0, 31]);
});

test('the range as measured is the same on both sides; an own one keeps a limit inside it', () => {
  const measured = scaleFor(stage, { range: 'measured' });
  assert.deepEqual(measured.gouge, measured.uncut);
  assert.equal(measured.gouge.hasLimit, false);
  const own = scaleFor(stage, { range: 'own', ownGouge_mm: 0.1, ownUncut_mm: 0.005 });
  assert.deepEqual(own.gouge, { limit_mm: 0.01, end_mm: 0.1, hasLimit: true });
  assert.equal(own.uncut.hasLimit, false);
  assert.equal(own.uncut.end_mm, 0.005);
});

test('the band is one colour within the limits and nothing beyond', () => {
  const scale = scaleFor(stage);
  assert.deepEqual(colour(scale, 0.02, true), BAND);
  assert.deepEqual(colour(scale, -0.003, true), BAND);
  assert.notDeepEqual(colour(scale, 0.021, true), BAND);
});
