import { axisOption, commonOption, tooltipLines } from '../charts/theme.js';
import { quantityAxis } from './axes.js';
import { caseLines, isDecided, toBeSmall } from './data.js';
import { paretoFront } from './front.js';
import { LOOKS } from './looks.js';

const FEW = 300;

/**
 * What ECharts draws of two quantities: a mark a case, verdict by shape and colour, what the filter leaves
 * out faintly; the front where both are figures of one.
 * @param board as createBoard gives it
 * @param {{x: object, y: object}} axes quantities
 */
export function scatterOption(board, { x, y }, colours, width_px) {
  const { study } = board, common = commonOption(colours, `${y.title} against ${x.title}`);
  return {
    ...common,
    tooltip: {
      ...common.tooltip, trigger: 'item',
      formatter: ({ data }) => (data.row === undefined ? '' : tooltipLines(caseLines(study, data.row))),
    },
    grid: { left: 12, right: 22, top: 40, bottom: 42, containLabel: true },
    xAxis: axisFor(x, colours, {
      name: x.title, nameLocation: 'middle', nameGap: 30, splitLine: { show: false },
      splitNumber: width_px < 500 ? 4 : 8,
    }),
    yAxis: axisFor(y, colours, {
      name: y.title, nameLocation: 'end', nameGap: 14,
      nameTextStyle: { color: colours.soft, fontSize: 13, align: 'left', padding: [0, 0, 0, -40] },
    }),
    series: [
      ...pointSeries(board, x, y, colours),
      ...frontSeries(study, x, y, colours),
      ...markSeries(board, x, y, colours),
    ],
  };
}

function axisFor(quantity, colours, more) {
  const own = quantityAxis(quantity), base = axisOption(colours, more);
  return {
    ...base, ...own, axisTick: { ...base.axisTick, ...own.axisTick },
    axisLabel: { ...base.axisLabel, ...own.axisLabel },
  };
}

const point = (x, y, row) => ({ value: [x.value(row), y.value(row)], row });
const stands = (x, y, row) => x.value(row) !== null && y.value(row) !== null;

function pointSeries(board, x, y, colours) {
  const { study } = board, kept = new Uint8Array(study.count);
  board.rows().forEach((row) => (kept[row] = 1));
  const data = LOOKS.map(() => ({ kept: [], left: [] }));
  for (let row = 0; row < study.count; ++row)
    if (stands(x, y, row)) data[study.statuses[row]][kept[row] ? 'kept' : 'left'].push(point(x, y, row));
  const size = study.count > FEW ? 5 : 10;
  const series = (look, points, more) => ({
    type: 'scatter', name: look.word, symbol: look.symbol, symbolSize: size, data: points,
    itemStyle: { color: colours[look.colour], opacity: study.count > FEW ? 0.6 : 0.85 }, ...more,
  });
  return [
    ...LOOKS.map((look, i) => series(look, data[i].left, {
      silent: true, itemStyle: { color: colours.none, opacity: 0.12 },
    })),
    ...LOOKS.map((look, i) => series(look, data[i].kept, { emphasis: { scale: 1.6 } })),
  ];
}

/** Both are figures of a front: of each one way is better. */
export function hasFront(study, x, y) {
  const small = new Set(study.fronts.flatMap(({ figures }) => figures));
  return x !== y && [x, y].every(({ kind, index }) => kind === 'figure' && small.has(index));
}

/** A stair: between two of its cases nothing better than the cheaper one was found. */
function frontSeries(study, x, y, colours) {
  if (!hasFront(study, x, y)) return [];
  const rows = Array.from({ length: study.count }, (_, row) => row).filter((row) => isDecided(study, row));
  return [{
    type: 'line', name: 'front', step: 'end', symbol: 'none', silent: true, z: 3,
    lineStyle: { color: colours.ink, width: 1.5 },
    data: paretoFront(rows, toBeSmall(x), toBeSmall(y)).map((row) => [x.value(row), y.value(row)]),
  }];
}

function markSeries(board, x, y, colours) {
  const { study } = board;
  const both = study.own !== null && study.own === study.recommended;
  const chosen = board.chosen() === study.recommended ? null : board.chosen();
  const mark = (name, row, style, text, position) => (row === null || !stands(x, y, row) ? [] : [{
    type: 'scatter', name, z: 6, silent: true, symbol: style.symbol, symbolSize: style.size,
    data: [point(x, y, row)],
    itemStyle: { color: 'transparent', borderColor: style.colour, borderWidth: 2.5 },
    label: {
      show: Boolean(text), formatter: () => text, position, color: colours.ink, fontSize: 13, fontWeight: 600,
      distance: 8, textBorderColor: colours.page, textBorderWidth: 3,
    },
  }]);
  return [
    ...mark('recommended', study.recommended, { symbol: 'circle', size: 20, colour: colours.link },
      both ? 'recommended: the job’s own' : 'recommended', 'top'),
    ...mark('own', both ? null : study.own, { symbol: 'diamond', size: 24, colour: colours.ink },
      'the job’s own', 'top'),
    ...mark('chosen', chosen, { symbol: 'rect', size: 24, colour: colours.ink }, '', 'top'),
  ];
}
