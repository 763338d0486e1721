import { make } from '../base/dom.js';
import { sortedRows, tableColumns } from './columns.js';
import { hasResult, marksOf, resultPath } from './data.js';
import { LOOKS } from './looks.js';

/** How many cases are listed at first: on a narrow page each is a block of lines. */
const aPage = () => (matchMedia('(max-width: 46rem)').matches ? 10 : 50);

/**
 * The table of the cases that the filter leaves, a page at a time, by any column.
 * @param board as createBoard gives it
 * @returns {HTMLElement}
 */
export function createCaseTable(board) {
  const { study } = board, columns = tableColumns(study);
  const state = { column: columns[1], descending: false, most: aPage(), rows: [] };
  const body = make('tbody', { role: 'rowgroup' });
  const said = make('p', { class: 'note', 'aria-live': 'polite', data: { testid: 'study-shown' } });
  const more = make('button', {
    type: 'button', text: 'Show more', data: { testid: 'study-more' },
    on: { click: () => { state.most += 4 * aPage(); draw(); } },
  });
  const sortBy = (column) => {
    state.descending = state.column === column && !state.descending;
    state.column = column;
    sort();
  };
  const heads = columns.map((column) => headOf(column, () => sortBy(column)));
  const order = sortChoice(columns, state, sortBy);
  const draw = () => {
    const shown = state.rows.slice(0, state.most);
    body.replaceChildren(...shown.map((row) => lineOf(board, columns, row)));
    more.hidden = shown.length === state.rows.length;
    said.textContent = `${state.rows.length} of ${study.count} cases` +
      (more.hidden ? '.' : `; the first ${shown.length} are listed.`);
  };
  const sort = () => {
    heads.forEach((head, i) => setSorted(head, columns[i] === state.column, state.descending));
    order.draw();
    state.rows = sortedRows(board.rows(), state.column.order, state.descending);
    draw();
  };
  board.onFilter(() => {
    state.most = aPage();
    sort();
  });
  board.onChoice(() => body.querySelectorAll('tr').forEach((line) =>
    line.toggleAttribute('data-chosen', Number(line.dataset.row) === board.chosen())));
  sort();
  return make('div', { class: 'study-table', data: { testid: 'study-table' } }, [said, order.element,
    make('div', { class: 'scroll' }, [make('table', { role: 'table' }, [
      make('caption', { text: 'Settings and figures; a click on a head sorts' }),
      make('thead', { role: 'rowgroup' }, [make('tr', { role: 'row' }, heads)]), body,
    ])]), more]);
}

/** For a narrow page, whose table has no heads. */
function sortChoice(columns, state, sortBy) {
  const select = make('select', { on: { change: () => sortBy(columns[Number(select.value)]) } },
    columns.map(({ title }, i) => make('option', { value: String(i), text: title })));
  const turn = make('button', { type: 'button', on: { click: () => sortBy(state.column) } });
  const element = make('div', { class: 'study-row study-order' }, [
    make('label', { class: 'study-choice' }, ['Sorted by ', select]), turn,
  ]);
  const draw = () => {
    select.value = String(columns.indexOf(state.column));
    turn.textContent = state.descending ? 'falling' : 'rising';
  };
  return { element, draw };
}

function headOf(column, sortBy) {
  return make('th', { scope: 'col', role: 'columnheader', class: column.isNumber ? 'num' : undefined }, [
    make('button', { type: 'button', class: 'study-sort', text: column.title, on: { click: sortBy } }),
  ]);
}

function setSorted(head, isSorted, descending) {
  if (isSorted) head.setAttribute('aria-sort', descending ? 'descending' : 'ascending');
  else head.removeAttribute('aria-sort');
}

function lineOf(board, columns, row) {
  const { study } = board, chosen = row === board.chosen();
  const cells = columns.map((column) => make('td', {
    role: 'cell', class: column.isNumber ? 'num' : 'word', 'data-label': column.title,
  }, [make('div', {}, contentOf(board, column, row))]));
  return make('tr', { role: 'row', data: { row, ...(chosen ? { chosen: '' } : {}) } }, cells);
}

function contentOf(board, column, row) {
  const { study } = board;
  if (column.id === 'case') return [make('button', {
    type: 'button', class: 'study-choose', text: String(study.numbers[row]),
    'aria-label': `Choose case ${study.numbers[row]}`, on: { click: () => board.choose(row) },
  })];
  if (column.id !== 'verdict') return [column.text(row)];
  return [badge(study.statuses[row]), ...marksOf(study, row).map((text) => make('small', { text }))];
}

/** As the page's own badges look. */
export function badge(status) {
  const { css, sign, word } = LOOKS[status];
  const mark = make('span', { 'aria-hidden': 'true', text: sign });
  return make('span', { class: `badge ${css}` }, [mark, ` ${word}`]);
}

/** The link to a case's result; nothing where it has none. */
export const resultLink = (study, row) => (hasResult(study, row)
  ? [make('a', { href: resultPath(study.numbers[row]), text: 'its result.json' })] : []);
