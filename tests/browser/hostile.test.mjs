// Text from jobs, cages and programs is shown as text: no markup in it runs or is drawn.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { resultOf } from './support/pages.mjs';

const browser = await openBrowser();
const markup = ['</script><img src=x onerror=window.hostile=1>', '<svg onload=window.hostile=1>'];

/** What runs when a reader touches all that a script might have been tied to. */
async function touchEverything(page) {
  for (const details of await page.locator('details').all())
    await details.evaluate((element) => (element.open = true));
  await page.evaluate(() => {
    const kinds = ['mouseover', 'mousemove', 'pointerover', 'focus'];
    for (const element of document.querySelectorAll('body *'))
      for (const kind of kinds) element.dispatchEvent(new Event(kind, { bubbles: true }));
  });
}

async function expectHarmless(page) {
  const found = await page.evaluate(() => ({
    ran: window.hostile,
    drawn: document.querySelectorAll('img[src="x"], img[onerror], svg[onload], [onmouseover]').length,
    scripts: [...document.scripts].filter((s) => !s.id && !s.text.startsWith('"use strict"')).length,
    links: [...document.querySelectorAll('[href], [src]')]
      .map((e) => e.getAttribute('href') ?? e.getAttribute('src'))
      .filter((to) => !/^(#|data:image\/png;base64,)/.test(to)),
  }));
  assert.deepEqual(found, { ran: undefined, drawn: 0, scripts: found.scripts, links: [] });
  assert.ok(found.scripts <= 1, 'one script besides the data');
}

test('a report with markup in every name, comment and program line runs none of it', () =>
  withReport(browser, 'hostile', {}, async (page) => {
    await touchEverything(page);
    await expectHarmless(page);
    const text = await page.locator('body').innerText();
    for (const part of markup) assert.ok(text.includes(part), `${part} is shown as text`);
    assert.ok(text.includes('&lt;b&gt;'), 'what looks like an entity is text too');
    assert.ok((await page.locator('h1').innerText()).includes(markup[0]));
    assert.ok((await page.title()).includes(markup[1]));
  }));

test('so does a real job with a cage and a program of such text', () =>
  withReport(browser, 'gouging', {}, async (page) => {
    assert.match(resultOf('gouging').surface.cage, /<img src=x/);
    await touchEverything(page);
    await expectHarmless(page);
    const listing = await page.locator('table.program').allInnerTexts();
    for (const part of markup) assert.ok(listing.join('\n').includes(part), `${part} is shown as text`);
  }));
