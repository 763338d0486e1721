/** The parts of ECharts that a study's page uses: on a canvas, for thousands of lines. */
import { CustomChart, LineChart, ParallelChart, ScatterChart } from 'echarts/charts';
import { AriaComponent, GridComponent, ParallelComponent, TooltipComponent } from 'echarts/components';
import { init, use } from 'echarts/core';
import { CanvasRenderer } from 'echarts/renderers';
import { followPage } from '../charts/following.js';

use([AriaComponent, CanvasRenderer, CustomChart, GridComponent, LineChart, ParallelChart, ParallelComponent,
  ScatterChart, TooltipComponent]);

/** A chart in `container` that follows its size and the page's colours; see charts/following.js. */
export function createChart(container, optionOf) {
  return followPage(init(container, null, { renderer: 'canvas' }), container, optionOf);
}
