import { followPage } from './following.js';
import { init } from './library.js';

export { whenSeen } from './following.js';

/**
 * A chart in `container` that follows its size and the page's light or dark colours.
 * @param {(colours, width_px: number) => object} optionOf what ECharts is to draw
 * @returns the ECharts instance and `redraw()`, for when what `optionOf` reads has changed
 */
export function createLiveChart(container, optionOf) {
  return followPage(init(container, null, { renderer: 'svg' }), container, optionOf);
}
