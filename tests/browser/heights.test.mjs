// A report is as long as what there is to read: what passed and what is looked up is folded.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';

const browser = await openBrowser();

/** Height of the page with all charts drawn, px. */
async function heightOf(page) {
  const height = () => page.evaluate(() => document.documentElement.scrollHeight);
  for (let y = 0; y < (await height()); y += 800) {
    await page.evaluate((top) => scrollTo(0, top), y);
    await page.waitForTimeout(60);
  }
  return height();
}

// The samples have the aircraft's three stages, its number of patches and more findings than it.
for (const name of ['passed', 'failed', 'undecided', 'dome', 'gouging', 'cut'])
  for (const [width, most] of [[1280, 9000], [400, 20_000]])
    test(`${name} is at most ${most} px tall at ${width} px`, (t) =>
      withReport(browser, name, { width }, async (page) => {
        const height = await heightOf(page);
        t.diagnostic(`${height} px`);
        assert.ok(height <= most, `${height} px`);
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
