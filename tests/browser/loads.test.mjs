// Every report opens from disk without a fault, a request or a word on the console, and is as long as what there
// is to read: what passed and what is looked up is folded.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, seeFigures, withReport } from './support/browser.mjs';
import { resultOf } from './support/pages.mjs';

const browser = await openBrowser();

/** Height of the page with all charts drawn, px. */
async function heightOf(page) {
  await seeFigures(page);
  return page.evaluate(() => document.documentElement.scrollHeight);
}

const words = { pass: 'Passed', fail: 'Failed', indeterminate: 'Undecided' };

// The samples have the aircraft's three stages, its number of patches and more findings than it.
const tallest_px = [[1280, 9000], [400, 20_000]];

for (const name of ['passed', 'failed', 'undecided', 'dome', 'gouging', 'cut'])
  test(`${name}: opens, says its verdict first, asks for nothing, is not too tall`, (t) =>
    withReport(browser, name, {}, async (page) => {
      const { job, verdict } = resultOf(name);
      assert.equal(await page.title(), `${job}: ${words[verdict]} – Limitgauge`);
      const shown = page.locator('.verdict .word');
      assert.match(await shown.innerText(), new RegExp(words[verdict]));
      const place = await shown.boundingBox();
      assert.ok(place.y + place.height < 450, 'the verdict is in the upper half of the first screen');
      for (const [width, most] of tallest_px) {
        await page.setViewportSize({ width, height: 900 });
        const height = await heightOf(page);
        t.diagnostic(`${height} px tall at ${width} px`);
        assert.ok(height <= most, `${height} px tall at ${width} px`);
      }
    }));

test('a stage that passed is folded and unfolds by its summary, by a link into it and by a button', () =>
  withReport(browser, 'passed', { reducedMotion: 'reduce' }, async (page) => {
    const body = page.locator('#stage-1 > details');
    assert.equal(await body.getAttribute('open'), null);
    await body.locator('> summary').click();
    assert.ok(await page.locator('#stage-1 figure.histogram').isVisible());
    const row = page.locator('tr[id^="stage-2-"]').first();
    const id = await row.getAttribute('id');
    await page.evaluate((to) => (location.hash = to), id);
    assert.ok(await row.isVisible(), 'a link into a folded stage leads somewhere');
  }));
