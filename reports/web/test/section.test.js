import assert from 'node:assert/strict';
import { test } from 'node:test';
import { cutCurve, magnification } from '../src/view/section/section.js';
import { sampleReport } from './sample.js';

const report = sampleReport();
const [surface] = report.surfaces;
const { deviation_mm } = report.stages[1].field;
const height = (x, y) => 2 * Math.sin(x / 6) * Math.cos(y / 5);

test('a cut lies in its plane, on the surface, and runs right across', () => {
  for (const [axis, offset] of [[0, 12.3], [0, 20], [1, 7.77], [1, 10]]) {
    const pieces = cutCurve(surface, deviation_mm, axis, offset);
    let span = 0;
    for (const { from, to } of pieces) {
      for (const [x, y, z] of [from, to]) {
        assert.equal([x, y, z][axis], offset);
        assert.ok(Math.abs(z - height(x, y)) < 0.01);
      }
      span += Math.abs(from[1 - axis] - to[1 - axis]);
    }
    assert.ok(Math.abs(span - (axis === 0 ? 20 : 40)) < 1e-4, `${axis} ${offset} ${span}`);
  }
});

test('deviations along a cut are those of the surface', () => {
  for (const { from, deviation_mm: [deviation] } of cutCurve(surface, deviation_mm, 1, 10)) {
    const [x] = from;
    const exact = 0.004 * Math.sin(x) - 0.05 * Math.exp(-((x - 10) ** 2) / 2)
      + 0.03 * Math.exp(-((x - 30) ** 2 + 25) / 2);
    assert.ok(Math.abs(deviation - exact) < 0.004);
  }
});

test('beside the part there is nothing to cut', () => {
  assert.deepEqual(cutCurve(surface, deviation_mm, 0, -1), []);
  assert.deepEqual(cutCurve(surface, deviation_mm, 2, 5), []);
});

test('deviations are magnified to a share of the part by a round factor', () => {
  assert.equal(magnification(0.05, 45), 50);
  assert.equal(magnification(0.001, 100), 5000);
  assert.equal(magnification(100, 45), 1);
  assert.equal(magnification(0, 45), 1);
});
