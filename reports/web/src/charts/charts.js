import './charts.css';

import { duration } from '../path/timeline.js';
import { clockText } from '../base/figure_text.js';
import { make } from '../base/dom.js';
import { findingTimes, histogramBars, processBins } from './bins.js';
import { histogramOption } from './histogram_option.js';
import { createLiveChart, whenSeen } from './live_chart.js';
import { processHeight, processOption } from './process_option.js';

const NARROW_PX = 640;

/**
 * Puts live charts into the page: each is built when it is about to come into sight.
 * @param {object} report as decodeReport gives it
 * @param {Document|Element} root where the page's figures are looked for
 */
export function startCharts(report, root) {
  for (const figure of root.querySelectorAll('figure.histogram[data-stage]')) {
    const stage = report.stages?.[Number(figure.dataset.stage)];
    if (stage?.histogram?.area_mm2.some((area) => area > 0))
      whenSeen(figure, () => liveHistogram(figure, stage));
  }
  for (const place of root.querySelectorAll('[data-chart="process"][data-stage]')) {
    const index = Number(place.dataset.stage), stage = report.stages?.[index];
    if (stage?.path) processChart(place, stage, index);
  }
}

/** Stands instead of the static picture, which is kept for print. */
function liveHistogram(figure, stage) {
  const drawn = { bars: histogramBars(stage.histogram, stage.limits), stage, logarithmic: false };
  const plot = make('div', { class: 'chart-plot chart-histogram', data: { testid: 'histogram-chart' } });
  const log = make('input', { type: 'checkbox', data: { testid: 'histogram-log' } });
  const controls = make('label', { class: 'chart-switch' }, [log, 'logarithmic area']);
  figure.append(make('div', { 'data-live': true }, [controls, plot]));
  const picture = figure.querySelector('.static');
  if (picture) picture.hidden = true;
  figure.classList.add('chart-drawn');
  const { redraw } = createLiveChart(plot, (colours, width_px) =>
    histogramOption(drawn, colours, width_px));
  log.addEventListener('change', () => {
    drawn.logarithmic = log.checked;
    redraw();
  });
}

/** Its figures are worked out when it is about to be seen, too: they may have to be unpacked. */
function processChart(place, stage, index) {
  const plot = make('div', { class: 'chart-plot chart-process', data: { testid: 'process-chart' } });
  const caption = make('figcaption');
  const log = make('input', { type: 'checkbox', data: { testid: 'process-log' } });
  const controls = make('label', { class: 'chart-switch' }, [log, 'logarithmic removal rate']);
  const figure = make('figure', {}, [caption, controls, plot]);
  place.append(figure);
  whenSeen(plot, () => {
    const drawn = processFigures(stage, plot.clientWidth);
    if (drawn.bins.feed.length === 0) {
      figure.remove();
      return;
    }
    caption.textContent = processWords(drawn);
    controls.hidden = !drawn.bins.rate;
    plot.style.height = `${processHeight(drawn.bins)}px`;
    const { chart, redraw } = createLiveChart(plot, (colours, width_px) =>
      processOption(drawn, colours, width_px));
    log.addEventListener('change', () => {
      drawn.logarithmic = log.checked;
      redraw();
    });
    chart.getZr().on('click', ({ offsetX }) => {
      const time_s = chart.convertFromPixel({ xAxisIndex: 0 }, offsetX);
      if (time_s >= 0 && time_s <= drawn.total_s)
        document.dispatchEvent(new CustomEvent('limitgauge:time', { detail: { stage: index, time_s } }));
    });
  });
}

function processFigures(stage, width_px) {
  return {
    stage, total_s: duration(stage.path),
    // No more steps than can be told apart.
    bins: processBins(stage.path, width_px < NARROW_PX ? 200 : undefined),
    findings: findingTimes(stage.path, stage.process ?? []),
  };
}

function processWords({ stage, bins, findings }) {
  const words = [bins.rate ? 'Removal rate and feed over machining time.' : 'Feed over machining time.',
    `Line: mean over steps of ${clockText(bins.width_s, 2)}; shaded: the largest in them.`];
  if (bins.rate) words.push('Rapids count in the mean removal rate, not in the feed.');
  else words.push('The report holds no removal rates of this stage.');
  if (stage.path.within_mm > 0 && bins.rate) words.push('Rates are means over what is drawn as one line.');
  if (findings.length > 0) words.push('Dashed lines mark process findings.');
  words.push('A click shows the tool at that time in the 3D view.');
  return words.join(' ');
}
