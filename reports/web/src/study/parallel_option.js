import { commonOption, tooltipLines } from '../charts/theme.js';
import { extentOf, quantityAxis, titleParts } from './axes.js';
import { caseLines } from './data.js';
import { LOOKS } from './looks.js';

const FEW = 300, MOST_LIVE = 2000, LEAST_AXIS_WIDTH = 105, LEAST_AXIS_HEIGHT = 74;

/** What stands on the axes: the varied keys, the figures that the study is about, and the verdict. */
export const parallelQuantities = (study) => [
  ...study.keys, ...study.objectives.map((i) => study.figures[i]), study.quantities.at(-1),
];

/** Whether the axes lie: too many for the width. */
const isNarrow = (study, width_px) =>
  width_px / parallelQuantities(study).length < LEAST_AXIS_WIDTH;

/** How high the chart is, px. */
export const parallelHeight = (study, width_px) =>
  (isNarrow(study, width_px) ? parallelQuantities(study).length * LEAST_AXIS_HEIGHT : 400);

/**
 * What ECharts draws of a study as parallel coordinates: a line a case, an axis a quantity, the verdict
 * last. Axes have the ids of their quantities.
 * @param board as createBoard gives it
 */
export function parallelOption(board, colours, width_px) {
  const { study } = board, quantities = parallelQuantities(study), narrow = isNarrow(study, width_px);
  return {
    ...commonOption(colours, `Parallel coordinates of ${study.count} cases; the table holds the same`),
    tooltip: {
      ...commonOption(colours, '').tooltip, trigger: 'item',
      formatter: ({ data }) => tooltipLines(caseLines(study, data.row)),
    },
    parallel: placeOf(narrow),
    parallelAxis: quantities.map((quantity, dim) => ({
      ...baseAxis(colours, narrow, study.count), dim, id: quantity.id,
      name: titleParts(quantity, narrow ? ' ' : '\n'),
      ...axisOf(quantity, study, colours, narrow),
    })),
    series: [
      ...LOOKS.map((look, status) => statusLines(board, quantities, look, status, colours)),
      ...highlights(board, quantities, colours),
    ],
  };
}

const placeOf = (narrow) => (narrow
  ? { layout: 'vertical', left: 24, right: 24, top: 44, bottom: 30 }
  : { layout: 'horizontal', left: 48, right: 84, top: 56, bottom: 28 });

/** Where the middle of a quantity's axis stands in the chart, px. */
export function axisPlace(study, id, width_px) {
  const quantities = parallelQuantities(study), narrow = isNarrow(study, width_px);
  const { left, right, top, bottom } = placeOf(narrow), height = parallelHeight(study, width_px);
  const share = quantities.findIndex((quantity) => quantity.id === id) / (quantities.length - 1);
  return narrow ? { x: width_px / 2, y: top + share * (height - top - bottom), narrow }
    : { x: left + share * (width_px - left - right), y: (top + height - bottom) / 2, narrow };
}

function baseAxis(colours, narrow, count) {
  return {
    nameLocation: 'end', nameGap: narrow ? 10 : 14, realtime: count <= MOST_LIVE, inverse: false,
    nameTextStyle: {
      color: colours.ink, fontSize: 12, lineHeight: 15, align: narrow ? 'right' : 'center',
      verticalAlign: 'bottom', textBorderColor: colours.page, textBorderWidth: 3,
      ...(narrow ? { padding: [0, 0, 16, 0] } : {}),
    },
    axisLine: { lineStyle: { color: colours.ink, width: 1.2 } },
    areaSelectStyle: {
      width: 22, borderWidth: 1, borderColor: colours.link, color: colours.link, opacity: 0.2,
    },
  };
}

/** Its words stand on a ground of their own: lines run through them. */
const words = (colours, more) => ({
  color: colours.ink, fontSize: 12, textBorderColor: colours.page, textBorderWidth: 3, ...more,
});

const signsAlone = { interval: 0, formatter: (text) => text.split(' ')[0] };

function axisOf(quantity, study, colours, narrow) {
  const axis = quantityAxis(quantity), [low, high] = extentOf(quantity, study.count) ?? [0, 1];
  const ends = quantity.kind === 'key' && axis.type === 'value'
    ? { min: low < high ? low : low - 1, max: low < high ? high : high + 1 } : {};
  return {
    ...axis, ...ends, axisTick: { ...axis.axisTick, lineStyle: { color: colours.soft } },
    axisLabel: words(colours, {
      ...axis.axisLabel, hideOverlap: true,
      // Side by side there is room for the signs alone; the boxes above say their words.
      ...(narrow && quantity.kind === 'verdict' ? signsAlone : {}),
    }),
  };
}

const valuesOf = (quantities, row) => quantities.map((quantity) => quantity.value(row) ?? NaN);

function statusLines(board, quantities, look, status, colours) {
  const { study } = board, data = [];
  for (let row = 0; row < study.count; ++row)
    if (study.statuses[row] === status && board.shows(status))
      data.push({ value: valuesOf(quantities, row), row });
  return {
    type: 'parallel', name: look.word, id: look.word, data, smooth: false,
    inactiveOpacity: 0.04, activeOpacity: opacityFor(study.count),
    lineStyle: {
      color: colours[look.colour], width: study.count > FEW ? 1 : 1.4, opacity: opacityFor(study.count),
      // Thousands of dashed lines would take seconds to draw; the last axis tells them apart.
      type: study.count > FEW ? 'solid' : look.dash,
    },
    emphasis: { lineStyle: { width: 3, opacity: 1 } },
  };
}

/** Thousands of lines over each other show where most of them run. */
const opacityFor = (count) => Math.min(0.75, 200 / count + 0.01);

/** What must be found at a glance: the job's own case, the recommended and the chosen one. */
function highlights(board, quantities, colours) {
  const { study } = board, chosen = board.chosen() === study.recommended ? null : board.chosen();
  const line = (name, row, style) => ({
    type: 'parallel', name, id: name, z: 5, silent: true, inactiveOpacity: 1, activeOpacity: 1,
    data: row === null ? [] : [{ value: valuesOf(quantities, row), row }],
    lineStyle: { opacity: 1, ...style },
  });
  return [
    line('own', study.own, { color: colours.soft, width: 3.5, type: [2, 4] }),
    line('recommended', study.recommended, { color: colours.link, width: 4 }),
    line('chosen', chosen, { color: colours.ink, width: 2.5 }),
  ];
}
