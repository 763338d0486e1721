// What the page says of the place under the pointer is what was measured there.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { resultOf } from './support/pages.mjs';
import { deviationAt, lineOf, pointAt, shapes } from './support/sample.mjs';
import { distance, onScreen, press, readAt, showCanvas, showStage } from './support/view.mjs';

const browser = await openBrowser();
/** Deviations are kept with 13 significant bits. */
const kept = 2 ** -13;

function near(value, expected, tolerance, what) {
  assert.ok(Math.abs(value - expected) <= tolerance, `${what}: ${value} for ${expected} ± ${tolerance}`);
}

/** Points at a finding of result.json and compares what is read there with it. */
async function expectFinding(page, id, finding, tolerance_mm) {
  const sign = id.startsWith('G') ? -1 : 1;
  await page.evaluate(([stage, id]) => window.limitgauge.view.choose(stage, id), [finding.of, id]);
  await showCanvas(page);
  const at = [finding.x, finding.y, finding.z];
  const read = await readAt(page, await onScreen(page, at));
  assert.ok(read, `${id}: something is under the pointer`);
  near(read.deviation_mm, sign * finding.depth_mm, tolerance_mm, `${id}: deviation, mm`);
  assert.ok(distance(read.point_mm, at) <= 0.1, `${id}: ${read.point_mm} for ${at}`);
  assert.equal(read.patch, finding.patch);
  near(read.u, finding.u, 0.02, 'u');
  near(read.v, finding.v, 0.02, 'v');
  assert.equal(read.line, finding.line);
}

test('over the worst gouge of the sample: depth, place, patch and line of result.json', () =>
  withReport(browser, 'failed', {}, async (page) => {
    const [worst] = resultOf('failed').stages[1].deviation.gouges;
    // A pixel off is 0.1 mm at most; the dent's floor is level.
    await expectFinding(page, 'G1', { ...worst, of: 1 }, 0.002);
  }));

test('over the groove of a real job, 60 µm deep', () =>
  withReport(browser, 'gouging', {}, async (page) => {
    const [worst] = resultOf('gouging').stages[1].deviation.gouges;
    near(worst.depth_mm, 0.06, 0.002, 'the groove');
    await expectFinding(page, 'G1', { ...worst, of: 1 }, 0.002);
  }));

test('all over the sample: the closed form of its deviation', () =>
  withReport(browser, 'failed', {}, async (page) => {
    await showStage(page, 0);
    await press(page, 'view-top');
    await showCanvas(page);
    for (let patch = 1; patch < 30; patch += 4)
      for (const [u, v] of [[0.3, 0.4], [0.775, 0.825]]) {
        const at = pointAt(patch, u, v);
        const read = await readAt(page, await onScreen(page, at));
        assert.ok(read, `something is at ${at}`);
        assert.equal(read.patch, patch);
        assert.equal(read.line, lineOf(patch));
        assert.equal(read.stage, 0);
        const [x, y] = read.point_mm;
        assert.ok(distance([x, y], at.slice(0, 2)) <= 0.15, `${x}, ${y} for ${at}, one pixel off at most`);
        // Cells are a third of a millimetre, ripples 9 mm: between samples lines are right within 2 µm.
        near(read.deviation_mm, deviationAt(x, y, shapes.rough), 0.002, `deviation at ${x}, ${y}`);
        const sample = await page.evaluate((k) => window.limitgauge.view.samples(0).at(k), read.sample);
        const exact = pointAt(sample.patch, sample.u, sample.v);
        const expected = deviationAt(exact[0], exact[1], shapes.rough);
        near(read.sample_deviation_mm, expected, kept * Math.abs(expected) + 1e-6, `sample ${read.sample}`);
        assert.ok(distance(exact, at) < 0.5, 'the sample is a corner of that cell');
      }
  }));

test('where the cutter cannot reach it says so, and beside the part it says nothing', () =>
  withReport(browser, 'failed', {}, async (page) => {
    await showStage(page, 0);
    await press(page, 'view-top');
    const canvas = await showCanvas(page);
    const hidden = await readAt(page, await onScreen(page, pointAt(5, 0.1, 0.7)));
    assert.equal(hidden.reachable, false);
    assert.equal(await readAt(page, { x: canvas.x + 4, y: canvas.y + canvas.height - 4 }), null);
  }));
