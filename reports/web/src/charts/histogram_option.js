import { grouped } from '../base/figure_text.js';
import { threeDigits, unitFor } from '../base/format.js';
import { histogramAxis, leastDecade, placeWords } from './bins.js';
import { axisOption, commonOption, tooltipLines } from './theme.js';

/**
 * Above the plot every kind of mark has a row of its own, from the top: gouge limit, uncut limit, median,
 * other percentiles. So none is printed over another, however near to each other their lines stand.
 */
const ROW_PX = 18, ROWS = 4;
/** The widest that a bold letter of 13 px is on average. */
const LETTER_PX = 9.6;

/**
 * What ECharts draws of a stage's histogram.
 * @param {{bars, stage, logarithmic: boolean}} chart bars of bins.js
 */
export function histogramOption({ bars, stage, logarithmic }, colours, width_px) {
  const axis = histogramAxis(stage.histogram, stage.limits);
  const unit = unitOf(axis);
  return {
    ...commonOption(colours, `Histogram of deviation of stage ${stage.name}, area-weighted`),
    grid: {
      left: 8, right: 26, top: ROWS * ROW_PX + 6, bottom: 34,
      outerBoundsMode: 'same', outerBoundsContain: 'axisLabel',
    },
    tooltip: {
      ...commonOption(colours, '').tooltip,
      axisPointer: { type: 'line', lineStyle: { color: colours.soft } },
      formatter: (params) => barTooltip(params, bars, stage.limits, unit),
    },
    xAxis: axisOption(colours, {
      type: 'value', min: axis.low_mm * unit.perMm, max: axis.high_mm * unit.perMm,
      name: `deviation, ${unit.symbol}`, nameLocation: 'middle', nameGap: 26, splitLine: { show: false },
      axisLabel: {
        color: colours.soft, fontSize: 13, hideOverlap: true, showMinLabel: false, showMaxLabel: false,
        formatter: signedTick,
      },
    }),
    yAxis: areaAxis(colours, bars, logarithmic),
    series: [barSeries(bars, unit, colours, logarithmic), markSeries(stage, axis, unit, colours),
      limitSeries(limitMarks(stage.limits, axis, unit), colours, width_px)],
  };
}

/** The unit of the whole axis. */
export const unitOf = ({ low_mm, high_mm }) => unitFor(Math.max(-low_mm, high_mm));

const signed = (text, value) => (value > 0 ? `+${text}` : text);
const signedTick = (value) => signed(String(Number(value.toPrecision(6))).replace('-', '\u2212'), value);

const areaTick = (value) => (value >= 1e4 ? grouped(value) : String(Number(value.toPrecision(6))));

function areaAxis(colours, bars, logarithmic) {
  return axisOption(colours, {
    type: logarithmic ? 'log' : 'value',
    min: logarithmic ? leastDecade(bars) : 0, splitNumber: 4,
    axisLine: { show: false, onZero: false }, axisTick: { show: false },
    axisLabel: { color: colours.soft, fontSize: 13, hideOverlap: true, formatter: areaTick },
  });
}

function barSeries(bars, unit, colours, logarithmic) {
  const base = logarithmic ? leastDecade(bars) : 0;
  return {
    type: 'custom', name: 'area', clip: true,
    encode: { x: 0, y: 1 },
    data: bars.map(({ low_mm, high_mm, area_mm2 }) => [((low_mm + high_mm) / 2) * unit.perMm, area_mm2]),
    renderItem(params, api) {
      const { low_mm, high_mm, area_mm2, side } = bars[params.dataIndex];
      const [left, top] = api.coord([low_mm * unit.perMm, area_mm2]);
      const [right, bottom] = api.coord([high_mm * unit.perMm, base]);
      // A bin that holds anything at all must be seen.
      const height = Math.max(bottom - top, 2);
      return {
        type: 'rect',
        shape: { x: left, y: bottom - height, width: Math.max(right - left, 1), height },
        style: { fill: side === 'inside' ? colours.bar : colours[side] },
      };
    },
  };
}

