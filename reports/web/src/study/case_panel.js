import { make } from '../base/dom.js';
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
  const none = make('p', {
    class: 'note', text: 'Choose a case: a mark of the chart, or its number in the table.',
  });
  const draw = () => {
    // Whoever looks at all figures of one case looks at those of the next.
    const open = panel.querySelector('details')?.open ?? false;
    const row = board.chosen();
    panel.replaceChildren(...(row === null ? [none] : contents(board.study, row, open)));
  };
  board.onChoice(draw);
  draw();
  return panel;
}

function contents(study, row, open) {
  const line = (name, value) => make('div', {}, [make('dt', { text: name }), make('dd', { text: value })]);
  const list = (figures) => make('dl', { class: 'study-list' },
    figures.filter((figure) => figure.value(row) !== null)
      .map((figure) => line(figure.name, figure.text(row))));
  const first = study.objectives.map((i) => study.figures[i]);
  const others = study.figures.filter((figure) => !first.includes(figure));
  return [
    make('p', { class: 'study-case-head' }, [
      make('strong', { text: `Case ${study.numbers[row]}` }), ' ', badge(study.statuses[row]),
      ...marksOf(study, row).map((text) => make('small', { text: ` ${text}` })),
    ]),
    ...(study.reason(row) ? [make('p', { text: study.reason(row) })] : []),
    make('dl', { class: 'study-list' }, study.keys.map((key) => line(key.title, key.text(row)))),
    list(first),
    ...(others.length > 0
      ? [make('details', { open }, [make('summary', { text: 'All other figures' }), list(others)])] : []),
    make('p', {}, resultLink(study, row)),
  ];
}
