import { drawnAt, standingOf } from './data.js';

/** A mark of its own for each way a figure may stand against its limit: it needs no colour. */
const MARKS = {
  pass: { symbol: 'circle', size: 8 },
  fail: { symbol: 'path://M1 0L5 4L9 0L10 1L6 5L10 9L9 10L5 6L1 10L0 9L4 5L0 1Z', size: 11 },
  indeterminate: { symbol: 'triangle', size: 10 },
};
const NO_MARK = { symbol: 'rect', size: 6 };

const colourOf = (standing, colours) =>
  ({ pass: colours.pass, fail: colours.fail, indeterminate: colours.open })[standing] ?? colours.soft;

/** Whether the run before measured something else under this name. */
const isNewMeaning = (value) => value?.trend === 'new meaning';

/** Where a run stands on the axis. */
export const placeOf = (run, byTime) => (byTime ? run.time_ms : run.index);

/**
 * What ECharts draws in one panel: the band of the certified intervals, the limit, and the figures.
 * @param {object} job with `runs`
 * @param {object} series of the job
 * @param {{panel: number, byTime: boolean, pinned: object|null}} how
 */
export function panelSeries(job, series, how, colours) {
  const axes = { xAxisIndex: how.panel, yAxisIndex: how.panel, animation: false };
  return [
    ...(series.source === 'certified' ? [bandSeries(job, series, how, colours, axes)] : []),
    ...(series.values.some((value) => value?.limit !== undefined)
      ? [limitSeries(job, series, how, colours, axes)] : []),
    ...stretches(series).map((stretch) => figureSeries(job, series, stretch, how, colours, axes)),
  ];
}

/** A bar from low to high at each run, and the ground between neighbours. */
function bandSeries(job, series, { byTime }, colours, axes) {
  const ends = series.values.map((value, index) => value && [
    placeOf(job.runs[index], byTime), value.low * series.scale.factor, value.high * series.scale.factor]);
  return {
    ...axes, type: 'custom', silent: true, clip: true, z: 1, dimensions: ['x', 'low', 'high'],
    encode: { x: 0, y: [1, 2] },
    data: ends.map((end) => end ?? [NaN, NaN, NaN]),
    renderItem({ dataIndex }, api) {
      const here = ends[dataIndex], next = ends[dataIndex + 1];
      if (!here) return undefined;
      const point = (end, side) => api.coord([end[0], end[side]]);
      const [x, bottom] = point(here, 1), [, top] = point(here, 2);
      const bar = {
        type: 'rect', shape: { x: x - 2, y: top, width: 4, height: Math.max(bottom - top, 1) },
        style: { fill: colours.bar, opacity: 0.8 },
      };
      if (!next || isNewMeaning(series.values[dataIndex + 1])) return { type: 'group', children: [bar] };
      const points = [point(here, 1), point(here, 2), point(next, 2), point(next, 1)];
      return {
        type: 'group',
        children: [{ type: 'polygon', shape: { points }, style: { fill: colours.bar, opacity: 0.28 } }, bar],
      };
    },
  };
}

/** As it was for each run: a gate may have been changed. */
function limitSeries(job, series, { byTime }, colours, axes) {
  return {
    ...axes, type: 'line', silent: true, step: 'middle', symbol: 'none', z: 2,
    lineStyle: { color: colours.ink, width: 1.5, type: [6, 4] },
    data: series.values.map((value, index) => [
      placeOf(job.runs[index], byTime), value?.limit === undefined ? null : value.limit * series.scale.factor]),
  };
}

/** Runs whose figures mean the same, as pairs [first, last]: no line leads from one to the next. */
function stretches({ values }) {
  const begins = [0, ...values.flatMap((value, index) => (isNewMeaning(value) ? [index] : []))];
  return begins.map((first, i) => [first, (begins[i + 1] ?? values.length) - 1]);
}

/** The first stretch brings the lines across the panel. */
function figureSeries(job, series, [first, last], { byTime, pinned }, colours, axes) {
  return {
    ...axes, type: 'line', z: 3, lineStyle: { color: colours.link, width: 1.5 },
    data: series.values.map((any, index) => {
      const value = index >= first && index <= last ? any : null;
      const run = job.runs[index], standing = standingOf(series, value);
      const { symbol, size } = MARKS[standing] ?? NO_MARK;
      return {
        value: [placeOf(run, byTime), value ? drawnAt(series, value) : null], symbol,
        symbolSize: pinned === run ? size + 5 : size, itemStyle: { color: colourOf(standing, colours) },
      };
    }),
    // Marks of hundreds of runs would be a bar.
    showSymbol: true, showAllSymbol: job.runs.length <= 400,
    emphasis: { disabled: true },
    markLine: {
      silent: true, symbol: 'none', animation: false, label: { show: false },
      lineStyle: { color: colours.ink, width: 1.5, type: 'solid' },
      data: first > 0 ? [] : [
        ...(pinned ? [{ xAxis: placeOf(pinned, byTime) }] : []),
        ...series.values.flatMap((value, index) => (isNewMeaning(value) ? [{
          xAxis: placeOf(job.runs[index], byTime), lineStyle: { type: 'dashed' },
          label: { show: true, formatter: 'new meaning', color: colours.ink },
        }] : [])),
      ],
    },
  };
}

/**
 * Least and largest value that a panel's axis holds: what is drawn of the runs from `first` to `last`, the
 * limit where it is not far from them.
 * @returns {[number, number]} in the unit of the series
 */
export function panelExtent(series, first, last) {
  let low = Infinity, high = -Infinity, limit = 0;
  for (const value of series.values.slice(first, last + 1)) {
    if (!value) continue;
    low = Math.min(low, value.low * series.scale.factor);
    high = Math.max(high, value.high * series.scale.factor);
    if (value.limit !== undefined) limit = value.limit * series.scale.factor;
  }
  if (low > high) return [0, 1];
  const isCoverage = series.metric === 'coverage';
  if (series.source === 'certified') low = Math.min(low, 0);
  if (limit > high && limit <= 4 * high) high = limit;
  // What is next to nothing against the limit must not look like a change.
  if (series.source === 'certified') high = Math.max(high, limit / 20);
  if (isCoverage && limit > 0) low = Math.min(low, limit);
  const margin = high > low ? 0.08 * (high - low) : Math.max(0.01 * Math.abs(high), 1e-6);
  return [low === 0 ? 0 : low - margin, isCoverage ? Math.min(100, high + margin) : high + margin];
}
