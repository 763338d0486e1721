import '../charts/charts.css';
import './history.css';

import { createHistoryChart } from './chart.js';
import { decodeHistory } from './data.js';

/** What the script adds to a page that says everything of weight without it. */
async function start() {
  const history = decodeHistory(document);
  return history.jobs.map((job, index) => {
    const place = document.querySelector(`[data-chart="history"][data-job="${index}"]`);
    return createHistoryChart(place, job, document.querySelector(`[data-runs="${index}"]`));
  });
}

/** For the page's own tests: `ready` resolves to the charts, one a job. */
window.limitgauge = { ready: start() };
window.limitgauge.ready.catch((error) => console.error(error));
