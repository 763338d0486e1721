import { make } from '../base/dom.js';
import { extentOf } from './axes.js';
import { LOOKS } from './looks.js';
import { parallelQuantities } from './parallel_option.js';

/**
 * The filter in words and numbers, for whoever cannot or would not draw on an axis.
 * @param board as createBoard gives it
 * @returns {HTMLElement}
 */
export function createFilterPanel(board) {
  const { study } = board;
  const count = make('strong', { data: { testid: 'study-count' } });
  const clear = make('button', {
    type: 'button', text: 'Show all', data: { testid: 'study-clear' }, on: { click: () => board.clear() },
  });
  const verdicts = LOOKS.map((look, status) => verdictBox(board, look, status)).filter(Boolean);
  const fields = parallelQuantities(study).map((quantity) => rangeFields(board, quantity)).filter(Boolean);
  const draw = () => {
    count.textContent = `${board.rows().length} of ${study.count} cases`;
    clear.hidden = !board.isFiltered();
    verdicts.forEach(({ box, status }) => (box.checked = board.shows(status)));
    fields.forEach(({ draw: drawField }) => drawField());
  };
  board.onFilter(draw);
  draw();
  return make('div', { class: 'study-filter' }, [
    make('div', { class: 'study-row' }, [count, ...verdicts.map(({ label }) => label), clear]),
    make('details', {}, [make('summary', { text: 'Filter by numbers' }),
      make('div', { class: 'study-ranges' }, fields.map(({ element }) => element))]),
  ]);
}

function verdictBox(board, { word, sign, css }, status) {
  const many = board.study.statuses.reduce((sum, s) => sum + (s === status), 0);
  if (many === 0) return null;
  const box = make('input', {
    type: 'checkbox', data: { testid: `study-status-${status}` },
    on: { change: () => board.setStatus(status, box.checked) },
  });
  const label = make('label', { class: 'study-check' }, [box,
    make('span', { class: `badge ${css}` }, [make('span', { 'aria-hidden': 'true', text: sign }),
      ` ${word} ${many}`])]);
  return { box, status, label };
}

/** From and to of a quantity; a choice of one where it has no numbers. */
function rangeFields(board, quantity) {
  const extent = extentOf(quantity, board.study.count);
  if (!extent) return null;
  return quantity.categories ? choiceField(board, quantity) : numberFields(board, quantity, extent);
}

function numberFields(board, quantity, [low, high]) {
  const field = (name, bound) => make('input', {
    type: 'number', step: 'any', 'aria-label': `${quantity.title} ${name}`,
    placeholder: String(quantity.kind === 'key' ? bound : Number(bound.toPrecision(4))),
  });
  const from = field('from', low), to = field('to', high);
  const apply = () => {
    const empty = from.value === '' && to.value === '';
    const at = (input, bound) => (input.value === '' ? bound : Number(input.value));
    board.setRanges(quantity.id, empty ? [] : [[at(from, -Infinity), at(to, Infinity)]]);
  };
  [from, to].forEach((input) => input.addEventListener('change', apply));
  const element = make('fieldset', {}, [make('legend', { text: quantity.title }), from, ' to ', to]);
  const draw = () => {
    const [range] = board.ranges().get(quantity.id) ?? [[-Infinity, Infinity]];
    const text = (value) => (Number.isFinite(value) ? String(Number(value.toPrecision(6))) : '');
    // What is being typed is not overwritten.
    if (document.activeElement !== from) from.value = text(range[0]);
    if (document.activeElement !== to) to.value = text(range[1]);
  };
  return { element, draw };
}

function choiceField(board, quantity) {
  const select = make('select', {
    'aria-label': quantity.title, on: {
      change: () => {
        const place = Number(select.value);
        board.setRanges(quantity.id, select.value === '' ? [] : [[place, place]]);
      },
    },
  }, [make('option', { value: '', text: 'all' }),
    ...quantity.categories.map((text, i) => make('option', { value: String(i), text }))]);
  const draw = () => {
    const ranges = board.ranges().get(quantity.id);
    select.value = ranges?.length === 1 && ranges[0][0] === ranges[0][1] ? String(ranges[0][0]) : '';
  };
  return { element: make('fieldset', {}, [make('legend', { text: quantity.title }), select]), draw };
}
