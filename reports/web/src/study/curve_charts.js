import { whenSeen } from '../charts/following.js';
import { make, onceAFrame } from '../base/dom.js';
import { curveOption } from './curve_option.js';
import { createChart } from './library.js';
import { quantityChoice } from './scatter_chart.js';

/**
 * A figure against each key, side by side on one scale.
 * @param board as createBoard gives it
 */
export function curveFigure(board) {
  const { study } = board;
  const state = { figure: study.figures[study.objectives[1] ?? study.objectives[0] ?? 0] };
  const redraws = [];
  const panels = study.keys.map((_, key) => {
    const plot = make('div', { class: 'chart-plot study-curve', data: { testid: 'study-curve' } });
    whenSeen(plot, () => redraws.push(createChart(plot, (colours) =>
      curveOption(board, { key, figure: state.figure }, extentOf(board, state.figure), colours)).redraw));
    return plot;
  });
  const redraw = onceAFrame(() => redraws.forEach((draw) => draw()));
  board.onFilter(redraw);
  const choice = quantityChoice(study, 'Figure', state.figure, (figure) => {
    state.figure = figure;
    redraw();
  }, study.figures);
  return make('figure', {}, [make('figcaption', {
    text: 'How a figure answers to each key. Thick: mean and range of the cases shown; thin: cases that '
      + 'differ in this key alone; dashed: all other keys as in the reference case, or the effect of the key '
      + 'fitted through all cases.',
  }), make('div', { class: 'study-row' }, [choice]), make('div', { class: 'study-curves' }, panels)]);
}

/** Least and largest of the cases shown. */
function extentOf(board, figure) {
  const values = board.rows().map(figure.value).filter((value) => value !== null);
  if (values.length === 0) return null;
  return [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))];
}
