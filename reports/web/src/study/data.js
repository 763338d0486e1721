import { shownFigure } from './shown.js';

/** What a case may have come to, in the order in which the page's data count. */
export const STATUSES = ['pass', 'fail', 'indeterminate', 'error', 'lost'];

/**
 * What can stand on an axis: a varied key or a figure.
 * @typedef {object} Quantity
 * @property {string} id unique among keys and figures
 * @property {string} title with the unit that `value` is in
 * @property {string[]|null} categories the settings of a key that are no numbers
 * @property {(row: number) => number|null} value a place among the categories, or a number
 * @property {(row: number) => string} text as people read it, with its unit
 * @property {(value: number) => string} mark for an axis
 */

/**
 * The page's data (reports/study/page_data.cpp) as the charts ask for them.
 * @param {object} data parsed JSON, format limitgauge.study-page/1
 */
export function decodeStudy(data) {
  if (data.format !== 'limitgauge.study-page/1') throw new Error(`format ${data.format} is not known`);
  const keys = data.keys.map(keyQuantity), figures = data.figures.map(figureQuantity);
  return {
    count: data.cases.length, numbers: data.cases, statuses: data.status, keys, figures,
    quantities: [...keys, ...figures],
    objectives: data.objectives, fronts: data.fronts, responses: data.responses,
    recommended: data.recommended, own: data.own,
    reason: (row) => data.reasons.texts[data.reasons.of[row]],
  };
}

function keyQuantity({ key, settings, of }, index) {
  const numeric = settings.every(([, number]) => number !== null);
  return {
    kind: 'key', index, id: `key ${key}`, title: key, numeric,
    categories: numeric ? null : settings.map(([text]) => text),
    value: (row) => (numeric ? settings[of[row]][1] : of[row]),
    text: (row) => settings[of[row]][0],
    mark: (value) => (numeric ? String(Number(value.toPrecision(6))).replace('-', '−')
      : settings[Math.round(value)]?.[0] ?? ''),
  };
}

function figureQuantity(figure, index) {
  const shown = shownFigure(figure);
  return {
    kind: 'figure', index, id: `figure ${figure.id}`, title: shown.title, name: figure.label, numeric: true,
    categories: null, values: figure.values,
    value: (row) => (figure.values[row] === null ? null : figure.values[row] * shown.perUnit),
    text: (row) => shown.text(figure.values[row]),
    cell: (row) => shown.cell(figure.values[row]),
    mark: (value) => shown.mark(value),
  };
}

/** Whether the case came to a verdict: only then it has a result and figures that count. */
export const hasResult = (study, row) => study.statuses[row] <= 2;

/** Where a case's result lies beside the page; as reports/study/study_view.cpp says it. */
export function resultPath(number) {
  const padded = (n) => String(n).padStart(4, '0');
  return `cases/${padded(Math.floor(number / 100) * 100)}/${padded(number)}/result.json`;
}

/** Rows by what there is to say of them: [] or 'recommended', "the job's own". */
export function marksOf(study, row) {
  return [
    ...(row === study.recommended ? ['recommended'] : []),
    ...(row === study.own ? ['the job’s own'] : []),
  ];
}

/** The lines that say what a case is. */
export function caseLines(study, row) {
  const marks = marksOf(study, row);
  return [
    `case ${study.numbers[row]}: ${LOOKS[study.statuses[row]].word}${marks.length ? ` (${marks.join(', ')})` : ''}`,
    ...study.keys.map((key) => `${key.title} = ${key.text(row)}`),
    ...study.objectives.map((i) => study.figures[i]).filter((figure) => figure.value(row) !== null)
      .map((figure) => `${figure.name}: ${figure.text(row)}`),
    ...(study.reason(row) ? [study.reason(row)] : []),
  ];
}

/** How each status looks in words and charts: never by colour alone. */
export const LOOKS = [
  { word: 'passed', sign: '✓', css: 'pass', symbol: 'circle', dash: 'solid' },
  { word: 'failed', sign: '✕', css: 'fail', symbol: 'path://M0,2L2,0L5,3L8,0L10,2L7,5L10,8L8,10L5,7L2,10L0,8L3,5Z', dash: [6, 3] },
  { word: 'undecided', sign: '?', css: 'open', symbol: 'triangle', dash: [2, 3] },
  { word: 'error', sign: '!', css: 'none', symbol: 'rect', dash: [1, 4] },
  { word: 'lost', sign: '–', css: 'none', symbol: 'rect', dash: [1, 4] },
];
