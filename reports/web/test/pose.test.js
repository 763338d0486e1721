import assert from 'node:assert/strict';
import { test } from 'node:test';

import { cutterOutline, joined, shaftOutlines, wireBody } from '../src/path/cutter.js';
import { leanDegrees, poseMatrix, turnedAxis } from '../src/path/pose.js';
import { instant, stepTime } from '../src/path/timeline.js';

const close = (a, b, within = 1e-12) => a.length === b.length && a.every((c, i) => Math.abs(c - b[i]) <= within);
const leaning = (degrees) => [Math.sin((degrees * Math.PI) / 180), 0, Math.cos((degrees * Math.PI) / 180)];
const length = (a) => Math.hypot(...a);
const dot = (a, b) => a.reduce((sum, c, i) => sum + c * b[i], 0);

/** Directions all over the sphere. */
function* directions() {
  for (let i = 0; i < 60; ++i) {
    const z = 1 - (2 * (i + 0.5)) / 60, r = Math.sqrt(1 - z * z);
    yield [r * Math.cos(2.4 * i), r * Math.sin(2.4 * i), z];
  }
}

/** Two cuts along X, over which the tool leans over to +X by 60 degrees and comes back to 20, 2 and 4 s. */
function turningPath() {
  const axes = [leaning(60), leaning(20)];
  const part = (k) => Float32Array.from(axes.map((a) => a[k]));
  return {
    moves: 2, within_mm: 0, start_mm: [0, 0, 0], positions: Float32Array.from([20, 0, 0, 30, 0, 0]),
    axis: { start: [0, 0, 1], x: part(0), y: part(1), z: part(2) },
    kind: Uint8Array.from([1, 1]), feed_mm_min: Float32Array.from([600, 150]), rate_mm3_min: null,
    line: Uint32Array.from([3, 4]), move: Uint32Array.from([0, 1]), end_s: Float32Array.from([2, 6]),
  };
}

test('between two directions the tool turns evenly along the great circle', () => {
  for (const share of [0, 0.25, 0.5, 0.9, 1])
    assert.ok(close(turnedAxis(leaning(-10), leaning(70), share), leaning(-10 + 80 * share)), `${share}`);
  const all = [...directions()];
  for (const a of all)
    for (const b of all.slice(0, 7)) {
      const angle = Math.acos(Math.min(1, Math.max(-1, dot(a, b)))), third = turnedAxis(a, b, 1 / 3);
      assert.ok(Math.abs(length(third) - 1) < 1e-12);
      assert.ok(Math.abs(Math.acos(Math.min(1, dot(a, third))) - angle / 3) < 1e-7, 'a third of the angle');
      const normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
      assert.ok(Math.abs(dot(normal, third)) < 1e-12, 'in the plane of both');
    }
});

test('the same direction stays, opposite ones have no way between them', () => {
  assert.deepEqual(turnedAxis([0, 0.6, 0.8], [0, 0.6, 0.8], 0.3), [0, 0.6, 0.8]);
  assert.deepEqual([0.2, 0.7].map((share) => turnedAxis([0, 0, 1], [0, 0, -1], share)), [[0, 0, 1], [0, 0, -1]]);
  // Smaller than the page's numbers tell apart, but a turn.
  assert.ok(close(turnedAxis([0, 0, 1], [1e-6, 0, 1], 0.5), [5e-7, 0, 1]));
});

test('the axis at a time, the start among its ends', () => {
  const path = turningPath();
  for (const [time_s, degrees] of [[0, 0], [1, 30], [2, 60], [3, 50], [6, 20], [99, 20]])
    assert.ok(close(instant(path, time_s).axis, leaning(degrees), 1e-6), `${time_s} s`);
  const { axis, ...upright } = path;
  assert.equal(instant(upright, 1).axis, null);
});

test('a turn about the tip takes no time and does not hold up the steps', () => {
  const path = { ...turningPath(), end_s: Float32Array.from([2, 2, 2, 5]) };
  assert.equal(stepTime(path, 0, 1), 2);
  assert.equal(stepTime(path, 2, 1), 5);
});

test('the lean is from +Z', () => {
  for (const degrees of [0, 0.01, 45, 90, 135, 180])
    assert.ok(Math.abs(leanDegrees(leaning(degrees)) - degrees) < 1e-9);
});

test('a pose is a turn that brings Z to the axis and the origin to the tip', () => {
  for (const axis of [...directions(), [0, 0, 1], [0, 0, -1], [1, 0, 0]]) {
    const m = poseMatrix([7, -8, 9], axis), column = (k) => m.slice(4 * k, 4 * k + 3);
    assert.deepEqual(column(2), axis);
    assert.deepEqual([column(3), m[3], m[7], m[11], m[15]], [[7, -8, 9], 0, 0, 0, 1]);
    for (let a = 0; a < 3; ++a)
      for (let b = 0; b < 3; ++b)
        assert.ok(Math.abs(dot(column(a), column(b)) - (a === b ? 1 : 0)) < 1e-12, `${axis}: ${a}, ${b}`);
    const [x, y, z] = [0, 1, 2].map(column);
    const cross = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
    assert.ok(close(cross, z, 1e-12), 'no mirror');
  }
  assert.deepEqual(poseMatrix([0, 0, 0], [0, 0, 1]).map((c) => c + 0),
    [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
});

test('shank and holder stand on the cutter, each part on the one below', () => {
  const cutter = { type: 'flat', diameter_mm: 8, flute_length_mm: 25, shank: [{ diameter_mm: 8, length_mm: 15 }],
    holder: [{ diameter_mm: 30, length_mm: 20 }, { diameter_mm: 50, length_mm: 10 }] };
  assert.deepEqual(shaftOutlines(cutter), [[[0, 25], [4, 25], [4, 40], [0, 40]],
    [[0, 40], [15, 40], [15, 60], [0, 60]], [[0, 60], [25, 60], [25, 70], [0, 70]]]);
  assert.deepEqual(shaftOutlines({ type: 'flat', diameter_mm: 8 }), []);
  assert.deepEqual(shaftOutlines(undefined), []);
});

test('bodies of wires are joined, each wire on its own points', () => {
  const bodies = [cutterOutline({ type: 'flat', diameter_mm: 8, flute_length_mm: 5 }), [[0, 5], [9, 5], [9, 7]]]
    .map((outline) => wireBody(outline));
  const { points, lines } = joined(bodies);
  assert.deepEqual([...points], bodies.flatMap((body) => [...body.points]));
  let used = 0;
  for (let at = 0; at < lines.length; at += lines[at] + 1)
    for (let i = 1; i <= lines[at]; ++i) assert.equal(lines[at + i], used++);
  assert.equal(used, points.length / 3);
});
