import { make } from '../view/dom.js';
import { badge, resultLink } from './case_table.js';
import { marksOf } from './data.js';

/**
 * What is known of the chosen case, said aloud when it changes.
 * @param board as createBoard gives it
 * @returns {HTMLElement}
 */
export function createCasePanel(board) {
  const panel = make('div', {
    class: 'study-case', role: 'status', 'aria-label': 'Chosen case', data: { testid: 'study-case' },
  });
  const draw = () => panel.replaceChildren(...(board.chosen() === null
    ? [make('p', { class: 'note', text: 'Choose a case: a mark of the chart, or its number in the table.' })]
    : contents(board.study, board.chosen())));
  board.onChoice(draw);
  draw();
  return panel;
}

function contents(study, row) {
  const line = (name, value) => make('div', {}, [make('dt', { text: name }), make('dd', { text: value })]);
  const figures = study.figures.filter((figure) => figure.value(row) !== null);
  return [
    make('p', { class: 'study-case-head' }, [
      make('strong', { text: `Case ${study.numbers[row]}` }), ' ', badge(study.statuses[row]),
      ...marksOf(study, row).map((text) => make('small', { text: ` ${text}` })),
    ]),
    ...(study.reason(row) ? [make('p', { text: study.reason(row) })] : []),
    make('dl', { class: 'study-list' }, study.keys.map((key) => line(key.title, key.text(row)))),
    make('dl', { class: 'study-list' }, figures.map((figure) => line(figure.name, figure.text(row)))),
    make('p', {}, resultLink(study, row)),
  ];
}
