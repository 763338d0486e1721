import './study.css';
import { whenSeen } from '../charts/following.js';
import { make } from '../base/dom.js';
import { createBoard } from './board.js';
import { createCasePanel } from './case_panel.js';
import { createCaseTable } from './case_table.js';
import { curveFigure } from './curve_charts.js';
import { decodeStudy } from './data.js';
import { createFilterPanel } from './filter_panel.js';
import { createParallelChart, parallelFigure } from './parallel_chart.js';
import { scatterFigure } from './scatter_chart.js';

/** What the script adds to a page that says everything of weight without it. */
function start() {
  const study = decodeStudy(JSON.parse(document.getElementById('limitgauge-data').textContent));
  const place = document.querySelector('[data-study]'), cases = document.querySelector('[data-cases]');
  if (study.count === 0) return null;
  const board = createBoard(study), parallel = parallelFigure(), scatter = scatterFigure(board);
  const view = { board, axisPlace: null };
  board.choose(study.recommended);
  place.append(make('div', { 'data-live': true }, [
    createFilterPanel(board), parallel.figure,
    make('div', { class: 'study-pair' }, [scatter.figure, createCasePanel(board)]), curveFigure(board),
  ]));
  whenSeen(parallel.plot, () => (view.axisPlace = createParallelChart(board, parallel.plot).placeOf));
  whenSeen(scatter.plot, scatter.build);
  // The static table stays for print.
  cases.querySelector('.static').hidden = true;
  cases.append(make('div', { 'data-live': true }, [createCaseTable(board)]));
  return view;
}

/**
 * For the page's own tests: `ready` resolves to `view`, null where there is no case. `view.board` is what the
 * reader has chosen (board.js); `view.axisPlace(id)` where an axis of the first chart stands in its plot.
 */
window.limitgauge = { ready: Promise.resolve().then(start) };
window.limitgauge.ready.catch((error) => {
  const place = document.querySelector('[data-study]');
  if (place) place.textContent = `The charts cannot be shown: ${error.message}`;
  console.error(error);
});