function barTooltip(params, bars, limits, unit) {
  const bar = bars[params[0]?.dataIndex];
  if (!bar) return '';
  const whole = bars.reduce((sum, { area_mm2 }) => sum + area_mm2, 0);
  const end = (mm) => signed(threeDigits(mm * unit.perMm), mm);
  return tooltipLines([
    `${end(bar.low_mm)} to ${end(bar.high_mm)} ${unit.symbol}`,
    `${threeDigits(bar.area_mm2)} mm\u00b2, ${threeDigits((100 * bar.area_mm2) / whole)} % of the area`,
    placeWords(bar, limits),
  ]);
}

/** Lines for zero and the percentiles. */
function markSeries(stage, axis, unit, colours) {
  return {
    type: 'line', data: [], silent: true,
    markLine: {
      silent: true, symbol: 'none', animation: false,
      data: [
        { xAxis: 0, lineStyle: { color: colours.soft, width: 1, type: 'dashed' }, label: { show: false } },
        ...percentileMarks(stage, axis, unit, colours)],
    },
  };
}

/**
 * The limits as they stand on the axis: `at` in its unit, held to its ends; `inside` whether that is where it
 * is; `row` of its words.
 */
export function limitMarks({ gouge_mm, uncut_mm }, axis, unit) {
  const marks = [['gouge', gouge_mm === undefined ? undefined : -gouge_mm, 0], ['uncut', uncut_mm, 1]];
  return marks.filter(([, at]) => at !== undefined).map(([side, at, row]) => {
    const held = Math.min(Math.max(at, axis.low_mm), axis.high_mm), inside = held === at;
    const text = `${side} limit ${Number((Math.abs(at) * unit.perMm).toPrecision(9))} ${unit.symbol}`;
    const arrowed = at < held ? `\u2190 ${text}` : `${text} \u2192`;
    return { at: held * unit.perMm, inside, row, text: inside ? text : arrowed };
  });
}

/** A line each over the height of the plot, its words above it, kept inside the chart at both sides. */
function limitSeries(marks, colours, width_px) {
  return {
    type: 'custom', silent: true, clip: false, z: 5, encode: { x: 0 },
    data: marks.map(({ at }) => [at]),
    renderItem({ dataIndex, coordSys }, api) {
      const { at, inside, row, text } = marks[dataIndex];
      const [x] = api.coord([at, 0]), half = (LETTER_PX * text.length) / 2;
      const middle = Math.min(Math.max(x, half + 2), width_px - half - 2);
      const words = {
        type: 'text', x: middle, y: row * ROW_PX + 2,
        style: { text, fill: colours.ink, align: 'center', verticalAlign: 'top',
          font: `600 13px ${colours.font || 'sans-serif'}` },
      };
      const { y, height } = coordSys;
      const line = {
        type: 'line', shape: { x1: x, x2: x, y1: y, y2: y + height },
        style: { stroke: colours.ink, lineWidth: 2 },
      };
      return { type: 'group', children: inside ? [words, line] : [words] };
    },
  };
}

/** The percentiles that the data have: {name, at_mm}. */
export function percentilesOf({ percentiles }) {
  return ['p01', 'p50', 'p99']
    .filter((name) => Number.isFinite(percentiles?.[`${name}_mm`]))
    .map((name) => ({ name, at_mm: percentiles[`${name}_mm`] }));
}

function percentileMarks(stage, axis, unit, colours) {
  // Their labels stand apart even where all three lie close together.
  const place = { p01: ['right', 4], p50: ['center', 4 + ROW_PX], p99: ['left', 4] };
  return percentilesOf(stage)
    .filter(({ at_mm }) => at_mm >= axis.low_mm && at_mm <= axis.high_mm)
    .map(({ name, at_mm }) => ({
      xAxis: at_mm * unit.perMm,
      lineStyle: { color: colours.link, width: 1.5, type: [2, 3] },
      label: {
        show: true, position: 'end', distance: place[name][1], align: place[name][0], color: colours.link,
        fontSize: 13, formatter: name,
      },
    }));
}
