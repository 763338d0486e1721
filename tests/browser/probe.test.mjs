// The page of measured points: it needs no script, fits, and says all in words.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { findsNothing } from './support/axe.mjs';
import { openBrowser, withReport } from './support/browser.mjs';
import { faintWords } from './support/contrast.mjs';
import { misfits, smallTargets } from './support/layout.mjs';
import { resultOf } from './support/pages.mjs';

const browser = await openBrowser([]);
const still = { javaScriptEnabled: false };

for (const name of ['two-hundred', 'many', 'one', 'floor', 'slanted', 'failed', 'hostile'])
  test(`${name} fits at 1280 and 400 px, and its words stand out in light and dark`, () =>
    withReport(browser, name, { ...still, colorScheme: 'light' }, async (page) => {
      for (const [width, colorScheme] of [[1280, 'light'], [400, 'dark']]) {
        await page.setViewportSize({ width, height: 900 });
        await page.emulateMedia({ colorScheme });
        const faults = [await misfits(page), await smallTargets(page), await faintWords(page)];
        assert.deepEqual(faults.flat().map((fault) => `${width} px, ${colorScheme}: ${fault}`), []);
      }
    }));

for (const name of ['two-hundred', 'floor', 'slanted', 'failed', 'hostile'])
  test(`${name}: axe finds nothing`, () =>
    withReport(browser, name, { bypassCSP: true }, async (page) => {
      await page.evaluate(() => { for (const one of document.querySelectorAll('details')) one.open = true; });
      await findsNothing(page);
    }));

test('a row and a mark for every point, the worst first', () =>
  withReport(browser, 'two-hundred', still, async (page) => {
    const { worst } = resultOf('two-hundred');
    const rows = page.locator('#points tbody tr');
    assert.equal(await rows.count(), 200);
    assert.match(await rows.first().innerText(), new RegExp(`^\\s*${worst[0].file_line}\\b`));
    for (const css of ['before', 'after', 'wide'])
      assert.equal(await page.locator(`svg .${css} path`).count(), 200);
    assert.match(await page.locator('svg[role=img]').getAttribute('aria-label'), /200 points/);
  }));

test('what is undetermined is said where the shift stands', () =>
  withReport(browser, 'floor', still, async (page) => {
    const rows = await page.locator('#shift tbody tr').allInnerTexts();
    for (const [index, axis] of ['X', 'Y'].entries())
      assert.match(rows[index], new RegExp(`undetermined[^]*no point lies on a surface that faces ${axis}`));
    assert.match(rows[2], /2\.\d+ ± 0\.\d+ µm/);
  }));

test('markup in names is shown and runs nowhere', () =>
  withReport(browser, 'hostile', still, async (page) => {
    assert.equal(await page.locator('img').count(), 0);
    assert.ok((await page.locator('h1').innerText()).includes('<img src=x onerror=window.hostile=1>'));
  }));
