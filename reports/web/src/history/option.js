import { axisOption, commonOption, tooltipLines } from '../charts/theme.js';
import { limitText, nearestRun, runName, seriesTitle } from './data.js';
import { panelExtent, panelSeries, placeOf } from './panels.js';
import { runLines } from './run_text.js';

const PANEL_PX = 130, TITLE_PX = 42, TOP_PX = 4, BELOW_PX = 104, NARROW_PX = 640;

/** Height of a job's chart, px. */
export const chartHeight = (job) => TOP_PX + job.series.length * (TITLE_PX + PANEL_PX) + BELOW_PX;

/** The runs that are in sight: their first and last index. */
export function runsInSight(job, { byTime, zoom }) {
  const places = job.runs.map((run) => placeOf(run, byTime));
  const least = places[0], most = places.at(-1);
  const at = (percent) => least + ((most - least) * percent) / 100;
  const first = places.findIndex((place) => place >= at(zoom[0]) - 1e-6);
  const last = places.findLastIndex((place) => place <= at(zoom[1]) + 1e-6);
  return [Math.max(0, first - 1), Math.min(places.length - 1, last + 1)];
}

/**
 * What ECharts draws of a job: a panel a figure, all over the same runs.
 * @param {object} job as decodeHistory gives it
 * @param {{byTime: boolean, zoom: number[], pinned: object|null}} state zoom in percent of the axis
 */
export function historyOption(job, state, colours, width_px) {
  const left = width_px < NARROW_PX ? 46 : 64;
  // All panels stand over the same runs, however wide their labels are.
  const grid = { left, right: 18, height: PANEL_PX, outerBoundsMode: 'none' };
  return {
    ...commonOption(colours, `Figures of ${job.runs.length} runs of ${job.job}; the table below holds them`),
    grid: job.series.map((_, i) => ({ ...grid, top: TOP_PX + TITLE_PX + i * (TITLE_PX + PANEL_PX) })),
    tooltip: tooltip(job, state, colours),
    axisPointer: { link: [{ xAxisIndex: 'all' }], lineStyle: { color: colours.soft } },
    xAxis: job.series.map((_, i) => runAxis(job, state, i, colours, width_px)),
    yAxis: job.series.map((series, i) => figureAxis(job, series, i, state, colours, left)),
    dataZoom: zoomOption(job, state, colours, left),
    series: job.series.flatMap((series, panel) =>
      panelSeries(job, series, { ...state, panel }, colours)),
  };
}

/** The axes alone, for when the zoom has changed. */
export const zoomedAxes = (job, state) => ({
  yAxis: job.series.map((series) => {
    const [min, max] = panelExtent(series, ...runsInSight(job, state));
    return { min, max };
  }),
});

function tooltip(job, { byTime }, colours) {
  return {
    ...commonOption(colours, '').tooltip,
    formatter(params) {
      const at = params[0]?.axisValue;
      if (at === undefined) return '';
      return tooltipLines(runLines(job, nearestRun(job.runs, Number(at), byTime)));
    },
  };
}

function runAxis(job, { byTime }, panel, colours, width_px) {
  const isLast = panel === job.series.length - 1;
  const label = {
    show: isLast, color: colours.soft, fontSize: 13, lineHeight: 17, hideOverlap: true,
    formatter: byTime ? undefined : (index) => axisName(job.runs[Number(index)]),
  };
  const common = { gridIndex: panel, axisLabel: label, splitLine: { show: false } };
  if (byTime) return axisOption(colours, { ...common, type: 'time', splitNumber: width_px < NARROW_PX ? 2 : 6 });
  return axisOption(colours, {
    ...common, type: 'category', data: job.runs.map(({ index }) => String(index)), boundaryGap: true,
  });
}

/** The commit or label that a run is known by, over two lines with its number. */
const axisName = (run) => (run ? `${shortened(runName(run), 12)}\n#${run.id}` : '');
const shortened = (text, most) => (text.length > most ? `${text.slice(0, most - 1)}\u2026` : text);

function figureAxis(job, series, panel, state, colours, left) {
  const [min, max] = panelExtent(series, ...runsInSight(job, state));
  const limit = series.values.findLast((value) => value?.limit !== undefined)?.limit;
  const unit = series.scale.symbol ? `, ${series.scale.symbol}` : '';
  const stated = limit === undefined ? '' : `   (${limitText(series, limit)})`;
  return axisOption(colours, {
    gridIndex: panel, type: 'value', min, max, splitNumber: 3,
    name: `${shortened(seriesTitle(series), 40)}${unit}${stated}`, nameLocation: 'end', nameGap: 10,
    nameTextStyle: { color: colours.ink, fontSize: 14, fontWeight: 600, align: 'left', padding: [0, 0, 0, 8 - left] },
    axisLine: { show: false, onZero: false }, axisTick: { show: false },
    axisLabel: { color: colours.soft, fontSize: 13, showMinLabel: min === 0, showMaxLabel: false },
  });
}

function zoomOption(job, { zoom }, colours, left) {
  const all = { xAxisIndex: job.series.map((_, i) => i), start: zoom[0], end: zoom[1], filterMode: 'none' };
  return [
    // The wheel alone scrolls the page.
    { ...all, type: 'inside', zoomOnMouseWheel: 'ctrl', moveOnMouseMove: false, moveOnMouseWheel: false },
    { ...all, type: 'slider', bottom: 12, height: 30, left, right: 18, showDetail: false,
      borderColor: colours.rule, backgroundColor: 'transparent', fillerColor: `${colours.link}33`,
      dataBackground: { lineStyle: { color: colours.bar }, areaStyle: { color: colours.rule } },
      handleStyle: { color: colours.panel, borderColor: colours.link },
      moveHandleStyle: { color: colours.bar } },
  ];
}
