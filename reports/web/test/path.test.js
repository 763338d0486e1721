import assert from 'node:assert/strict';
import { test } from 'node:test';

import { cutterOutline, standing, wireBody } from '../src/path/cutter.js';
import { pathGeometry, TRAIT_COMPONENTS, vertexColours } from '../src/path/geometry.js';
import { createPlayer } from '../src/path/player.js';
import {
  duration, instant, segmentAt, segmentOfMove, sliderScale, stepTime, usualSpeed,
} from '../src/path/timeline.js';
import { colourChoices, exactness, legendTicks, quantileInTime, shareOf } from '../src/path/values.js';
import { viridis } from '../src/path/viridis.js';
import { clockText } from '../src/base/figure_text.js';
import { sampleReport } from './sample.js';

/** A rapid down, two cuts along X, a rapid up: 1, 2, 4 and 1 s. */
function smallPath() {
  return {
    moves: 9, within_mm: 0.004, start_mm: [0, 0, 10],
    positions: Float32Array.from([0, 0, 0, 20, 0, 0, 30, 0, 0, 30, 0, 10]),
    kind: Uint8Array.from([0, 1, 1, 0]),
    feed_mm_min: Float32Array.from([5000, 600, 150, 5000]),
    rate_mm3_min: Float32Array.from([0, 300, 60, 0]),
    line: Uint32Array.from([3, 4, 7, 8]), move: Uint32Array.from([0, 2, 6, 8]),
    end_s: Float32Array.from([1, 3, 7, 8]),
  };
}

test('a segment is found by its time, ends belong to the segment that they end', () => {
  const path = smallPath();
  assert.equal(duration(path), 8);
  assert.deepEqual([0, 0.5, 1, 1.01, 3, 6.9, 7.5, 8, 99].map((t) => segmentAt(path, t)),
    [0, 0, 0, 1, 1, 2, 3, 3, 3]);
});

test('the tool moves evenly along a segment', () => {
  const path = smallPath();
  assert.deepEqual(instant(path, 0).point_mm, [0, 0, 10]);
  assert.deepEqual(instant(path, 2).point_mm, [10, 0, 0]);
  assert.deepEqual(instant(path, 4).point_mm, [22.5, 0, 0]);
  const now = instant(path, 4);
  assert.deepEqual([now.line, now.move, now.feed_mm_min, now.rate_mm3_min, now.kind],
    [7, 6, 150, 60, 'feed']);
  assert.equal(instant(path, 0.2).kind, 'rapid');
  assert.deepEqual(instant(path, 99).point_mm, [30, 0, 10]);
  assert.equal(instant({ ...path, rate_mm3_min: null }, 4).rate_mm3_min, null);
});

test('steps go from end to end of segments and stay inside the path', () => {
  const path = smallPath();
  const forward = [0], back = [8];
  for (let i = 0; i < 5; ++i) forward.push(stepTime(path, forward[i], 1));
  for (let i = 0; i < 5; ++i) back.push(stepTime(path, back[i], -1));
  assert.deepEqual(forward, [0, 1, 3, 7, 8, 8]);
  assert.deepEqual(back, [8, 7, 3, 1, 0, 0]);
  assert.equal(stepTime(path, 2, 1), 3);
  assert.equal(stepTime(path, 2, -1), 1);
});

test('a move of the program is found in the segment that took it in', () => {
  const path = smallPath();
  assert.deepEqual([0, 1, 2, 3, 6, 7, 8, 9].map((m) => segmentOfMove(path, m)), [0, 1, 1, 2, 2, 3, 3, -1]);
});

test('the slider has 500 to 1250 round steps and reaches the end', () => {
  for (const total of [0.3, 1, 7.25, 59, 60, 333.3, 1234.5, 3600, 86399, 5e5]) {
    const { step_s, max_s, decimals } = sliderScale(total);
    const steps = max_s / step_s;
    assert.ok(steps >= 500 - 1e-6 && steps <= 1251, `${total}: ${steps} steps`);
    assert.ok(max_s >= total - 1e-6 * total && max_s < total + step_s, `${total}: ends at ${max_s}`);
    assert.ok(Math.abs(steps - Math.round(steps)) < 1e-6, `${total}: the end is off the steps`);
    assert.ok(['1', '2', '5'].includes(step_s.toExponential()[0]), `${total}: ${step_s}`);
    assert.equal(Number(step_s.toFixed(decimals)), step_s);
  }
  assert.deepEqual(sliderScale(0), { step_s: 1, max_s: 0, decimals: 0 });
});

