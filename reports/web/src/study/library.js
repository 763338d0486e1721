/** The parts of ECharts that a study's page uses: on a canvas, for thousands of lines. */
import { CustomChart, LineChart, ParallelChart, ScatterChart } from 'echarts/charts';
import { AriaComponent, GridComponent, ParallelComponent, TooltipComponent } from 'echarts/components';
import { init, use } from 'echarts/core';
import { CanvasRenderer } from 'echarts/renderers';
import { followPage } from '../charts/following.js';

use([AriaComponent, CanvasRenderer, CustomChart, GridComponent, LineChart, ParallelChart, ParallelComponent,
  ScatterChart, TooltipComponent]);

/** Colours of verdicts that are told apart without green and red: see study.css. */
function verdictColours(root = document.documentElement) {
  const style = getComputedStyle(root);
  return { passed: style.getPropertyValue('--study-passed').trim() };
}

/** A chart in `container` that follows its size and the page's colours; see charts/following.js. */
export function createChart(container, optionOf, merges) {
  const chart = init(container, null, { renderer: 'canvas' });
  return followPage(chart, container, (colours, width_px) =>
    optionOf({ ...colours, ...verdictColours() }, width_px), merges);
}
