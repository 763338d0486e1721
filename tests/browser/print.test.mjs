// On paper: all figures and pictures, nothing that wants a pointer.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { part } from './support/view.mjs';

const browser = await openBrowser();

for (const [name, colorScheme] of [['failed', 'light'], ['passed', 'dark']])
  test(`${name}, ${colorScheme}: prints without live controls, dark on white`, () =>
    withReport(browser, name, { colorScheme }, async (page) => {
      assert.ok(await part(page, 'view').isVisible(), 'it was there on the screen');
      await page.emulateMedia({ media: 'print' });
      assert.equal(await part(page, 'view').isVisible(), false);
      for (const control of await page.locator('button, input, select').all())
        assert.equal(await control.isVisible(), false, await control.evaluate((e) => e.outerHTML));
      assert.ok(await page.locator('.verdict .word').isVisible());
      for (const figure of await page.locator('figure.histogram').all())
        assert.ok(await figure.locator('svg').first().isVisible(), 'the histogram that needs no script');
      assert.ok(await page.locator('.map img').first().isVisible());
      const paper = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
      assert.equal(paper, 'rgb(255, 255, 255)');
      await page.emulateMedia({ media: null });
      const pdf = await page.pdf({ format: 'A4' });
      const sheets = pdf.toString('latin1').match(/\/Type ?\/Page\b/g)?.length ?? 0;
      assert.ok(sheets >= 2 && sheets <= 25, `${sheets} sheets`);
    }));
