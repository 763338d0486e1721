// Live charts stand where the page keeps their room.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { part } from './support/view.mjs';

const browser = await openBrowser();
const unfold = (page) =>
  page.evaluate(() => document.querySelectorAll('details').forEach((d) => (d.open = true)));

/** How many colours a drawing has: one is an empty sheet. */
const colours = (chart) => chart.evaluate((element) => {
  const canvas = element.querySelector('canvas');
  if (!canvas) return new Set([...element.querySelectorAll('svg *')].map((e) => e.getAttribute('fill'))).size;
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  const seen = new Set();
  for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 0) seen.add(data.slice(i, i + 3).join());
  return seen.size;
});

for (const [name, colorScheme] of [['failed', 'light'], ['dome', 'dark']])
  test(`${name}, ${colorScheme}: every stage has its histogram drawn`, () =>
    withReport(browser, name, { colorScheme }, async (page) => {
      await unfold(page);
      const figures = await page.locator('figure.histogram').all();
      assert.ok(figures.length >= 2);
      for (const figure of figures) {
        await figure.scrollIntoViewIfNeeded();
        const chart = figure.locator('[data-testid="histogram-chart"]');
        await chart.waitFor();
        await figure.and(page.locator('.chart-drawn')).waitFor();
        assert.ok((await colours(chart)) >= 3, 'bars, axis and words');
        assert.equal(await figure.locator('div.static').isVisible(), false, 'once is enough');
      }
    }));

test('a chart of the process stands for each stage of a real job', () =>
  withReport(browser, 'dome', {}, async (page) => {
    await unfold(page);
    for (const place of await page.locator('[data-chart="process"]').all()) {
      await place.evaluate((element) => {
        element.hidden = false;
        element.scrollIntoView();
      });
      const chart = place.locator('[data-testid="process-chart"]');
      await chart.waitFor();
      // It is drawn when it has come into sight, a moment later.
      await chart.locator('svg').waitFor();
      assert.ok((await colours(chart)) >= 3);
    }
  }));

test('the histogram counts in powers of ten when asked to', () =>
  withReport(browser, 'failed', { view: false }, async (page) => {
    await unfold(page);
    const figure = page.locator('figure.histogram').first();
    await figure.scrollIntoViewIfNeeded();
    await figure.and(page.locator('.chart-drawn')).waitFor();
    const before = await figure.screenshot();
    await part(figure, 'histogram-log').click();
    const drawnAgain = async () => (await figure.screenshot()).toString('base64') !== before.toString('base64');
    // Drawn anew in a frame to come, which a busy machine takes its time over.
    for (let tries = 0; tries < 100 && !(await drawnAgain()); ++tries) await page.waitForTimeout(100);
    assert.ok(await drawnAgain(), 'another picture');
  }));

/** Texts of a drawn chart that run into each other, or out of it. */
const overprints = (figure) => figure.evaluate((element) => {
  const plot = element.querySelector('[data-testid="histogram-chart"]');
  const outer = plot.getBoundingClientRect(), faults = [];
  const words = [...plot.querySelectorAll('svg text')].filter((e) => e.textContent.trim())
    .map((e) => ({ text: e.textContent, box: e.getBoundingClientRect() }));
  // A box is higher than its letters.
  const meet = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 4 && b.top < a.bottom - 4;
  words.forEach((a, i) => words.slice(i + 1).forEach((b) => {
    if (meet(a.box, b.box)) faults.push(`${a.text} | ${b.text}`);
  }));
  for (const { text, box } of words)
    if (box.left < outer.left - 1 || box.right > outer.right + 1) faults.push(`out of the chart: ${text}`);
  const limits = words.filter(({ text }) => / limit /.test(text)).length;
  return limits === 2 ? faults : [...faults, `${limits} limits named`];
});

/** Gate limits against a spread of tenths of a millimetre: nothing, as stated, and far beyond. */
const scales = { both: [1e-6, 1e-6], gouge: [1e-6, 0.08], uncut: [0.08, 1e-6], far: [50, 70], left: [0.05, 70] };

/** Until the chart has the width of its place. */
const fits = (page) => page.waitForFunction(() => {
  const plot = document.querySelector('#stage-2 [data-testid="histogram-chart"]'), svg = plot?.querySelector('svg');
  return svg?.querySelector('text') && Math.abs(svg.getBoundingClientRect().width - plot.clientWidth) < 1;
});

for (const [kind, [gouge_mm, uncut_mm]] of Object.entries(scales))
  test(`${kind}: the histogram prints no word over another at 1280 and 400 px, and names both limits`, () =>
    withReport(browser, 'failed', { view: false, early: `
      const parse = JSON.parse;
      JSON.parse = (text) => {
        const value = parse(text);
        for (const stage of value?.stages ?? [])
          if (stage.limits) Object.assign(stage.limits, { gouge_mm: ${gouge_mm}, uncut_mm: ${uncut_mm} });
        return value;
      };` }, async (page) => {
      const figure = page.locator('#stage-2 figure.histogram');
      for (const width of [1280, 400]) {
        await page.setViewportSize({ width, height: 900 });
        await figure.scrollIntoViewIfNeeded();
        await figure.and(page.locator('.chart-drawn')).waitFor();
        await fits(page);
        assert.deepEqual((await overprints(figure)).map((fault) => `${width} px: ${fault}`), []);
      }
    }));

for (const name of ['passed', 'failed', 'undecided'])
  test(`${name}: so does the one that needs no script`, () =>
    withReport(browser, name, { javaScriptEnabled: false, width: 400 }, async (page) => {
      await page.locator('.stage > details').evaluateAll((all) => all.forEach((details) => (details.open = true)));
      for (const figure of await page.locator('figure.histogram').all()) {
        const boxes = await Promise.all((await figure.locator('.above .limit').all()).map((e) => e.boundingBox()));
        assert.equal(boxes.length, 2);
        assert.ok(boxes[0].y + boxes[0].height <= boxes[1].y + 4, 'a row each');
        for (const box of boxes) assert.ok(box.x >= 0 && box.x + box.width <= 400);
      }
    }));
