// What a reader can set: sign, range, band, section plane, directions; what follows from it.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { resultOf } from './support/pages.mjs';
import { onScreen, part, press, readAt, settle, showCanvas, showStage, stateOf } from './support/view.mjs';

const browser = await openBrowser();
const legend = (page) => part(page, 'view-legend').innerText();

async function choose(page, id, value) {
  await part(page, id).selectOption(value);
  await settle(page);
}

test('the legend has words for both sides and the gate limits', () =>
  withReport(browser, 'failed', {}, async (page) => {
    await showStage(page, 1);
    const text = await legend(page);
    for (const words of [/too deep/i, /left|standing/i, /tolerance/i, /50\s*µm/, /0\.1\s*mm|100\s*µm/])
      assert.match(text, words);
  }));

test('the sign convention turns legend and readout over, not the measurement', () =>
  withReport(browser, 'failed', {}, async (page) => {
    const [worst] = resultOf('failed').stages[1].deviation.gouges;
    await page.evaluate(() => window.limitgauge.view.choose(1, 'G1'));
    await showCanvas(page);
    const read = async () => {
      const at = await onScreen(page, [worst.x, worst.y, worst.z]);
      const { deviation_mm } = await readAt(page, at);
      return { deviation_mm, text: await part(page, 'view-readout').innerText(), legend: await legend(page) };
    };
    const before = await read();
    await choose(page, 'view-sign', 'gouge');
    await showCanvas(page);
    const after = await read();
    assert.ok(Math.abs(before.deviation_mm + worst.depth_mm) < 0.002);
    assert.ok(Math.abs(Math.abs(after.deviation_mm) - worst.depth_mm) < 0.002);
    assert.match(before.text, /−6[123](\.\d)? µm/);
    assert.match(after.text, /\+?6[123](\.\d)? µm/);
    assert.doesNotMatch(after.text, /−6[123]/);
    assert.notEqual(after.legend, before.legend);
    assert.equal((await stateOf(page)).scale.sign, 'gouge');
  }));

test('the range goes by the gate, by what was measured, or as the reader says', () =>
  withReport(browser, 'failed', {}, async (page) => {
    await showStage(page, 1);
    const gate = { state: await stateOf(page), text: await legend(page) };
    assert.equal(gate.state.scale.gouge_mm.end, 0.1);
    await choose(page, 'view-range', 'measured');
    const measured = { state: await stateOf(page), text: await legend(page) };
    assert.notEqual(measured.text, gate.text);
    const { high } = resultOf('failed').stages[1].deviation.gouge_mm;
    assert.ok(measured.state.scale.gouge_mm.end >= high, 'nothing measured is off the scale');
    await choose(page, 'view-range', 'own');
    await part(page, 'view-own-gouge').fill('25');
    await part(page, 'view-own-gouge').press('Enter');
    await settle(page);
    assert.ok(Math.abs((await stateOf(page)).scale.gouge_mm.end - 0.025) < 1e-9);
    assert.match(await legend(page), /25\s*µm/);
  }));

test('band and section change the picture, and the section follows its slider', () =>
  withReport(browser, 'failed', {}, async (page) => {
    await showStage(page, 1);
    const canvas = part(page, 'view-canvas');
    const pictures = new Set();
    const shoot = async () => {
      await showCanvas(page);
      pictures.add((await canvas.screenshot()).toString('base64'));
    };
    await shoot();
    await part(page, 'view-band').click();
    await settle(page);
    await shoot();
    await choose(page, 'view-section', '0');
    await shoot();
    const { section } = await stateOf(page);
    assert.equal(section.axis, 0);
    assert.ok(await part(page, 'view-section-chart').isVisible());
    await part(page, 'view-section-offset').focus();
    for (let i = 0; i < 5; ++i) await page.keyboard.press('ArrowRight');
    await settle(page);
    await shoot();
    assert.ok((await stateOf(page)).section.offset_mm > section.offset_mm);
    await part(page, 'view-section-flip').click();
    await settle(page);
    await shoot();
    assert.equal(pictures.size, 5, 'five pictures, no two the same');
    await choose(page, 'view-section', 'none');
    assert.equal((await stateOf(page)).section, null);
  }));

test('what the section takes away cannot be read through it', () =>
  withReport(browser, 'failed', {}, async (page) => {
    await showStage(page, 1);
    await press(page, 'view-top');
    await choose(page, 'view-section', '0');
    await showCanvas(page);
    const z = (x) => 9 * Math.cos(x / 26) + 0.6 * Math.sin(x / 5);
    const { offset_mm } = (await stateOf(page)).section;
    const reads = [];
    for (const x of [offset_mm - 8, offset_mm + 8])
      reads.push(await readAt(page, await onScreen(page, [x, 0, z(x)])));
    assert.equal(reads.filter((read) => read === null).length, 1, 'one side is gone');
  }));

test('drag turns, wheel zooms, buttons give the fixed directions', () =>
  withReport(browser, 'passed', { reducedMotion: 'reduce' }, async (page) => {
    const canvas = await showCanvas(page);
    const middle = { x: canvas.x + canvas.width / 2, y: canvas.y + canvas.height / 2 };
    const home = (await stateOf(page)).camera;
    await page.mouse.move(middle.x, middle.y);
    await page.mouse.down();
    await page.mouse.move(middle.x + 80, middle.y + 30, { steps: 4 });
    await page.mouse.up();
    await settle(page);
    const turned = (await stateOf(page)).camera;
    assert.notEqual(turned.azimuth_deg, home.azimuth_deg);
    assert.notEqual(turned.elevation_deg, home.elevation_deg);
    assert.deepEqual(turned.focal, home.focal);
    await showCanvas(page);
    await part(page, 'view-canvas').focus();
    await page.mouse.move(middle.x, middle.y);
    await page.mouse.wheel(0, -300);
    await settle(page);
    assert.ok((await stateOf(page)).camera.scale_mm < home.scale_mm, 'nearer');
    const directions = { 'view-top': [-90, 90], 'view-front': [-90, 0], 'view-right': [0, 0] };
    for (const [id, angles] of Object.entries(directions)) {
      await press(page, id);
      const { azimuth_deg, elevation_deg, scale_mm } = (await stateOf(page)).camera;
      assert.deepEqual([azimuth_deg, elevation_deg], angles, id);
      assert.ok(scale_mm > 10, 'the whole part again');
    }
  }));

test('a fixture stands about the part and can be put away', () =>
  withReport(browser, 'gouging', {}, async (page) => {
    assert.deepEqual((await stateOf(page)).fixtures, ['clamp']);
    const box = part(page, 'view-fixtures');
    assert.ok(await box.isChecked());
    // It is drawn there: what stands at its middle is another colour with it than without it.
    await press(page, 'view-top');
    await page.evaluate(() => window.limitgauge.view.scene.flyTo(
      { point_mm: [60, 0, 0], normal: [0, 0, 1], distance_mm: 60 }));
    const middle = async () => {
      await settle(page);
      const { x, y, width, height } = await showCanvas(page);
      const clip = { x: x + width / 2 + 20, y: y + height / 2 + 20, width: 4, height: 4 };
      return (await page.screenshot({ clip })).toString('base64');
    };
    const shown = await middle();
    await box.uncheck();
    assert.deepEqual((await stateOf(page)).fixtures, []);
    assert.notEqual(await middle(), shown);
    await box.check();
    assert.equal(await middle(), shown);
  }));

test('a run without fixtures has no switch for them', () =>
  withReport(browser, 'passed', {}, async (page) => {
    assert.equal(await part(page, 'view-fixtures').count(), 0);
  }));
