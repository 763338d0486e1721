// The page of a history: charts of its runs, which say all that the table says.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { faintWords } from './support/contrast.mjs';
import { misfits, smallTargets } from './support/layout.mjs';
import { resultOf } from './support/pages.mjs';

const browser = await openBrowser([]);
const plotOf = (page, job = 0) => page.locator('[data-testid="history-plot"]').nth(job);
const panelOf = (page, job = 0) => page.locator('[data-testid="history-run"]').nth(job);
const stateOf = (page, job = 0) =>
  page.evaluate(async (index) => (await window.limitgauge.ready)[index].state(), job);

/** Brings a job's charts into sight and waits until they are drawn. */
async function drawn(page, job = 0) {
  const plot = plotOf(page, job);
  await plot.scrollIntoViewIfNeeded();
  await plot.locator('svg').waitFor();
  return plot;
}

/** A point of the first panel, `share` of its width from the left. */
async function pointOf(plot, share) {
  const box = await plot.boundingBox();
  return [box.x + 64 + share * (box.width - 82), box.y + 110];
}

test('hovering says all of a run, clicking pins it, in the table too', () =>
  withReport(browser, 'forty', {}, async (page) => {
    const { runs, series } = resultOf('forty').jobs[0];
    const plot = await drawn(page);
    const at = await pointOf(plot, 0.999);
    await page.mouse.move(...at);
    const tip = plot.locator('> div', { hasText: `run ${runs.at(-1).id}` });
    await tip.waitFor();
    const words = await tip.innerText();
    assert.ok(words.includes(runs.at(-1).commit), 'the commit');
    for (const { stage, label } of series) assert.ok(words.includes(`${stage} ${label}`.trim()));
    assert.match(words, /finish uncut: \[7, 8\] µm, limit 10 µm, (same|better)/);
    await page.mouse.click(...at);
    assert.equal((await stateOf(page)).pinned, 40);
    assert.match(await panelOf(page).innerText(), /Run 40/);
    assert.equal(await page.locator('tr.pinned').getAttribute('id'), 'run-40');
    await page.mouse.click(...at);
    assert.equal((await stateOf(page)).pinned, null);
    assert.equal(await page.locator('tr.pinned').count(), 0);
  }));

test('a run is pinned from the keyboard, and another by its time', () =>
  withReport(browser, 'forty', {}, async (page) => {
    await drawn(page);
    await page.getByText('Earlier run').focus();
    await page.keyboard.press('Enter');
    await page.keyboard.press('Enter');
    assert.equal((await stateOf(page)).pinned, 39);
    await page.getByText('Later run').press('Enter');
    await page.getByText('Later run').press('Enter');
    assert.equal((await stateOf(page)).pinned, 40, 'there is no later one');
    await page.locator('[data-testid="history-time"]').check();
    const plot = await drawn(page);
    await page.mouse.click(...await pointOf(plot, 0.001));
    assert.equal((await stateOf(page)).pinned, 1);
    await page.getByText('Unpin').click();
    assert.equal((await stateOf(page)).pinned, null);
  }));

test('the newest runs are chosen, and their axis fits them', () =>
  withReport(browser, 'many', {}, async (page) => {
    const plot = await drawn(page);
    await page.getByText('Newest 10').click();
    const [start, end] = (await stateOf(page)).zoom;
    assert.ok(Math.abs(start - 100 * (990 / 999)) < 1e-6 && end === 100);
    await page.mouse.click(...await pointOf(plot, 0.001));
    const { pinned } = await stateOf(page);
    assert.ok(pinned >= 990 && pinned <= 992, `run ${pinned}`);
    await page.getByText('All runs').click();
    assert.deepEqual((await stateOf(page)).zoom, [0, 100]);
  }));

test('verdicts have marks of their own, and a limit and a band are drawn', () =>
  withReport(browser, 'forty', {}, async (page) => {
    const plot = await drawn(page);
    const shapes = await plot.evaluate((element) => {
      const paths = [...element.querySelectorAll('svg path')];
      const fills = new Set(paths.map((e) => e.getAttribute('fill')).filter((f) => f && f !== 'none'));
      return { fills: fills.size, dashed: paths.filter((e) => e.getAttribute('stroke-dasharray')).length };
    });
    assert.ok(shapes.fills >= 3, `${shapes.fills} colours of marks and bands`);
    assert.ok(shapes.dashed >= 4, 'the limits of four figures');
  }));

test('each job has its charts', () =>
  withReport(browser, 'two-jobs', {}, async (page) => {
    for (const job of [0, 1]) await drawn(page, job);
    await page.getByText('Earlier run').nth(1).click();
    assert.deepEqual([(await stateOf(page, 0)).pinned, (await stateOf(page, 1)).pinned], [null, 28]);
  }));

test('markup in labels, commits and names runs nowhere', () =>
  withReport(browser, 'hostile', {}, async (page) => {
    const plot = await drawn(page);
    await page.mouse.move(...await pointOf(plot, 0.5));
    await page.getByText('Earlier run').click();
    await page.waitForTimeout(200);
    const found = await page.evaluate(() => ({
      ran: window.hostile, drawn: document.querySelectorAll('img, svg[onload], [onerror]').length,
    }));
    assert.deepEqual(found, { ran: undefined, drawn: 0 });
    assert.ok((await page.locator('body').innerText()).includes('<img src=x onerror=window.hostile=1>'));
  }));

for (const name of ['forty', 'two-jobs', 'one', 'hostile'])
  test(`${name} fits at 1280 and 400 px, and its words stand out in light and dark`, () =>
    withReport(browser, name, { colorScheme: 'light' }, async (page) => {
      for (const [width, colorScheme] of [[1280, 'light'], [400, 'dark']]) {
        await page.setViewportSize({ width, height: 900 });
        await page.emulateMedia({ colorScheme });
        await drawn(page);
        await page.getByText('Earlier run').first().click();
        const faults = [await misfits(page), await smallTargets(page), await faintWords(page)];
        assert.deepEqual(faults.flat().map((fault) => `${width} px, ${colorScheme}: ${fault}`), []);
      }
    }));

test('without a script the table says all, and on paper nothing wants a pointer', async () => {
  await withReport(browser, 'forty', { javaScriptEnabled: false }, async (page) => {
    assert.equal(await page.locator('tr[data-run]').count(), 40);
    assert.match(await page.locator('#run-7').innerText(), /\[27, 28\]/);
  });
  await withReport(browser, 'forty', {}, async (page) => {
    await drawn(page);
    await page.emulateMedia({ media: 'print' });
    assert.equal(await plotOf(page).isVisible(), false);
    for (const control of await page.locator('button, input').all())
      assert.equal(await control.isVisible(), false);
    assert.ok(await page.locator('#run-7').isVisible());
  });
});
