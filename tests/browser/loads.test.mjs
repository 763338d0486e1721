// Every report opens from disk without a fault, a request or a word on the console.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { resultOf } from './support/pages.mjs';

const browser = await openBrowser();
const words = { pass: 'Passed', fail: 'Failed', indeterminate: 'Undecided' };

for (const name of ['passed', 'failed', 'undecided', 'dome', 'gouging', 'cut'])
  test(`${name}: opens, says its verdict first, asks for nothing`, () =>
    withReport(browser, name, {}, async (page) => {
      const { job, verdict } = resultOf(name);
      assert.equal(await page.title(), `${job}: ${words[verdict]} – Limitgauge`);
      const shown = page.locator('.verdict .word');
      assert.match(await shown.innerText(), new RegExp(words[verdict]));
      const place = await shown.boundingBox();
      assert.ok(place.y + place.height < 450, 'the verdict is in the upper half of the first screen');
    }));
