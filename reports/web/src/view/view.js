import './viewer.css';
import { createLayers } from './scene/layers.js';
import { make } from '../base/dom.js';
import { LOST, MISSING, sentence } from './messages.js';
import { createScene } from './scene/scene.js';
import { startStockView } from '../stock/stock_view.js';
import { createViewer } from './viewer.js';

/**
 * Starts the error map in 3D.
 * @param {object} report as decodeReport gives it
 * @param {HTMLElement} element where it goes; emptied
 * @returns {Promise<object|null>} what window.limitgauge.view is, after the first frame; null where nothing
 *   can be drawn
 */
export async function startView(report, element) {
  if (!report.stages.some(({ field }) => field)) return startStockView(report, element);
  const frame = make('div', {
    class: 'view-frame', tabindex: '0', role: 'application', data: { testid: 'view-canvas' },
    'aria-label': 'Error map of the part. Arrow keys turn it, Shift with arrow keys moves it, '
      + 'plus and minus zoom, Home shows the whole part; the deviation at the crosshair is read out.',
  });
  const viewer = createViewer(report, frame);
  element.replaceChildren(viewer.element);
  const scene = createScene(frame, report);
  if (!scene) {
    element.replaceChildren(sentence(MISSING));
    return null;
  }
  scene.onLost(() => viewer.element.replaceChildren(sentence(LOST)));
  const view = viewer.attach(scene, createLayers(scene, report));
  await view.settled();
  return view;
}
