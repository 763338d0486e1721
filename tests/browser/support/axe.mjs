import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { given } from './pages.mjs';

// Lies with the page's libraries, by the lock file: without it nothing was built.
const axe = readFileSync(join(given('LIMITGAUGE_NODE_MODULES'), 'axe-core', 'axe.min.js'), 'utf8');

/**
 * Marks the elements whose words axe is to hold against their ground: one of each look. Asking for all took
 * three quarters of axe's time, most of it for rows of tables that have the classes and the computed colours
 * of the row before, up to the root. What may lie over something else than its ancestors is marked each time.
 */
function markLooks() {
  const looks = new Map(), numbers = new Map();
  const over = (element, style) => element.closest('svg') || style.position !== 'static' ||
    style.transform !== 'none' || style.float !== 'none' || parseFloat(style.marginTop) < 0;
  const lookOf = (element) => {
    if (!element) return 0;
    const known = numbers.get(element);
    if (known !== undefined) return known;
    const style = getComputedStyle(element);
    const look = [lookOf(element.parentElement), element.tagName, element.getAttribute('class'), element.hidden,
      element.ariaHidden, element.disabled, style.color, style.backgroundColor, style.backgroundImage,
      style.fontSize, style.fontWeight, style.opacity, style.filter, style.mixBlendMode, style.textShadow,
      style.display, style.visibility, ...(over(element, style) ? [looks.size] : [])].join();
    if (!looks.has(look)) looks.set(look, looks.size + 1);
    numbers.set(element, looks.get(look));
    return looks.get(look);
  };
  const asked = new Set();
  for (const element of document.body.querySelectorAll('*')) {
    delete element.dataset.look;
    const speaks = element.matches('button, input, select, textarea') ||
      [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.data.trim());
    const look = lookOf(element);
    if (!speaks || asked.has(look)) continue;
    asked.add(look);
    element.dataset.look = look;
  }
}

/** What axe objects to, a sentence an element; the page must have been opened with bypassCSP. */
export async function violations(page) {
  if (!(await page.evaluate(() => Boolean(window.axe)))) await page.evaluate(axe);
  await page.evaluate(markLooks);
  return page.evaluate(async () => {
    // axe would write out each element that it looks at, the whole page with its data among them.
    window.axe.configure({ noHtml: true, rules: [{ id: 'color-contrast', selector: '[data-look]' }] });
    const found = await window.axe.run(document, { resultTypes: ['violations'] });
    const start = (target) => document.querySelector(target).cloneNode().outerHTML.slice(0, 120);
    return found.violations.flatMap(({ id, nodes }) =>
      nodes.map(({ target, failureSummary }) => `${id}: ${start(target[0])}: ${failureSummary}`));
  });
}

/**
 * That axe objects to nothing, wide in light and narrow in dark. One page for both: opening it takes longer than to
 * look at it.
 * @param before what is to be done with the page each time, ahead of axe
 */
export async function findsNothing(page, before = async () => {}) {
  for (const [width, colorScheme] of [[1280, 'light'], [400, 'dark']]) {
    await page.setViewportSize({ width, height: 900 });
    await page.emulateMedia({ colorScheme });
    await before(page);
    assert.deepEqual(await violations(page), [], `${width} px, ${colorScheme}`);
  }
}
