// From a phone to a desk: nothing scrolls sideways, nothing is cut off, controls can be hit.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { meetingLabels, misfits, smallTargets } from './support/layout.mjs';
import { settle } from './support/view.mjs';

const browser = await openBrowser();

for (const name of ['passed', 'failed', 'undecided', 'dome', 'gouging', 'cut', 'tolerated', 'hostile'])
  test(`${name} fits at 1280, 400 and again 1280 px`, () =>
    withReport(browser, name, { width: 1280 }, async (page) => {
      await page.evaluate(() => document.querySelectorAll('details').forEach((d) => (d.open = true)));
      for (const width of [1280, 400, 1280]) {
        await page.setViewportSize({ width, height: 900 });
        await settle(page);
        const faults = [await misfits(page), await smallTargets(page), await meetingLabels(page)];
        assert.deepEqual(faults.flat().map((fault) => `${width} px: ${fault}`), []);
      }
    }));
