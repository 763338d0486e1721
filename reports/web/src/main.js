import './page.css';
import { startCharts } from './charts/charts.js';
import { decodeReport } from './data/decode.js';
import { startView } from './view/view.js';

/** What the script adds to a page that says everything of weight without it. */
async function start() {
  const report = await decodeReport(document);
  const element = document.querySelector('[data-view]');
  const view = element && (await startView(report, element));
  // After the picture that the reader came for.
  startCharts(report, document);
  return view;
}

function complain(error) {
  const element = document.querySelector('[data-view]');
  if (element) element.textContent = `The 3D view cannot be shown: ${error.message}`;
  console.error(error);
}

/**
 * For the page's own tests: `ready` resolves to `view` after its first frame; `view` is null where nothing
 * can be drawn. What it offers is described in ../README.md.
 */
window.limitgauge = { ready: start(), view: null };
window.limitgauge.ready.then((view) => { window.limitgauge.view = view; }, complain);
