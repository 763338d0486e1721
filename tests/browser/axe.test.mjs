// axe-core finds nothing on any page: wide in light, narrow in dark, with all that is folded unfolded.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { violations } from './support/axe.mjs';
import { openBrowser, withReport } from './support/browser.mjs';

const browser = await openBrowser();

const reports = ['passed', 'failed', 'undecided', 'dome', 'gouging', 'cut', 'mesh', 'tolerated', 'hostile']
  .map((name) => [name, 'report.html']);
const studies = ['sixty', 'failed', 'single', 'hostile'].map((name) => [`studies/${name}`, 'study.html']);
const histories = ['one', 'two-jobs', 'forty', 'hostile'].map((name) => [`histories/${name}`, 'report.html']);

/** Unfolds all and shows what is shown on demand; charts are drawn when they come into sight. */
async function unfold(page) {
  await page.evaluate(() => {
    for (const details of document.querySelectorAll('details')) details.open = true;
    const path = document.querySelector('[data-testid="view-path"]');
    if (path && !path.checked) path.click();
  });
  const height = await page.evaluate(() => document.documentElement.scrollHeight);
  for (let y = 0; y < height; y += 800) {
    await page.evaluate((top) => scrollTo(0, top), y);
    await page.waitForTimeout(30);
  }
}

for (const [name, file] of [...reports, ['compared', 'compare.html'], ...studies, ...histories])
  test(`${name}: axe finds nothing`, () =>
    withReport(browser, name, { file, reducedMotion: 'reduce', bypassCSP: true }, async (page) => {
      // One page for both: opening it takes longer than to look at it.
      for (const [width, colorScheme] of [[1280, 'light'], [400, 'dark']]) {
        await page.setViewportSize({ width, height: 900 });
        await page.emulateMedia({ colorScheme });
        await unfold(page);
        assert.deepEqual(await violations(page), [], `${width} px, ${colorScheme}`);
      }
    }));
