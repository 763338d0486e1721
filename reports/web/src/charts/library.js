/** The parts of ECharts that the charts use; what is not named here is not in the page. */
import { CustomChart, LineChart, ScatterChart } from 'echarts/charts';
import { AriaComponent, GridComponent, MarkLineComponent, TooltipComponent } from 'echarts/components';
import { init, use } from 'echarts/core';
import { SVGRenderer } from 'echarts/renderers';

use([AriaComponent, CustomChart, GridComponent, LineChart, MarkLineComponent, ScatterChart, SVGRenderer,
  TooltipComponent]);

export { init };
