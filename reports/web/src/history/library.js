/** What a history's charts use of ECharts beyond the report's. */
import { DataZoomInsideComponent, DataZoomSliderComponent } from 'echarts/components';
import { use } from 'echarts/core';

use([DataZoomInsideComponent, DataZoomSliderComponent]);
