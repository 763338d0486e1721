// Where the browser cannot draw in 3D the page says so and keeps all else.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { misfits } from './support/layout.mjs';
import { part } from './support/view.mjs';

const refusals = [['--disable-3d-apis'], ['--disable-gpu', '--disable-software-rasterizer']];

for (const options of refusals) {
  const browser = await openBrowser(options);
  test(`${options.join(' ')}: a sentence instead of the view, pictures and tables as ever`, () =>
    withReport(browser, 'failed', { width: 400 }, async (page) => {
      await page.locator('.stage > details').evaluateAll((all) => all.forEach((details) => (details.open = true)));
      const missing = part(page, 'view-missing');
      assert.ok(await missing.isVisible());
      assert.match(await missing.innerText(), /\w+ .*\./);
      assert.equal(await page.evaluate(() => window.limitgauge.view), null);
      assert.equal(await part(page, 'view-canvas').count(), 0);
      assert.ok(await page.locator('.map img').first().isVisible());
      assert.ok(await page.locator('table').first().isVisible());
      for (const figure of await page.locator('figure.histogram').all())
        assert.ok(await figure.locator('svg, canvas').first().isVisible());
      assert.deepEqual(await misfits(page), []);
    }));
}
