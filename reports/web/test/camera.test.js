import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  axes, between, corners, firstView, fitted, project, ray, VIEWS, zoomed,
} from '../src/view/scene/camera.js';
import { dot, length, subtract } from '../src/base/vector.js';

const size = { width: 800, height: 500 };
const box = corners([[0, 0, -2], [40, 20, 2]]);

test('the named views look where they say', () => {
  const near = (a, b) => a.forEach((c, k) => assert.ok(Math.abs(c - b[k]) < 1e-12));
  near(axes(VIEWS.top).back, [0, 0, 1]);
  near(axes(VIEWS.top).up, [0, 1, 0]);
  near(axes(VIEWS.front).right, [1, 0, 0]);
  near(axes(VIEWS.right).right, [0, 1, 0]);
});

test('a fitted camera shows all corners of the box', () => {
  for (const view of Object.values(VIEWS)) {
    const camera = fitted(view, box, size);
    let spread = 0;
    for (let k = 0; k < 8; ++k) {
      const { x, y } = project(camera, size, box[k]);
      assert.ok(x > 0 && x < size.width && y > 0 && y < size.height);
      const aside = [x / size.width, y / size.height].map((share) => Math.abs(share - 0.5));
      spread = Math.max(spread, ...aside);
    }
    assert.ok(spread > 0.35, 'and does not leave it small');
  }
});

test('the ray through a projected point passes it', () => {
  for (const view of Object.values(VIEWS)) {
    const camera = fitted(view, box, size);
    const point = [7, 13, 1.5];
    const { x, y } = project(camera, size, point);
    const { origin, direction } = ray(camera, size, x, y, 45);
    const from = subtract(point, origin);
    const along = dot(from, direction) / dot(direction, direction);
    assert.ok(along > 0);
    assert.ok(length(subtract(from, direction.map((c) => c * along))) < 1e-9);
  }
});

test('zooming keeps what is under the pointer', () => {
  const camera = fitted(VIEWS.top, box, size);
  const before = project(camera, size, [30, 5, 0]);
  const after = project(zoomed(camera, size, 3, before.x, before.y, 45), size, [30, 5, 0]);
  assert.ok(Math.hypot(after.x - before.x, after.y - before.y) < 1e-9);
});

test('between two cameras angles go the short way', () => {
  const from = { ...fitted(VIEWS.top, box, size), azimuth: 170 };
  const middle = between(from, { ...from, azimuth: -170 }, 0.5);
  assert.equal(middle.azimuth, 180);
});

test('a stage is first seen from where its tool comes', () => {
  assert.equal(firstView({}), 'perspective');
  assert.equal(firstView({ setup: { rotation: [[1, 0, 0], [0, -1, 0], [0, 0, -1]] } }), 'below');
  assert.equal(firstView({ setup: { rotation: [[1, 0, 0], [0, 0, -1], [0, 1, 0]] } }), 'perspective');
  assert.ok(axes(VIEWS.below).back[2] < -0.5);
  assert.ok(Math.abs(axes(VIEWS.bottom).back[2] + 1) < 1e-12);
});
