// Everything of weight is there without a script.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { resultOf } from './support/pages.mjs';

const browser = await openBrowser();
const still = { javaScriptEnabled: false };

for (const name of ['passed', 'failed', 'undecided'])
  test(`${name}: verdict, tables, maps and histograms stand without a script`, () =>
    withReport(browser, name, still, async (page) => {
      const stages = resultOf(name).stages.filter((stage) => stage.deviation);
      assert.ok(await page.locator('.verdict .word').isVisible());
      await page.locator('.stage > details').evaluateAll((all) => all.forEach((details) => (details.open = true)));
      assert.equal(await page.locator('.map img:visible').count() >= stages.length, true);
      assert.equal(await page.locator('.histogram svg:visible').count(), stages.length);
      for (const img of await page.locator('img:visible').all()) {
        assert.ok(await img.evaluate((element) => element.naturalWidth > 0), 'the picture is drawn');
        assert.notEqual(await img.getAttribute('alt'), '');
      }
      const text = await page.locator('body').innerText();
      for (const stage of stages)
        for (const gouge of stage.deviation.gouges)
          if (gouge.line > 0) assert.ok(text.includes(String(gouge.line)), `line ${gouge.line}`);
    }));

test('the failed one names the worst gouge, its depth and its program line', () =>
  withReport(browser, 'failed', still, async (page) => {
    const [worst] = resultOf('failed').stages[1].deviation.gouges;
    const [place] = await page.locator('.verdict .worst', { hasText: 'gouge' }).allInnerTexts();
    assert.match(place, new RegExp(`line ${worst.line}\\b`));
    const depth = Number(/Worst gouge\s+([\d.]+) µm/.exec(place)[1]);
    assert.ok(Math.abs(depth / 1000 - worst.depth_mm) <= 0.1e-3, `${depth} µm for ${worst.depth_mm} mm`);
    const marked = page.locator('table.program .named', { hasText: `${worst.line}` }).first();
    assert.match(await marked.innerText(), /G1 X/);
  }));
