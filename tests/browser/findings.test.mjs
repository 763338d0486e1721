// From a finding in a list to its place, its depth and its program text.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { resultOf } from './support/pages.mjs';
import { distance, onScreen, part, settle, showStage, stateOf } from './support/view.mjs';

const browser = await openBrowser();

const place = (finding) => [finding.x, finding.y, finding.z];

/** The finding is chosen, in the middle of the picture, and said in words and program text. */
async function expectChosen(page, stage, id, finding) {
  // A page that is still unpacking its data answers a click later.
  await page.waitForFunction((chosen) => window.limitgauge.view.state().finding === chosen, id);
  await settle(page);
  const state = await stateOf(page);
  assert.equal(state.stage, stage);
  assert.equal(state.finding, id);
  assert.ok(distance(state.camera.focal, place(finding)) < 0.5, `${state.camera.focal} is looked at`);
  const canvas = await part(page, 'view-canvas').boundingBox();
  const at = await onScreen(page, place(finding));
  assert.ok(Math.abs(at.x - canvas.x - canvas.width / 2) < canvas.width / 8, 'in the middle across');
  assert.ok(Math.abs(at.y - canvas.y - canvas.height / 2) < canvas.height / 8, 'in the middle down');
  const shown = part(page, 'view-finding');
  assert.equal(await shown.getAttribute('data-id'), id);
  assert.ok(Math.abs(Number(await shown.getAttribute('data-depth-mm')) - finding.depth_mm) <= 1e-4);
  if (finding.line === 0) return;
  assert.equal(await shown.getAttribute('data-line'), String(finding.line));
  assert.match(await shown.innerText(), new RegExp(`\\b${finding.line}\\b`));
}

test('every finding of a failed stage is flown to from the list in the view', () =>
  withReport(browser, 'failed', { reducedMotion: 'reduce' }, async (page) => {
    const { gouges, uncuts } = resultOf('failed').stages[1].deviation;
    await showStage(page, 1);
    for (const [letter, findings] of [['G', gouges], ['U', uncuts]])
      for (const [i, finding] of findings.entries()) {
        const id = `${letter}${i + 1}`;
        const button = page.locator(`[data-testid="view-findings"] [data-finding-id="${id}"]`);
        if (i > 0 && !(await button.isVisible())) continue;
        await button.click();
        await expectChosen(page, 1, id, finding);
      }
  }));

test('what tolerances lead to is flown to, with the values that do', () =>
  withReport(browser, 'tolerated', { reducedMotion: 'reduce' }, async (page) => {
    const { gouge_mm: gouge, uncut_mm: uncut } = resultOf('tolerated').stages[0].deviation.robust;
    for (const [id, figure] of [['GT', gouge], ['UT', uncut]]) {
      await page.locator(`[data-testid="view-findings"] [data-finding-id="${id}"]`).click();
      await expectChosen(page, 0, id, { ...figure.place, depth_mm: figure.low, line: figure.line ?? 0 });
      assert.match(await part(page, 'view-finding').innerText(), /over the tolerances/);
      for (const [name, mm] of Object.entries(figure.at))
        if (mm !== 0) assert.ok((await part(page, 'view-finding').innerText()).includes(name), name);
    }
  }));

for (const reducedMotion of ['no-preference', 'reduce'])
  test(`${reducedMotion}: the camera ${reducedMotion === 'reduce' ? 'is at once' : 'flies'} there`, () =>
    withReport(browser, 'failed', { reducedMotion }, async (page) => {
      const [worst] = resultOf('failed').stages[1].deviation.gouges;
      await showStage(page, 1);
      await page.evaluate(() => {
        window.onTheWay = 0;
        window.limitgauge.view.scene.onFrame(({ moving }) => (window.onTheWay += moving));
      });
      await page.locator('[data-testid="view-findings"] [data-finding-id="G1"]').click();
      await expectChosen(page, 1, 'G1', worst);
      assert.equal(await page.evaluate(() => window.onTheWay > 0), reducedMotion !== 'reduce');
    }));

test('from the first screen to the worst gouge: one button; its program text is shown', () =>
  withReport(browser, 'gouging', {}, async (page) => {
    const [worst] = resultOf('gouging').stages[1].deviation.gouges;
    const button = page.locator('header [data-finding="1:G1"] ~ [data-testid="show-finding"]').first();
    await button.click();
    await expectChosen(page, 1, 'G1', worst);
    const canvas = await part(page, 'view-canvas').boundingBox();
    assert.ok(canvas.y >= -1 && canvas.y < 900 - 200, 'the view is on the screen');
    const text = await part(page, 'view-finding').innerText();
    assert.match(text, /N190 Z-0\.06 X14\./, 'the line that gouged');
    assert.match(text, /N185 Y-4\./, 'the line before');
    assert.match(text, /onerror=window\.hostile/, 'a comment is text');
  }));

test('from a row of the table to its place', () =>
  withReport(browser, 'undecided', {}, async (page) => {
    const { uncuts } = resultOf('undecided').stages[2].deviation;
    // By the keyboard: a page that still draws its charts can move away between a pointer's press and release.
    await page.locator('tr[data-finding="2:U1"] [data-testid="show-finding"]').press('Enter');
    await expectChosen(page, 2, 'U1', uncuts[0]);
  }));
