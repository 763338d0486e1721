import './library.js';

import { createLiveChart, whenSeen } from '../charts/live_chart.js';
import { make, onceAFrame } from '../base/dom.js';
import { nearestRun } from './data.js';
import { chartHeight, historyOption, zoomedAxes } from './option.js';
import { createRunPanel } from './run_panel.js';

/**
 * Puts a job's charts with their controls into `place`; they are drawn when they come into sight.
 * @param {HTMLElement} place
 * @param {object} job as decodeHistory gives it
 * @param {HTMLElement|null} table whose rows have `data-run`
 * @returns {{state(): object, pin(id: number|null): void}} for tests
 */
export function createHistoryChart(place, job, table) {
  const state = { byTime: false, zoom: [0, 100], pinned: null, drawn: false };
  const plot = make('div', { class: 'chart-plot', data: { testid: 'history-plot' } });
  plot.style.height = `${chartHeight(job)}px`;
  let live = null;
  const panel = createRunPanel(job, pin);

  function pin(run) {
    state.pinned = run;
    panel.show(run);
    markRow(table, run);
    live?.redraw();
  }
  function zoomTo(zoom) {
    state.zoom = zoom;
    live?.redraw();
  }
  const controls = createControls(job, state, {
    pin, zoomTo,
    setTime(byTime) {
      state.byTime = byTime;
      zoomTo([0, 100]);
    },
  });
  place.append(make('figure', { 'data-live': true }, [caption(), controls, plot, panel.element]));
  whenSeen(plot, () => {
    live = drawn(plot, job, state, pin);
    state.drawn = true;
  });
  return {
    state: () => ({ ...state, pinned: state.pinned?.id ?? null }),
    pin: (id) => pin(job.runs.find((run) => run.id === id) ?? null),
  };
}

const caption = () => make('figcaption', {
  text: 'One panel a figure, oldest run left. Shaded: the certified interval. Dashed: the limit. Marks: '
    + 'circle within its limit, cross beyond it, triangle undecided, square without a limit. The slider, or Ctrl and the wheel, chooses runs.',
});

function drawn(plot, job, state, pin) {
  const live = createLiveChart(plot, (colours, width_px) => {
    const pass = getComputedStyle(plot).getPropertyValue('--pass').trim();
    return historyOption(job, state, { ...colours, pass }, width_px);
  });
  const fit = onceAFrame(() => live.chart.setOption(zoomedAxes(job, state)));
  live.chart.on('datazoom', () => {
    const { start, end } = live.chart.getOption().dataZoom[0];
    state.zoom = [start, end];
    fit();
  });
  live.chart.getZr().on('click', ({ offsetX, offsetY }) => {
    const inside = job.series.some((_, gridIndex) => live.chart.containPixel({ gridIndex }, [offsetX, offsetY]));
    if (!inside) return;
    const at = live.chart.convertFromPixel({ xAxisIndex: 0 }, offsetX);
    const run = nearestRun(job.runs, at, state.byTime);
    pin(state.pinned === run ? null : run);
  });
  return live;
}

/** Everything that the pointer does on the charts, for the keyboard. */
function createControls(job, state, { pin, zoomTo, setTime }) {
  const button = (text, click) => make('button', { type: 'button', text, on: { click } });
  const step = (by) => {
    const last = job.runs.length - 1, from = state.pinned?.index ?? (by < 0 ? last + 1 : -1);
    pin(job.runs[Math.min(last, Math.max(0, from + by))]);
  };
  const newest = (count) => zoomTo([Math.max(0, 100 - (100 * (count - 1)) / (job.runs.length - 1)), 100]);
  const time = make('input', { type: 'checkbox', data: { testid: 'history-time' } });
  time.addEventListener('change', () => setTime(time.checked));
  const windows = [10, 50].filter((count) => job.runs.length > count)
    .map((count) => button(`Newest ${count}`, () => {
      if (state.byTime) time.click();
      newest(count);
    }));
  return make('div', { class: 'history-controls', role: 'group', 'aria-label': `Charts of ${job.job}` }, [
    button('Earlier run', () => step(-1)), button('Later run', () => step(1)),
    ...(windows.length > 0 ? [button('All runs', () => zoomTo([0, 100])), ...windows] : []),
    make('label', { class: 'chart-switch' }, [time, 'over time']),
  ]);
}

function markRow(table, run) {
  if (!table) return;
  for (const row of table.querySelectorAll('tr.pinned')) row.classList.remove('pinned');
  if (run) table.querySelector(`tr[data-run="${run.id}"]`)?.classList.add('pinned');
}
