import { twoFrames } from './browser.mjs';

/** The view's own account of itself, and the ways in which a reader acts on it. Points in mm. */

export const part = (page, id) => page.locator(`[data-testid="${id}"]`);

export const stateOf = (page) => page.evaluate(() => window.limitgauge.view.state());

/** Until the camera rests, and what it sees and what was said of it is drawn. */
export async function settle(page) {
  await page.evaluate(twoFrames);
  await page.evaluate(() => window.limitgauge.view.settled());
}

export async function showStage(page, index) {
  await page.locator(`[data-testid="view-stages"] [role=tab][data-stage="${index}"]`).click();
  await settle(page);
}

/** Brings the canvas onto the screen, as pointing at it needs. */
export async function showCanvas(page) {
  const canvas = part(page, 'view-canvas');
  await canvas.scrollIntoViewIfNeeded();
  await settle(page);
  return canvas.boundingBox();
}

/** Presses one of the view's buttons and waits for the camera. */
export async function press(page, id) {
  await part(page, id).click();
  await settle(page);
}

/** Where a point of the part lies on the screen, px. */
export const onScreen = (page, point) =>
  page.evaluate((p) => window.limitgauge.view.project(p), point);

/** What the readout says of the place under the pointer; null where it says nothing. */
export async function readAt(page, { x, y }) {
  await page.mouse.move(x, y);
  await settle(page);
  return part(page, 'view-readout').evaluate(({ dataset }) => {
    if (dataset.deviationMm === undefined) return null;
    const number = (key) => Number(dataset[key]);
    return {
      deviation_mm: number('deviationMm'), point_mm: ['xMm', 'yMm', 'zMm'].map(number),
      patch: number('patch'), u: number('u'), v: number('v'), line: number('line'),
      stage: number('stage'), reachable: dataset.reachable === 'true', sample: number('sample'),
      sample_deviation_mm: number('sampleDeviationMm'),
    };
  });
}

export const distance = (a, b) => Math.hypot(...a.map((c, i) => c - b[i]));

/** Shows the toolpath with its controls. */
export async function showPath(page) {
  await part(page, 'view-path').check();
  await settle(page);
}