test('the usual speed plays a path in about half a minute', () => {
  const speeds = [1, 5, 20, 60, 200, 600, 2000];
  assert.deepEqual([5, 30, 150, 1800, 36000].map((s) => usualSpeed(s, speeds)), [1, 1, 5, 60, 2000]);
});

test('geometry: two vertices a segment, time and kind on both, the way along rapids', () => {
  const path = smallPath();
  const { points, traits, lines } = pathGeometry(path);
  assert.deepEqual(Array.from(lines), [2, 0, 1, 2, 2, 3, 2, 4, 5, 2, 6, 7]);
  assert.deepEqual(Array.from(points.subarray(0, 12)), [0, 0, 10, 0, 0, 0, 0, 0, 0, 20, 0, 0]);
  const trait = (vertex) =>
    Array.from(traits.subarray(TRAIT_COMPONENTS * vertex, TRAIT_COMPONENTS * (vertex + 1)));
  assert.deepEqual([0, 1, 2, 3, 6, 7].map(trait),
    [[0, 0, 0], [1, 0, 10], [1, 1, 0], [3, 1, 0], [7, 0, 0], [8, 0, 10]]);
});

test('geometry: every segment of a longer path joins the one before', () => {
  const { path } = sampleReport().stages[0];
  const { points } = pathGeometry(path);
  for (let i = 1; i < path.end_s.length; ++i)
    assert.deepEqual(points.subarray(6 * i, 6 * i + 3), points.subarray(6 * i - 3, 6 * i));
});

test('colours stand on both vertices of a segment', () => {
  assert.deepEqual(Array.from(vertexColours(2, (i) => [i, 2, 3])), [0, 2, 3, 0, 2, 3, 1, 2, 3, 1, 2, 3]);
});

test('the colour scale goes from dark to bright and holds its ends', () => {
  assert.deepEqual(viridis(0), [68, 1, 84]);
  assert.deepEqual(viridis(1), [253, 231, 37]);
  assert.deepEqual(viridis(-3), viridis(0));
  assert.deepEqual(viridis(7), viridis(1));
  const lightness = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
  for (let i = 1; i <= 100; ++i) assert.ok(lightness(viridis(i / 100)) > lightness(viridis((i - 1) / 100)));
});

test('what the path may be coloured by, with the ends of the scale', () => {
  const [order, feed, rate] = colourChoices(smallPath());
  assert.deepEqual([order.low, order.high], [0, 8]);
  assert.deepEqual([feed.low, feed.high], [150, 600], 'rapids do not stretch the scale');
  assert.deepEqual([rate.low, rate.high, rate.clipped], [0, 300, false]);
  assert.equal(shareOf(feed, 375), 0.5);
  assert.equal(shareOf(feed, 5000), 1);
  assert.deepEqual(legendTicks(feed, 5), [150, 262.5, 375, 487.5, 600]);
});

test('a short peak of the removal rate does not stretch its scale', () => {
  const path = { ...smallPath(), end_s: Float32Array.from([1, 1.01, 7, 8]) };
  const rate = colourChoices(path)[2];
  assert.deepEqual([rate.high, rate.clipped], [60, true]);
  assert.equal(quantileInTime(path, path.rate_mm3_min, 1), 300);
});

test('a choice without figures says why', () => {
  const reason = (changed, index) => colourChoices({ ...smallPath(), ...changed })[index].reason;
  assert.match(reason({ rate_mm3_min: null }, 2), /no removal rates/);
  assert.match(reason({ rate_mm3_min: new Float32Array(4) }, 2), /removes nothing/);
  assert.match(reason({ kind: new Uint8Array(4) }, 1), /no feed moves/);
});

test('a scale without length has one mark', () => {
  const feed = colourChoices({ ...smallPath(), feed_mm_min: Float32Array.from([9, 600, 600, 9]) })[1];
  assert.deepEqual(legendTicks(feed, 5), [600]);
  assert.equal(shareOf(feed, 600), 0.5);
});

