import assert from 'node:assert/strict';
import { test } from 'node:test';
import { coarsened, gathered } from '../src/view/surface/coarse.js';
import { sampleReport } from './sample.js';

test('a small surface is left alone', () => {
  assert.equal(coarsened(sampleReport().surfaces[0]), null);
});

test('a large one keeps corners, borders and order with fewer cells', () => {
  const [surface] = sampleReport({ columns: 152, rows: 152 }).surfaces;
  const { surface: coarse, samples } = coarsened(surface);
  assert.ok(coarse.cells.length < surface.cells.length / 3);
  assert.ok(Math.max(...coarse.cells) < samples.length);
  assert.deepEqual([...coarse.first], [0, samples.length / 2]);
  samples.forEach((sample, k) => {
    const { u, v } = surface.place(sample);
    assert.ok(Math.abs(coarse.u[k] - u) < 1e-12 && Math.abs(coarse.v[k] - v) < 1e-12);
    assert.equal(coarse.positions[3 * k], surface.positions[3 * sample]);
  });
  const area = (mesh) => {
    let sum = 0;
    for (let at = 0; at < mesh.cells.length; at += 4) {
      const [a, , c] = mesh.cells.subarray(at, at + 4);
      const [width, height] = [0, 1].map((k) => mesh.positions[3 * c + k] - mesh.positions[3 * a + k]);
      sum += width * height;
    }
    return sum;
  };
  assert.ok(Math.abs(area(coarse) - 800) < 1e-3, String(area(coarse)));
});

test('values are gathered by sample', () => {
  assert.deepEqual([...gathered(Float32Array.of(1, 2, 3, 4), [3, 1])], [4, 2]);
  assert.deepEqual([...gathered(Float32Array.of(1, 2, 3, 4), [1], 2)], [3, 4]);
});
