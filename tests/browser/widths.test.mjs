// From a phone to a desk: nothing scrolls sideways, nothing is cut off, controls can be hit.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { meetingLabels, misfits, smallTargets } from './support/layout.mjs';

const browser = await openBrowser();

for (const name of ['passed', 'failed', 'undecided', 'dome', 'gouging', 'hostile'])
  for (const width of [400, 1280])
    test(`${name} at ${width} px fits`, () =>
      withReport(browser, name, { width }, async (page) => {
        for (const details of await page.locator('details').all())
          await details.evaluate((element) => (element.open = true));
        assert.deepEqual(await misfits(page), []);
        assert.deepEqual(await smallTargets(page), []);
        assert.deepEqual(await meetingLabels(page), []);
      }));
