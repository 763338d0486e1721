// The tool of a path that turns it as it goes, at the slider's place.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { zigzag } from './support/sample.mjs';
import { distance, part, settle, showPath, showStage } from './support/view.mjs';

const browser = await openBrowser();
/** The sample's second stage; its axes are those of turning_result() in tests/reports/sample_result.h. */
const moves = zigzag(0.25);
const radians = (degrees) => (degrees * Math.PI) / 180;
const axisAfter = (move) => (move < 0 ? [0, 0, 1]
  : [Math.sin(radians(20)) * Math.cos(radians(move)), Math.sin(radians(20)) * Math.sin(radians(move)),
    Math.cos(radians(20))]);

/** Where the tool's tip is and how it stands at a time: a place and a unit vector, each by its own share. */
function poseAt(time_s) {
  const k = moves.findIndex((move) => move.end_s >= time_s);
  const from = k > 0 ? moves[k - 1] : { to: [-42, -34, 15], end_s: 0 };
  const share = (time_s - from.end_s) / (moves[k].end_s - from.end_s), a = axisAfter(k - 1), b = axisAfter(k);
  const angle = Math.acos(a.reduce((sum, c, i) => sum + c * b[i], 0));
  const mixed = a.map((c, i) =>
    (Math.sin((1 - share) * angle) * c + Math.sin(share * angle) * b[i]) / Math.sin(angle));
  return { tip_mm: from.to.map((c, i) => c + share * (moves[k].to[i] - c)), axis: mixed };
}

const figure = (page, name) => part(page, 'path-readout').locator(`[data-figure="${name}"]`);
const numbers = (text) => text.replaceAll('\u2212', '-').match(/-?\d[\d.]*/g).map(Number);

async function goTo(page, time_s) {
  await part(page, 'path-time').fill(String(time_s));
  await settle(page);
  return page.evaluate(() => window.limitgauge.view.path.state());
}

test('the tool is drawn with its tip at the place and its axis as it stands there', () =>
  withReport(browser, 'turning', {}, async (page) => {
    await showStage(page, 1);
    await showPath(page);
    const step = Number(await part(page, 'path-time').getAttribute('step'));
    // The first is on the first move, which leans the tool over from +Z.
    for (const wanted_s of [0.01, 100, 333.3, 1200].map((s) => Math.min(s, 0.9 * moves.at(-1).end_s))) {
      const time_s = Number((Math.max(1, Math.round(wanted_s / step)) * step).toFixed(6));
      const { tip_mm, axis } = poseAt(time_s), { tool_matrix: m } = await goTo(page, time_s);
      // Row after row: where the body's Z goes, and its tip.
      assert.ok(distance([m[2], m[6], m[10]], axis) < 1e-3, `${time_s} s: ${[m[2], m[6], m[10]]} for ${axis}`);
      assert.ok(distance([m[3], m[7], m[11]], tip_mm) < 0.02, `${time_s} s: ${[m[3], m[7], m[11]]}`);
      const said = numbers(await figure(page, 'Tool axis (I, J, K)').innerText());
      assert.ok(distance(said, axis) < 1e-3, `${said} for ${axis}`);
      const [lean] = numbers(await figure(page, 'Lean from +Z').innerText());
      assert.ok(Math.abs(lean - (Math.acos(axis[2]) * 180) / Math.PI) < 0.06, `${lean}°`);
    }
    assert.match(await figure(page, 'Tool axis (I, J, K)').innerText(), /^\u2212?\d\.\d{4}, \u2212?\d\.\d{4}, \d\.\d{4}$/);
  }));

test('an upright stage of the same page stays upright and says nothing of an axis', () =>
  withReport(browser, 'turning', {}, async (page) => {
    await showStage(page, 0);
    await showPath(page);
    const { tool_matrix: m, now } = await goTo(page, 20);
    assert.deepEqual([0, 1, 2, 4, 5, 6, 8, 9, 10].map((i) => m[i]), [1, 0, 0, 0, 1, 0, 0, 0, 1]);
    assert.equal(now.axis, null);
    assert.equal(await figure(page, 'Lean from +Z').count(), 0);
  }));
