import { LOOKS } from './looks.js';
import { shownFigure } from './quantity_text.js';

/**
 * What can stand on an axis: a varied key or a figure.
 * @typedef {object} Quantity
 * @property {string} id unique among keys and figures
 * @property {string} title with the unit that `value` is in
 * @property {string[]|null} categories the settings of a key that are no numbers
 * @property {number[]} [settings] those of a key that are
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
    quantities: [...keys, ...figures, verdictQuantity(data.status)],
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
    settings: numeric ? settings.map(([, number]) => number).sort((a, b) => a - b) : null,
    value: (row) => (numeric ? settings[of[row]][1] : of[row]),
    text: (row) => settings[of[row]][0],
    mark: (value) => (numeric ? String(Number(value.toPrecision(6))).replace('-', '−')
      : settings[Math.round(value)]?.[0] ?? ''),
  };
}

function verdictQuantity(statuses) {
  const text = ({ sign, word }) => `${sign} ${word}`;
  return {
    kind: 'verdict', id: 'verdict', title: 'verdict', numeric: false, categories: LOOKS.map(text),
    value: (row) => statuses[row], text: (row) => text(LOOKS[statuses[row]]),
    mark: (value) => text(LOOKS[value]),
  };
}

function figureQuantity(figure, index) {
  const shown = shownFigure(figure);
  return {
    kind: 'figure', index, id: `figure ${figure.id}`, title: shown.title, name: figure.label, numeric: true,
    categories: null, perUnit: shown.perUnit,
    largerIsBetter: figure.better === 'higher',
    value: (row) => (figure.values[row] === null ? null : figure.values[row] * shown.perUnit),
    text: (row) => shown.text(figure.values[row]),
    cell: (row) => shown.cell(figure.values[row]),
    mark: (value) => shown.mark(value),
  };
}

/** What is to be small of a figure: here what is to be large changes its sign, and nowhere else. */
export const toBeSmall = (figure) => (row) => {
  const value = figure.value(row);
  return value === null || !figure.largerIsBetter ? value : -value;
};

const LAST_WITH_RESULT = 2, LAST_DECIDED = 1;

/** Whether the case came to a verdict: only then it has a result. */
export const hasResult = (study, row) => study.statuses[row] <= LAST_WITH_RESULT;

/** Whether the case passed or failed: such cases make up fronts. */
export const isDecided = (study, row) => study.statuses[row] <= LAST_DECIDED;

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
  const beside = marks.length > 0 ? ` (${marks.join(', ')})` : '';
  return [
    `case ${study.numbers[row]}: ${LOOKS[study.statuses[row]].word}${beside}`,
    ...study.keys.map((key) => `${key.title} = ${key.text(row)}`),
    ...study.objectives.map((i) => study.figures[i]).filter((figure) => figure.value(row) !== null)
      .map((figure) => `${figure.name}: ${figure.text(row)}`),
    ...(study.reason(row) ? [study.reason(row)] : []),
  ];
}
