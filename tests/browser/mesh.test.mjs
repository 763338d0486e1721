// A design that is a mesh: places are named by its triangles, and its many borders are not drawn.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { resultOf } from './support/pages.mjs';
import { onScreen, part, press, settle, showCanvas, stateOf } from './support/view.mjs';

const browser = await openBrowser();

test('findings and the readout name triangles of the file', () =>
  withReport(browser, 'mesh', { reducedMotion: 'reduce' }, async (page) => {
    const [worst] = resultOf('mesh').stages[0].deviation.gouges;
    assert.ok(worst.triangle > 0);
    const list = await part(page, 'view-findings').innerText();
    assert.match(list, new RegExp(`triangle ${worst.triangle}\\b`));
    assert.doesNotMatch(list, /patch/);
    assert.match(await part(page, 'view-finding').innerText(), new RegExp(`Triangle\\s+${worst.triangle}\\b`));
    await press(page, 'view-top');
    await showCanvas(page);
    const { x, y } = await onScreen(page, [worst.x, worst.y, worst.z]);
    await page.mouse.move(x, y);
    await settle(page);
    assert.match(await part(page, 'view-readout').innerText(), /triangle \d+/);
  }));

test('borders of more than 500 patches are off to begin with, and can be switched on', () =>
  withReport(browser, 'mesh', {}, async (page) => {
    assert.equal(await part(page, 'view-borders').isChecked(), false);
    assert.equal((await stateOf(page)).layers.borders, false);
    await part(page, 'view-borders').check();
    assert.equal((await stateOf(page)).layers.borders, true);
  }));

test('those of a few are drawn', () =>
  withReport(browser, 'failed', {}, async (page) => {
    assert.ok(await part(page, 'view-borders').isChecked());
    assert.equal((await stateOf(page)).layers.borders, true);
  }));
