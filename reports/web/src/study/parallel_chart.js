import { make, onceAFrame } from '../base/dom.js';
import { extentOf } from './axes.js';
import { createChart } from './library.js';
import { axisPlace, parallelHeight, parallelOption, parallelQuantities } from './parallel_option.js';

/**
 * Parallel coordinates in `plot`: what is marked on an axis filters the board.
 * @param board as createBoard gives it
 * @returns {{placeOf: (id: string) => {x, y, narrow}}} where an axis stands in `plot`, px
 */
export function createParallelChart(board, plot) {
  const { study } = board;
  plot.replaceChildren();
  const { chart, redraw } = createChart(plot, (colours, width_px) => {
    const height = parallelHeight(study, width_px);
    if (plot.clientHeight !== height) {
      plot.style.height = `${height}px`;
      // Before the first option there is nothing that could be drawn anew.
      if (plot.dataset.drawn) queueMicrotask(() => chart.resize());
    }
    plot.dataset.drawn = '';
    return parallelOption(board, colours, width_px);
  }, true);
  chart.resize();
  let restoring = false;
  chart.on('axisareaselected', ({ parallelAxisId, intervals }) => {
    if (!restoring) board.setRanges(parallelAxisId, intervals, chart);
  });
  chart.on('click', ({ data }) => data?.row !== undefined && board.choose(data.row));
  /** The axes marked as the board has it. */
  const restore = () => {
    restoring = true;
    for (const { id } of parallelQuantities(study))
      chart.dispatchAction({
        type: 'axisAreaSelect', parallelAxisId: id,
        intervals: finite(study, id, board.ranges().get(id) ?? []),
      });
    restoring = false;
  };
  board.onFilter((from) => {
    if (from === chart) return;
    redraw();
    restore();
  });
  board.onChoice(onceAFrame(redraw));
  if (board.isFiltered()) restore();
  return { placeOf: (id) => axisPlace(study, id, plot.clientWidth) };
}

/** A range that is open at an end reaches to the end of its axis. */
function finite(study, id, intervals) {
  const quantity = study.quantities.find((q) => q.id === id);
  if (intervals.length === 0) return [];
  const [least, most] = extentOf(quantity, study.count);
  return intervals.map(([low, high]) => [Math.max(low, least), Math.min(high, most)]);
}

/** The chart with what it is. */
export function parallelFigure() {
  const plot = make('div', { class: 'chart-plot study-parallel', data: { testid: 'study-parallel' } });
  const figure = make('figure', {}, [make('figcaption', {
    text: 'A line is a case, an axis a key or a figure. Drag along an axis to keep the cases that run '
      + 'through there, click beside the mark to lift it. The thick line is the recommended case, the dotted '
      + 'one the job’s own.',
  }), plot]);
  return { figure, plot };
}
