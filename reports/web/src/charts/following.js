import { pageColours } from './theme.js';

/**
 * Keeps a chart at its container's size and in the page's light or dark colours.
 * @param chart an ECharts instance in `container`
 * @param {(colours, width_px: number) => object} optionOf what ECharts is to draw
 * @param {boolean} [merges] what is not named again stays: what a reader has marked on an axis
 * @returns the chart and `redraw()`, for when what `optionOf` reads has changed
 */
export function followPage(chart, container, optionOf, merges = false) {
  const redraw = () =>
    chart.setOption(optionOf(pageColours(), container.clientWidth), { notMerge: !merges });
  redraw();
  let width = container.clientWidth, waiting = false;
  new ResizeObserver(() => {
    if (waiting || container.clientWidth === width || container.clientWidth === 0) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      width = container.clientWidth;
      chart.resize();
      redraw();
    });
  }).observe(container);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
  return { chart, redraw };
}

/** Calls `build` once, when `element` is about to come into sight. */
export function whenSeen(element, build) {
  const observer = new IntersectionObserver((entries) => {
    if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
    observer.disconnect();
    build();
  }, { rootMargin: '200px' });
  observer.observe(element);
}
