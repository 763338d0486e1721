// axe-core finds nothing on any page, wide in light and narrow in dark with all that is folded unfolded, and finds
// what is wrong.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { findsNothing, violations } from './support/axe.mjs';
import { openBrowser, seeFigures, withReport } from './support/browser.mjs';

const browser = await openBrowser();

// Pages that have what no other has. LIMITGAUGE_THOROUGH: all.
const all = Boolean(process.env.LIMITGAUGE_THOROUGH);
/** The pages of one kind: those named first, and behind them those that are looked at when all are. */
const pages = (folder, file, names, others) =>
  [...names, ...(all ? others : [])].map((name) => [`${folder}${name}`, file]);
const reports = pages('', 'report.html', ['passed', 'undecided', 'gouging', 'cut', 'mesh', 'tolerated', 'hostile'],
  ['failed', 'dome']);
const studies = pages('studies/', 'study.html', ['sixty', 'single'], ['failed', 'hostile']);
const histories = pages('histories/', 'report.html', ['two-jobs'], ['one', 'forty', 'hostile']);

/** Unfolds all and shows what is shown on demand; charts are drawn when they come into sight. */
async function unfold(page) {
  await page.evaluate(() => {
    for (const details of document.querySelectorAll('details')) details.open = true;
    const path = document.querySelector('[data-testid="view-path"]');
    if (path && !path.checked) path.click();
  });
  await seeFigures(page);
}

for (const [name, file] of [...reports, ['compared', 'compare.html'], ...studies, ...histories])
  test(`${name}: axe finds nothing`, () =>
    withReport(browser, name, { file, reducedMotion: 'reduce', bypassCSP: true },
      (page) => findsNothing(page, unfold)));

/** Of the visible cells of tables, the last of a row that looks as the row before it. */
function fadeOne() {
  const seen = (cell) => cell.checkVisibility() && cell.textContent.trim();
  const rows = [...document.querySelectorAll('tbody tr')].filter((row) => [...row.cells].some(seen));
  const like = rows.filter((row) => row.previousElementSibling?.className === row.className);
  const cell = [...like.at(-1).cells].filter(seen).at(-1);
  cell.style.color = '#888';
  cell.style.backgroundColor = '#999';
}

test('words of too little contrast are found, in a row like those before it too', () =>
  withReport(browser, 'passed', { bypassCSP: true, reducedMotion: 'reduce' }, async (page) => {
    await unfold(page);
    await page.evaluate(fadeOne);
    const found = await violations(page);
    assert.equal(found.length, 1, found.join('\n'));
    assert.match(found[0], /^color-contrast: .*#888888, background color: #999999/s);
  }));
