import { axisOption, commonOption, tooltipLines } from '../charts/theme.js';
import { quantityAxis } from './axes.js';
import { curvesOf } from './curves.js';

const MOST_SYMBOLS = 30;

/**
 * What ECharts draws of a figure against a key: mean and range over the other keys, a line for each of
 * their combinations where those are few, and what the reference case gives.
 * @param board as createBoard gives it
 * @param {{key: number, figure: object}} what index of the key, and a figure
 */
export function curveOption(board, { key, figure }, extent, colours) {
  const { study } = board, quantity = study.keys[key];
  const curves = curvesOf(study, key, figure, board.rows());
  const common = commonOption(colours, `${figure.title} against ${quantity.title}`);
  const base = axisOption(colours, {});
  const axis = (of, more) => {
    const own = quantityAxis(of);
    return {
      ...base, ...own, ...more, axisTick: { ...base.axisTick, ...own.axisTick },
      axisLabel: { ...base.axisLabel, ...own.axisLabel, ...more.axisLabel },
    };
  };
  return {
    ...common,
    tooltip: { ...common.tooltip, formatter: (params) => tooltip(params, quantity, figure, curves) },
    grid: { left: 8, right: 18, top: 12, bottom: 36, containLabel: true },
    xAxis: axis(quantity, {
      name: quantity.title, nameLocation: 'middle', nameGap: 26, splitLine: { show: false }, splitNumber: 5,
      axisPointer: { snap: true },
    }),
    yAxis: axis(figure, { splitNumber: 4, ...(extent ? margins(extent) : {}) }),
    series: [
      ...curves.lines.map((line) => thinLine(line, colours)),
      scattered(curves.points, colours),
      rangeBars(curves.means, colours),
      meanLine(curves.means, colours),
      ...referenceLine(study, key, figure, colours),
    ],
  };
}

/** The same scale in every panel, so that they can be compared. */
function margins([low, high]) {
  const margin = 0.04 * (high - low || Math.abs(high) || 1);
  return {
    min: low - margin > 0 || low < 0 ? low - margin : 0, max: high + margin,
    axisLabel: { showMinLabel: low - margin <= 0 && low >= 0, showMaxLabel: false },
  };
}

const thinLine = (data, colours) => ({
  type: 'line', data, symbol: 'none', silent: true, tooltip: { show: false },
  lineStyle: { color: colours.bar, width: 1, opacity: 0.55 },
});

const scattered = (points, colours) => ({
  type: 'scatter', data: points.map(([at, value]) => [at, value]), symbolSize: 4, silent: true,
  itemStyle: { color: colours.bar, opacity: points.length > 1000 ? 0.25 : 0.6 },
});

const meanLine = (means, colours) => ({
  type: 'line', name: 'mean', data: means.map(({ at, mean }) => [at, mean]), symbolSize: 6, symbol: 'circle',
  z: 4, lineStyle: { color: colours.link, width: 2.5 }, itemStyle: { color: colours.link },
});

function rangeBars(means, colours) {
  return {
    type: 'custom', name: 'range', silent: true, z: 3, encode: { x: 0, y: [1, 2] },
    data: means.map(({ at, least, most }) => [at, least, most]),
    renderItem(params, api) {
      const [x, low] = api.coord([api.value(0), api.value(1)]);
      const [, high] = api.coord([api.value(0), api.value(2)]);
      const stroke = { stroke: colours.link, lineWidth: 1.5, opacity: 0.7 };
      const line = (x1, y1, x2, y2) => ({ type: 'line', shape: { x1, y1, x2, y2 }, style: stroke });
      return {
        type: 'group',
        children: [line(x, low, x, high), line(x - 5, low, x + 5, low), line(x - 5, high, x + 5, high)],
      };
    },
  };
}

/** All other keys as in the reference case; its fitted effect where no two cases differ in it alone. */
function referenceLine(study, key, figure, colours) {
  const response = study.responses.find((r) => r.key === key && study.figures[r.figure] === figure);
  if (!response || response.rows.length + response.fit.length < 2) return [];
  const points = response.rows.map((row) => [study.keys[key].value(row), figure.value(row)]);
  const fit = response.fit.map(([setting, value]) => [setting, value * figure.perUnit]);
  return [{
    type: 'line', name: 'reference', symbolSize: 8, z: 5,
    symbol: points.length > 0 && points.length <= MOST_SYMBOLS ? 'diamond' : 'none',
    data: points.length > 0 ? points : fit,
    lineStyle: { color: colours.ink, width: 1.5, type: 'dashed' }, itemStyle: { color: colours.ink },
  }];
}

function tooltip(params, key, figure, { means }) {
  const at = params[0]?.axisValue;
  const near = means.reduce((best, mean) =>
    (!best || Math.abs(mean.at - at) < Math.abs(best.at - at) ? mean : best), null);
  if (!near) return '';
  return tooltipLines([
    `${key.title} ${key.mark(near.at)}: ${near.count} case${near.count === 1 ? '' : 's'}`,
    `mean ${figure.mark(near.mean)}, from ${figure.mark(near.least)} to ${figure.mark(near.most)}`,
    figure.title,
  ]);
}