test('how exact the drawn path is', () => {
  assert.equal(exactness(smallPath()),
    '4 lines are drawn for the 9 moves of the program: every move lies within 4 \u00b5m of what is drawn.');
  assert.match(exactness({ ...smallPath(), within_mm: 0.03812 }), /within 39 \u00b5m of/, 'never less than it is');
  assert.match(exactness({ ...smallPath(), within_mm: 0.25 }), /within 0.25 mm of/);
  assert.equal(exactness({ ...smallPath(), within_mm: 0, moves: 97689 }),
    'All 97\u202f689 moves of the program are drawn.');
});

test('machining time in words', () => {
  assert.deepEqual([0, 12.44, 59.96, 185.25, 3599.96, 3661].map((s) => clockText(s)),
    ['0.0 s', '12.4 s', '1 min 00.0 s', '3 min 05.3 s', '1 h 00 min 00.0 s', '1 h 01 min 01 s']);
  assert.equal(clockText(185.25, 0), '3 min 05 s');
});

test('outlines of cutters start at the tip and have their radius', () => {
  const ball = cutterOutline({ type: 'ball', diameter_mm: 6, corner_radius_mm: 3, flute_length_mm: 20 });
  for (const [radius, z] of ball.slice(0, -2)) assert.ok(Math.abs(Math.hypot(radius, z - 3) - 3) < 1e-12);
  assert.deepEqual(ball.slice(-1), [[0, 20]]);
  assert.deepEqual(cutterOutline({ type: 'flat', diameter_mm: 8, flute_length_mm: 25 }),
    [[0, 0], [4, 0], [4, 25], [0, 25]]);
  const drill = cutterOutline({ type: 'drill', diameter_mm: 10, tip_angle_deg: 45, flute_length_mm: 30 });
  assert.ok(Math.abs(drill[1][0] - 5) < 1e-12 && Math.abs(drill[1][1] - 5) < 1e-12);
  const taper = cutterOutline(
    { type: 'taper', diameter_mm: 2, corner_radius_mm: 1, taper_angle_deg: 10, flute_length_mm: 11 });
  const [radius, z] = taper[taper.length - 3], [top] = taper[taper.length - 2];
  const lean = (top - radius) / (11 - z);
  assert.ok(Math.abs(lean - Math.tan(Math.PI / 18)) < 1e-9, 'the side leans by its angle');
  assert.ok(Math.abs(Math.hypot(radius, z - 1) - 1) < 1e-9, 'the side begins on the rounding');
  assert.equal(cutterOutline(undefined), null);
});

test('the wires of a cutter lie on it', () => {
  const { points, lines } = wireBody(cutterOutline({ type: 'ball', diameter_mm: 6, corner_radius_mm: 3 }));
  for (let i = 0; i < points.length; i += 3) assert.ok(Math.hypot(points[i], points[i + 1]) <= 3 + 1e-6);
  let vertices = 0;
  for (let at = 0; at < lines.length; at += lines[at] + 1) vertices += lines[at];
  assert.equal(3 * vertices, points.length);
});

test('the player advances by wall clock times speed and stops when told', () => {
  const frames = [];
  const requestFrame = (callback) => frames.push(callback);
  const passed = [];
  const player = createPlayer((s) => passed.push(s) < 3, { requestFrame, cancelFrame: () => frames.pop() });
  player.setSpeed(20);
  player.start();
  for (const now of [1000, 1050, 1150]) frames.shift()(now);
  assert.deepEqual(passed, [0, 1, 2]);
  assert.equal(player.playing(), false);
  player.start();
  assert.equal(player.playing(), true);
  player.stop();
  assert.deepEqual([player.playing(), frames.length], [false, 0]);
});

test('a tool stands in the part as its setup has it', () => {
  const upright = Float32Array.from([1, 2, 3, 0, 0, 10]);
  const over = [[1, 0, 0], [0, -1, 0], [0, 0, -1]];
  assert.deepEqual([...standing(upright, over)], [1, -2, -3, 0, 0, -10]);
  // The part is turned by a quarter about X into the machine: the tool comes along its Y.
  const side = [[1, 0, 0], [0, 0, -1], [0, 1, 0]];
  assert.deepEqual([...standing(upright, side)], [1, 3, -2, 0, 10, 0]);
});
