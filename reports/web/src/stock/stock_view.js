import { make } from '../base/dom.js';
import { createScene } from '../view/scene/scene.js';
import { LOST, MISSING, sentence } from '../view/messages.js';
import { StockViewer } from './stock_viewer.js';

/**
 * Starts the view of the stock, for a run without a design.
 * @returns {Promise<object|null>} what window.limitgauge.view is, after the first frame; null where nothing
 *   can be drawn
 */
export async function startStockView(report, element) {
  if (!report.stages.some(({ stock }) => stock)) return null;
  const frame = make('div', {
    class: 'view-frame', tabindex: '0', role: 'application', data: { testid: 'view-canvas' },
    'aria-label': 'The finished stock. Arrow keys turn it, Shift with arrow keys moves it, plus and minus '
      + 'zoom, Home shows all of it, Enter takes the point at the crosshair for the distance.',
  });
  const viewer = new StockViewer(report, frame);
  element.replaceChildren(viewer.element);
  const scene = createScene(frame, report);
  if (!scene) {
    element.replaceChildren(sentence(MISSING));
    return null;
  }
  scene.onLost(() => viewer.element.replaceChildren(sentence(LOST)));
  viewer.attach(scene);
  await scene.settled();
  const corner = () => frame.getBoundingClientRect();
  return {
    state: () => viewer.state(),
    project(point_mm) {
      const { x, y } = scene.project(point_mm);
      return { x: x + corner().left, y: y + corner().top };
    },
    pick: (x, y) => viewer.readingAt(x - corner().left, y - corner().top),
    choose: (stage, id) => viewer.show(stage, id),
    settled: () => scene.settled(),
    scene, path: viewer.layer,
  };
}
