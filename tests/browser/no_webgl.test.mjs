// Where the browser cannot draw in 3D the page says so and keeps all else.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { noContext, openBrowser, withReport } from './support/browser.mjs';
import { misfits } from './support/layout.mjs';
import { part } from './support/view.mjs';

/** In the page, before its script: asking for a WebGL context is an error. */
const contextThrows = () => {
  const given = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, ...others) {
    if (kind.startsWith('webgl')) throw new Error('blocked by an extension');
    return given.call(this, kind, ...others);
  };
};

// A Chromium that has neither a graphics card nor its own substitute ends now and then before it opens a page:
// what a page sees of such a one is a canvas without a context.
const refusals = [
  { name: '--disable-3d-apis', options: ['--disable-3d-apis'] },
  { name: 'a canvas without a context', early: noContext },
  { name: 'a canvas that refuses with an error', early: contextThrows },
];

for (const { name, options, early } of refusals) {
  const browser = await openBrowser(options);
  test(`${name}: a sentence instead of the view, pictures and tables as ever`, () =>
    withReport(browser, 'failed', { width: 400, early }, async (page) => {
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
