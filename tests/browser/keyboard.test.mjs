// All of the page works from the keyboard alone.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { controls } from './support/layout.mjs';
import { part, settle, showStage, stateOf } from './support/view.mjs';

const browser = await openBrowser();

/** Marks each control that is shown, enabled and not a part of a group that has one stop for all. */
const markControls = (page) => page.evaluate((controls) => {
  const reachable = (e) => e.checkVisibility({ visibilityProperty: true }) && !e.disabled &&
    e.getAttribute('tabindex') !== '-1';
  [...document.querySelectorAll(controls)].filter(reachable).forEach((e, i) => (e.dataset.stop = i));
  return document.querySelectorAll('[data-stop]').length;
}, controls);

/** The focused control: its mark, a description, and whether one sees that it has the focus. */
const focused = (page) => page.evaluate(() => {
  const e = document.activeElement;
  if (!e || e === document.body) return null;
  const look = (style) => [style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) > 0,
    style.boxShadow !== 'none'].some(Boolean);
  const box = e.getBoundingClientRect();
  return {
    stop: e.dataset.stop,
    what: `${e.tagName} ${e.dataset.testid ?? ''} ${(e.ariaLabel ?? e.textContent).trim().slice(0, 30)}`,
    marked: look(getComputedStyle(e)) || (e.parentElement && look(getComputedStyle(e.parentElement))),
    onScreen: box.bottom > 0 && box.top < innerHeight && box.right > 0 && box.left < innerWidth,
  };
});

/**
 * The stops up to the page's end. A chart that comes into sight may put away the switch that has the
 * focus; Tab goes on from there, and at the page's end with the first stop again.
 */
async function tabThrough(page, most) {
  const stops = [];
  let lost = false;
  for (let i = 0; i < most; ++i) {
    await page.keyboard.press('Tab');
    const stop = await focused(page);
    if (lost && (!stop || stops.some((known) => known.stop === stop.stop))) break;
    lost = !stop;
    if (stop) stops.push(stop);
  }
  return stops;
}

test('Tab comes by every control, shows where it is, and is caught nowhere', () =>
  withReport(browser, 'failed', { reducedMotion: 'reduce' }, async (page) => {
    // By a script: a click would leave the place from which Tab goes on.
    await part(page, 'view-path').evaluate((box) => box.click());
    await settle(page);
    const count = await markControls(page);
    const stops = await tabThrough(page, count + 50);
    const seen = new Set(stops.map((stop) => stop.stop));
    // A chart that has come into sight may have put a switch away that means nothing there.
    const missed = await page.evaluate((seen) => [...document.querySelectorAll('[data-stop]')]
      .filter((e) => !seen.includes(e.dataset.stop) && e.checkVisibility())
      .map((e) => e.outerHTML.slice(0, 120)), [...seen]);
    assert.deepEqual(missed, [], 'controls that Tab does not reach');
    assert.ok(stops.length < count + 50, 'Tab leaves the page at its end');
    assert.deepEqual(stops.filter((stop) => !stop.marked).map((stop) => stop.what), [], 'focus unseen');
    assert.deepEqual(stops.filter((stop) => !stop.onScreen).map((stop) => stop.what), [], 'off the screen');
  }));

test('keys choose a stage and a finding, and set what can be set', () =>
  withReport(browser, 'failed', { reducedMotion: 'reduce' }, async (page) => {
    await showStage(page, 0);
    await page.locator('[data-testid="view-stages"] [role=tab][data-stage="0"]').focus();
    await page.keyboard.press('ArrowRight');
    if ((await stateOf(page)).stage !== 1) await page.keyboard.press('Enter');
    await settle(page);
    assert.equal((await stateOf(page)).stage, 1);
    await page.locator('[data-testid="view-findings"] [data-finding-id="U1"]').focus();
    await page.keyboard.press('Enter');
    await settle(page);
    assert.equal((await stateOf(page)).finding, 'U1');
    await part(page, 'view-band').focus();
    const { band } = (await stateOf(page)).scale;
    await page.keyboard.press('Space');
    assert.equal((await stateOf(page)).scale.band, !band);
    await part(page, 'view-range').focus();
    await page.keyboard.press('ArrowDown');
    await settle(page);
    assert.notEqual(await part(page, 'view-range').inputValue(), 'gate');
  }));

test('in the view arrows turn, plus and minus zoom', () =>
  withReport(browser, 'passed', { reducedMotion: 'reduce' }, async (page) => {
    await part(page, 'view-canvas').focus();
    const home = (await stateOf(page)).camera;
    await page.keyboard.press('ArrowLeft');
    await settle(page);
    const turned = (await stateOf(page)).camera;
    assert.notEqual(turned.azimuth_deg, home.azimuth_deg);
    await page.keyboard.press('+');
    await settle(page);
    assert.ok((await stateOf(page)).camera.scale_mm < turned.scale_mm);
  }));
