import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createPicker } from '../src/view/scene/pick.js';
import { readingAt } from '../src/view/reading.js';
import { sampleReport } from './sample.js';

const report = sampleReport();
const [surface] = report.surfaces;
const { field } = report.stages[1];
const picker = createPicker(surface);
const down = (x, y) => ({ origin: [x, y, 50], direction: [0, 0, -1] });

test('a ray from above meets the surface where it stands', () => {
  for (let k = 0; k < 200; ++k) {
    const x = (k * 0.618034 * 40) % 40, y = (k * 0.754878 * 20) % 20;
    const hit = picker.first(down(x, y));
    assert.ok(hit, `${x}, ${y}`);
    // Chords of 0.5 mm on curvature up to 2 / 25 + 2 / 36 a mm.
    assert.ok(Math.abs(hit.point_mm[2] - 2 * Math.sin(x / 6) * Math.cos(y / 5)) < 0.01);
    assert.ok(Math.abs(hit.weights.reduce((a, b) => a + b) - 1) < 1e-12);
  }
});

test('a ray beside the surface meets nothing', () => {
  assert.equal(picker.first(down(-1, 5)), null);
  assert.equal(picker.first({ origin: [20, 10, 50], direction: [0, 0, 1] }), null);
});

test('the tree finds what trying every cell finds', () => {
  for (let k = 0; k < 40; ++k) {
    const angle = k * 2.399;
    const ray = { origin: [20 + 60 * Math.cos(angle), 10 + 60 * Math.sin(angle), 12],
      direction: [-Math.cos(angle), -Math.sin(angle), -0.2 + 0.002 * k] };
    const hit = picker.first(ray);
    let best = null;
    for (let at = 0; at < surface.cells.length; at += 4) {
      const cells = surface.cells.subarray(at, at + 4);
      const one = createPicker({ positions: surface.positions, cells }).first(ray);
      if (one && (!best || distance(ray, one) < distance(ray, best))) best = one;
    }
    assert.deepEqual(hit?.point_mm, best?.point_mm);
  }
  function distance(ray, hit) {
    return Math.hypot(...hit.point_mm.map((c, axis) => c - ray.origin[axis]));
  }
});

test('what a section takes away is not hit', () => {
  const ray = { origin: [-10, 2, 1], direction: [1, 0, 0] };
  // 2 sin(x / 6) cos(0.4) is 1 at x = 3.4 and 15.4.
  assert.ok(Math.abs(picker.first(ray).point_mm[0] - 3.44) < 0.05);
  assert.ok(Math.abs(picker.first(ray, (point) => point[0] > 10).point_mm[0] - 15.41) < 0.05);
  assert.equal(picker.first(ray, (point) => point[0] > 20 && point[0] < 30), null);
});

test('at a sample the reading is the sample', () => {
  for (const sample of [0, 5, 42, 900, 1700, 2500, surface.positions.length / 3 - 1]) {
    const [x, y] = surface.positions.subarray(3 * sample, 3 * sample + 2);
    const inside = (c, end) => Math.min(Math.max(c, 1e-4), end - 1e-4);
    const reading = readingAt(surface, field, picker.first(down(inside(x, 40), inside(y, 20))));
    assert.ok(Math.abs(reading.deviation_mm - field.deviation_mm[sample]) < 1e-4);
    assert.equal(reading.sample_deviation_mm, field.deviation_mm[reading.sample]);
    assert.equal(reading.line, field.line[reading.sample]);
    assert.equal(reading.patch, x < 20 || sample < 1681 ? 0 : 1);
  }
});

test('between samples the deviation is interpolated and u, v run on', () => {
  const reading = readingAt(surface, field, picker.first(down(10.1, 10.05)));
  assert.ok(Math.abs(reading.u - 10.1 / 20) < 1e-6);
  assert.ok(Math.abs(reading.v - 10.05 / 20) < 1e-6);
  const exact = 0.004 * Math.sin(10.1) - 0.05 * Math.exp(-(0.1 ** 2 + 0.05 ** 2) / 2);
  // Chords of 0.5 mm on a bump of 0.05 mm with second derivatives up to 0.05 a mm.
  assert.ok(Math.abs(reading.deviation_mm - exact) < 0.05 * 0.5 ** 2 / 4);
});

test('places that the cutter cannot reach say so', () => {
  assert.equal(readingAt(surface, field, picker.first(down(39.9, 10))).reachable, false);
  assert.equal(readingAt(surface, field, picker.first(down(30, 10))).reachable, true);
});
