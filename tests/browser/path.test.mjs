// The toolpath over the error map and its slider in time.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { resultOf } from './support/pages.mjs';
import { zigzag } from './support/sample.mjs';
import { distance, part, settle, showPath, showStage } from './support/view.mjs';

const browser = await openBrowser();
/** The second stage of the sample: step 0.25 mm. */
const moves = zigzag(0.25);
const total_s = moves.at(-1).end_s;

async function showFinish(page) {
  await showStage(page, 1);
  await showPath(page);
}

/** The readout in numbers. */
async function readPath(page) {
  const figure = (name) => part(page, 'path-readout').locator(`[data-figure="${name}"]`).innerText();
  const numbers = (text) => (text.replaceAll('−', '-').match(/-?\d[\d.\u202f]*/g) ?? [])
    .map((t) => Number(t.replaceAll('\u202f', '')));
  const words = await figure('Feed');
  return {
    slider_s: Number(await part(page, 'path-time').inputValue()),
    line: numbers(await figure('Program line'))[0],
    tip_mm: numbers(await figure('Tool tip (X, Y, Z)')),
    feed: words,
    spoken: await part(page, 'path-time').getAttribute('aria-valuetext'),
  };
}

/** What the program does at a time, from its own moves. */
function at(time_s) {
  const index = Math.min(moves.findIndex((move) => move.end_s >= time_s), moves.length - 1);
  const k = index < 0 ? moves.length - 1 : index;
  const from = k > 0 ? moves[k - 1] : { to: [-42, -34, 15], end_s: 0 };
  const share = Math.min(1, (time_s - from.end_s) / (moves[k].end_s - from.end_s));
  return { line: moves[k].line, tip_mm: from.to.map((c, i) => c + share * (moves[k].to[i] - c)), index: k };
}

/** The readout names the line and place of its time. */
function expectInstant(read) {
  const expected = at(read.slider_s);
  assert.ok(distance(read.tip_mm, expected.tip_mm) <= 0.02, `${read.tip_mm} for ${expected.tip_mm}`);
  assert.equal(read.line, expected.line, `line at ${read.slider_s} s`);
  assert.match(read.spoken, new RegExp(`program line ${read.line}`));
  assert.match(read.feed, expected.index === 0 ? /rapid/ : /1\s?200/);
}

test('the slider moves the tool along the program: its place, line and feed at every time', () =>
  withReport(browser, 'failed', {}, async (page) => {
    await showFinish(page);
    const slider = part(page, 'path-time');
    const attribute = async (name) => Number(await slider.getAttribute(name));
    const last = await attribute('max'), step = await attribute('step');
    assert.ok(last >= total_s - 1e-3 && last <= total_s + step, `${last} s of ${total_s} s`);
    for (const share of [0.001, 0.25, 0.5031, 0.777]) {
      await slider.fill(String(Number((Math.round((share * total_s) / step) * step).toFixed(6))));
      expectInstant(await readPath(page));
    }
  }));

test('keys move it: arrows by a step, Home and End to the ends', () =>
  withReport(browser, 'failed', {}, async (page) => {
    await showFinish(page);
    const slider = part(page, 'path-time');
    const step = Number(await slider.getAttribute('step'));
    await slider.focus();
    await page.keyboard.press('Home');
    assert.equal((await readPath(page)).slider_s, 0);
    for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
    const read = await readPath(page);
    assert.ok(Math.abs(read.slider_s - 3 * step) < 1e-6);
    expectInstant(read);
    await page.keyboard.press('End');
    const end = await readPath(page);
    assert.equal(end.line, moves.at(-1).line);
    assert.ok(distance(end.tip_mm, moves.at(-1).to) < 0.01);
  }));

test('buttons go from move to move, and play runs by itself until it is paused', () =>
  withReport(browser, 'failed', {}, async (page) => {
    await showFinish(page);
    await part(page, 'path-time').fill('0');
    await part(page, 'path-forward').click();
    await part(page, 'path-forward').click();
    const second = await readPath(page);
    assert.ok(distance(second.tip_mm, moves[1].to) < 0.01, `${second.tip_mm} for ${moves[1].to}`);
    await part(page, 'path-back').click();
    assert.ok(distance((await readPath(page)).tip_mm, moves[0].to) < 0.01);
    await part(page, 'path-play').click();
    assert.equal(await part(page, 'path-play').innerText(), 'Pause');
    // However long a busy machine takes from frame to frame.
    await page.waitForFunction((end_s) => window.limitgauge.view.path.state().time_s > end_s, moves[1].end_s);
    await part(page, 'path-play').click();
    const paused = await readPath(page);
    assert.ok(paused.slider_s > moves[1].end_s, `${paused.slider_s} s after playing`);
    await page.waitForTimeout(200);
    assert.equal((await readPath(page)).slider_s, paused.slider_s, 'paused is paused');
  }));

test('it is drawn, and colours by order, feed and removal rate have legends of their own', () =>
  withReport(browser, 'dome', {}, async (page) => {
    await showStage(page, 1);
    const canvas = part(page, 'view-canvas');
    const without = await canvas.screenshot();
    await showPath(page);
    await canvas.scrollIntoViewIfNeeded();
    await settle(page);
    const drawn = new Set([without.toString('base64')]), legends = new Set();
    for (const colour of ['order', 'feed', 'rate']) {
      await part(page, 'path-colour').selectOption(colour);
      await settle(page);
      drawn.add((await canvas.screenshot()).toString('base64'));
      legends.add(await part(page, 'path-legend').innerText());
    }
    assert.equal(drawn.size, 4, 'four pictures');
    assert.equal(legends.size, 3, 'three legends');
    assert.match([...legends].join('\n'), /mm\/min[^]*mm³\/min/);
  }));

test('the path starts where the chosen finding was made, with no more than what led there', () =>
  withReport(browser, 'gouging', { reducedMotion: 'reduce' }, async (page) => {
    const { gouges, uncuts } = resultOf('gouging').stages[1].deviation;
    const near = async (finding, id) => {
      const { now, shown, total_s } = await page.evaluate(() => window.limitgauge.view.path.state());
      const away = distance(now.point_mm, [finding.x, finding.y, finding.z]);
      assert.ok(away < 3, `${id}: the tool is ${away} mm from it`);
      assert.ok(shown.to_s - shown.from_s <= 20 + 1e-6 && shown.to_s <= total_s, `${id}: a stretch of the path`);
    };
    // The worst finding is chosen when the page opens.
    await showPath(page);
    await near(gouges[0], 'G1');
    assert.equal(await part(page, 'path-window').inputValue(), '20');
    if (uncuts.length === 0) return;
    await page.locator('[data-testid="view-findings"] [data-finding-id="U1"]').click();
    await settle(page);
    await near(uncuts[0], 'U1');
  }));
