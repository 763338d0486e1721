// The page of a program without a design: the finished stock, its colours, a section, distances.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { resultOf } from './support/pages.mjs';
import { distance, onScreen, part, press, settle, showCanvas, stateOf } from './support/view.mjs';

const browser = await openBrowser();
const still = { reducedMotion: 'reduce' };

const pick = (page, at) => page.evaluate(({ x, y }) => window.limitgauge.view.pick(x, y), at);

test('the headline says that nothing was measured, and the rapid is shown with its line', () =>
  withReport(browser, 'cut', still, async (page) => {
    assert.match(await page.locator('header').innerText(), /Nothing was measured against a design/);
    const [finding] = resultOf('cut').stages[0].simulation.findings;
    assert.equal(finding.kind, 'rapid_through_stock');
    const state = await stateOf(page);
    assert.equal(state.finding, 'P1');
    assert.match(await part(page, 'view-finding').innerText(), new RegExp(`line ${finding.line}`));
  }));

test('what is pointed at is the stock that was cut, by the line that cut it', () =>
  withReport(browser, 'cut', still, async (page) => {
    await press(page, 'view-top');
    await showCanvas(page);
    // The first slot's floor is 2 mm down, cut by line 8.
    const floor = await pick(page, await onScreen(page, [25, 10, -2]));
    assert.ok(distance(floor.point_mm, [25, 10, -2]) < 0.3, `${floor.point_mm}`);
    assert.equal(floor.maker, 1);
    assert.equal(floor.line, 8);
    const top = await pick(page, await onScreen(page, [25, 19, 0]));
    assert.equal(top.maker, 0);
    const at = await onScreen(page, [25, 10, -2]);
    await page.mouse.move(at.x, at.y);
    await settle(page);
    assert.match(await part(page, 'stock-readout').innerText(), /cut by program, line 8/);
  }));

test('the stock is coloured by tool, line, time or nothing', () =>
  withReport(browser, 'cut', still, async (page) => {
    for (const key of ['line', 'time', 'plain', 'tool']) {
      await part(page, 'stock-colour').selectOption(key);
      await settle(page);
      assert.equal((await stateOf(page)).colour, key);
    }
    assert.match(await part(page, 'stock-tools').innerText(), /raw stock/);
  }));

test('two clicks measure a distance with dx, dy and dz', () =>
  withReport(browser, 'cut', still, async (page) => {
    await press(page, 'view-top');
    await part(page, 'measure-on').check();
    await showCanvas(page);
    for (const point of [[5, 19, 0], [25, 10, -2]]) {
      const { x, y } = await onScreen(page, point);
      await page.mouse.click(x, y);
      await settle(page);
    }
    const { A, B, distance_mm } = (await stateOf(page)).measure;
    assert.ok(distance(A, [5, 19, 0]) < 0.3 && distance(B, [25, 10, -2]) < 0.3);
    assert.ok(Math.abs(distance_mm - distance(A, B)) < 1e-9);
    const said = await part(page, 'measure-result').innerText();
    for (const word of ['A', 'B', 'Distance', 'dx', 'dy', 'dz']) assert.match(said, new RegExp(`\\b${word}\\b`));
    assert.match(await part(page, 'measure-error').innerText(), /None of .* places checked .* lies further than/);
  }));

test('distances are measured from the keyboard alone', () =>
  withReport(browser, 'cut', still, async (page) => {
    await part(page, 'view-canvas').focus();
    await page.keyboard.press('Home');
    await settle(page);
    await page.keyboard.press('Enter');
    await page.keyboard.press('ArrowLeft');
    await settle(page);
    await page.keyboard.press('Enter');
    const { A, B, distance_mm } = (await stateOf(page)).measure;
    assert.ok(A && B && distance_mm >= 0);
    await part(page, 'measure-clear').press('Enter');
    assert.equal((await stateOf(page)).measure.A, null);
  }));

test('a section is drawn with its dimensions', () =>
  withReport(browser, 'cut', still, async (page) => {
    await part(page, 'view-section').selectOption('0');
    await settle(page);
    const chart = part(page, 'stock-section-chart');
    const texts = await chart.locator('text').allTextContents();
    assert.ok(texts.some((text) => /^40\.0\d\d mm|^39\.9\d\d mm/.test(text)), texts.join('; '));
    assert.match(await chart.getAttribute('aria-label'), /Y from .* to .* mm, Z from/);
    assert.equal((await stateOf(page)).section.axis, 0);
  }));
