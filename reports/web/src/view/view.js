import './viewer.css';
import { createLayers } from './scene/layers.js';
import { make } from '../base/dom.js';
import { createScene } from './scene/scene.js';
import { createViewer } from './viewer.js';

const MISSING = 'The 3D view needs WebGL 2, which this browser does not offer or has switched off. '
  + 'All figures, findings and maps stand in the page below.';
const LOST = 'The graphics card has taken its memory back, and the 3D view with it. Load the page again to '
  + 'see it; all figures, findings and maps stand in the page below.';

/**
 * Starts the error map in 3D.
 * @param {object} report as decodeReport gives it
 * @param {HTMLElement} element where it goes; emptied
 * @returns {Promise<object|null>} what window.limitgauge.view is, after the first frame; null where nothing
 *   can be drawn
 */
export async function startView(report, element) {
  if (!report.stages.some(({ field }) => field)) return null;
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

const sentence = (text) => make('p', { class: 'view-missing', text, data: { testid: 'view-missing' } });
