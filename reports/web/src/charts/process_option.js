import { clockMark, clockText, feedText, grouped, rateText } from '../base/figure_text.js';
import { clockInterval } from './clock_axis.js';
import { axisOption, commonOption, tooltipLines } from './theme.js';

const MOST_MARKS = 100;
const GRID_HEIGHT = 120, GRID_STEP = 178, FIRST_TOP = 34, LEFT = 66;

/** How high the chart is, px. */
export const processHeight = (bins) => (bins.rate ? GRID_STEP : 0) + FIRST_TOP + GRID_HEIGHT + 34;

/**
 * What ECharts draws of a stage's process: removal rate (where there is one) over feed, over machining
 * time.
 * @param {{bins, total_s, stage, findings, logarithmic}} chart bins and findings of bins.js; logarithmic:
 *   the removal rate, whose peaks may be a hundred times its mean
 */
export function processOption(chart, colours, width_px) {
  const { bins, total_s, stage, findings } = chart;
  const log = Boolean(chart.logarithmic && bins.rate?.some(({ max }) => max > 0));
  const panels = [
    ...(bins.rate ? [{ name: 'removal rate, mm\u00b3/min', values: bins.rate, log }] : []),
    { name: 'feed, mm/min', values: bins.feed, log: false },
  ];
  const interval = clockInterval(total_s, Math.max(3, width_px / 110));
  return {
    ...commonOption(colours, `Removal rate and feed of stage ${stage.name} over machining time`),
    axisPointer: { link: [{ xAxisIndex: 'all' }], lineStyle: { color: colours.soft } },
    tooltip: { ...commonOption(colours, '').tooltip, formatter: (params) => tooltip(params, bins, findings) },
    // Both panels begin at the same place, however wide their figures are.
    grid: panels.map((_, i) => ({
      left: LEFT, right: 18, top: FIRST_TOP + i * GRID_STEP, height: GRID_HEIGHT, outerBoundsMode: 'none',
    })),
    xAxis: panels.map((_, i) => axisOption(colours, {
      type: 'value', gridIndex: i, min: 0, max: total_s, interval, splitLine: { show: false },
      axisLabel: {
        color: colours.soft, fontSize: 13, hideOverlap: true, showMaxLabel: false, formatter: clockMark,
      },
    })),
    yAxis: panels.map((panel, i) => axisOption(colours, {
      type: panel.log ? 'log' : 'value', min: panel.log ? leastRate(bins.rate) : 0,
      gridIndex: i, splitNumber: 3, name: panel.name, nameLocation: 'end', nameGap: 12,
      nameTextStyle: { color: colours.soft, fontSize: 13, align: 'left', padding: [0, 0, 0, 8 - LEFT] },
      axisLine: { show: false, onZero: false }, axisTick: { show: false },
      axisLabel: { color: colours.soft, fontSize: 13, formatter: (value) => grouped(value) },
    })),
    series: panels.flatMap((panel, i) => panelSeries(panel, i, { bins, total_s, findings }, colours)),
  };
}

/** A power of ten below the least mean; a ten thousandth of the largest where that is more. */
export function leastRate(rates) {
  const least = Math.min(...rates.map(({ mean }) => (mean > 0 ? mean : Infinity)));
  const most = Math.max(...rates.map(({ max }) => max));
  return 10 ** Math.floor(Math.log10(Math.max(Math.min(least, most), most / 1e4)));
}

function panelSeries({ values, log }, index, { bins, total_s, findings }, colours) {
  const line = (figure, more) => ({
    type: 'line', xAxisIndex: index, yAxisIndex: index, step: 'end', symbol: 'none', connectNulls: false,
    data: steps(values, figure, bins.width_s, total_s).map(log ? ofLog : (point) => point), ...more,
  });
  const series = [
    line('max', { lineStyle: { width: 0 }, areaStyle: { color: colours.bar, opacity: 0.45 } }),
    line('mean', { lineStyle: { width: 1.5, color: colours.link } }),
  ];
  if (findings.length > 0) series[1].markLine = findingLines(findings, colours);
  return series;
}

/** Nothing has no place on a logarithmic axis. */
const ofLog = ([x, y]) => [x, y > 0 ? y : null];

/** Points of a step line: each value from the beginning of its bin on. */
function steps(values, figure, width_s, total_s) {
  const points = values.map((value, i) => [i * width_s, value ? value[figure] : null]);
  const last = values[values.length - 1];
  return [...points, [total_s, last ? last[figure] : null]];
}

const colourOf = (finding, colours) => (finding.kind === 'near_miss' ? colours.open : colours.fail);

function findingLines(findings, colours) {
  return {
    silent: true, animation: false, symbol: ['none', 'triangle'], symbolSize: 9, symbolRotate: 180,
    data: findings.slice(0, MOST_MARKS).map((finding) => ({
      xAxis: finding.time_s, label: { show: false },
      lineStyle: { color: colourOf(finding, colours), width: 1.5, type: 'dashed' },
    })),
  };
}

function tooltip(params, bins, findings) {
  const from = Math.floor(params[0].axisValue / bins.width_s + 1e-9);
  const bin = Math.min(Math.max(from, 0), bins.feed.length - 1);
  const start = bin * bins.width_s, end = start + bins.width_s;
  const lines = [`${clockText(start)} to ${clockText(end)}`];
  const add = (name, value, text) =>
    lines.push(value ? `${name}: mean ${text(value.mean)}, at most ${text(value.max)}` : `${name}: none`);
  if (bins.rate) add('removal rate', bins.rate[bin], rateText);
  add('feed', bins.feed[bin], feedText);
  for (const { id, words, line } of near(findings, start, end))
    lines.push(`${id}: ${words}${line > 0 ? `, program line ${line}` : ''}`);
  return tooltipLines(lines);
}

/** The findings of a bin and of its neighbours: a pointer seldom meets the very one. */
function near(findings, start, end) {
  const width = end - start;
  return findings.filter(({ time_s }) => time_s >= start - width && time_s <= end + width).slice(0, 6);
}
