import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { given } from './pages.mjs';

// Lies with the page's libraries, by the lock file: without it nothing was built.
const axe = readFileSync(join(given('LIMITGAUGE_NODE_MODULES'), 'axe-core', 'axe.min.js'), 'utf8');

/** What axe objects to, a sentence an element; the page must have been opened with bypassCSP. */
export async function violations(page) {
  await page.evaluate(axe);
  return page.evaluate(async () => {
    const found = await window.axe.run(document, { resultTypes: ['violations'] });
    return found.violations.flatMap(({ id, nodes }) =>
      nodes.map(({ html, failureSummary }) => `${id}: ${html.slice(0, 120)}: ${failureSummary}`));
  });
}
