// Live charts stand where the page keeps their room.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { part } from './support/view.mjs';

const browser = await openBrowser();

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
  withReport(browser, 'failed', {}, async (page) => {
    const figure = page.locator('figure.histogram').first();
    await figure.scrollIntoViewIfNeeded();
    await figure.and(page.locator('.chart-drawn')).waitFor();
    const before = await figure.screenshot();
    await part(figure, 'histogram-log').click();
    await page.waitForTimeout(300);
    assert.notEqual((await figure.screenshot()).toString('base64'), before.toString('base64'));
  }));
