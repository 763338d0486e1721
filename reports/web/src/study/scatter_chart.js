import { make, onceAFrame } from '../base/dom.js';
import { createChart } from './library.js';
import { hasFront, scatterOption } from './scatter_option.js';

/**
 * One quantity against another, with the front; the reader chooses which.
 * @param board as createBoard gives it
 */
export function scatterFigure(board) {
  const { study } = board, [cost, bought] = study.objectives.map((i) => study.figures[i]);
  const axes = { x: cost ?? study.quantities[0], y: bought ?? cost ?? study.quantities[0] };
  const plot = make('div', { class: 'chart-plot study-scatter', data: { testid: 'study-scatter' } });
  const caption = make('figcaption');
  let chart;
  const draw = () => {
    caption.textContent = 'A mark is a case: circle passed, cross failed, triangle undecided. '
      + (hasFront(study, axes.x, axes.y)
        ? `The stair is the Pareto front: ${betterSide(axes)} nothing was found. ` : '')
      + 'The ring is the recommended case, the diamond the job’s own.';
    chart?.redraw();
  };
  const choice = (name, axis) => quantityChoice(study, name, axes[axis], (quantity) => {
    axes[axis] = quantity;
    draw();
  });
  const figure = make('figure', {}, [
    caption, make('div', { class: 'study-row' }, [choice('Up', 'y'), choice('Across', 'x')]),
    make('div', {
      tabindex: '0', role: 'group', class: 'study-steps', 'aria-label': 'Arrow keys step through the cases',
      on: { keydown: (event) => stepBy(event, board, axes) },
    }, [plot]),
  ]);
  const build = () => {
    chart = createChart(plot, (colours, width_px) => scatterOption(board, axes, colours, width_px));
    chart.chart.on('click', ({ data }) => data?.row !== undefined && board.choose(data.row));
    board.onFilter(onceAFrame(draw));
    board.onChoice(onceAFrame(draw));
  };
  draw();
  return { figure, plot, build };
}

/** Where of a front its figures would be better. */
const betterSide = ({ x, y }) =>
  `${x.largerIsBetter ? 'right' : 'left'} of it and ${y.largerIsBetter ? 'above' : 'below'}`;

/** A choice among keys and figures. */
export function quantityChoice(study, name, chosen, use, list = study.quantities.slice(0, -1)) {
  const select = make('select', {
    data: { testid: `study-choice-${name.toLowerCase()}` },
    on: { change: () => use(list[Number(select.value)]) },
  }, list.map((quantity, i) => make('option', {
    value: String(i), text: quantity.title, selected: quantity === chosen,
  })));
  return make('label', { class: 'study-choice' }, [`${name} `, select]);
}

const STEPS = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };

/** From case to case in the order of the axis across. */
function stepBy(event, board, { x, y }) {
  const step = STEPS[event.key];
  if (!step) return;
  event.preventDefault();
  const rows = board.rows().filter((row) => x.value(row) !== null && y.value(row) !== null)
    .sort((a, b) => x.value(a) - x.value(b) || y.value(a) - y.value(b) || a - b);
  if (rows.length === 0) return;
  const at = rows.indexOf(board.chosen());
  board.choose(rows[at < 0 ? (step > 0 ? 0 : rows.length - 1)
    : Math.min(rows.length - 1, Math.max(0, at + step))]);
}
