import './page.css';
import { startCharts } from './charts/charts.js';
import { decodeReport } from './data/decode.js';
import { startView } from './view/view.js';

/** What the script adds to a page that says everything of weight without it. */
async function start() {
  const report = await decodeReport(document);
  startCharts(report, document);
  await startView(report, document.querySelector('[data-view]'));
}

start().catch((error) => {
  const view = document.querySelector('[data-view]');
  if (view) view.textContent = `The 3D view cannot be shown: ${error.message}`;
  console.error(error);
});
