// What assistive technology is told: names, headings, and words that can be made out.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openBrowser, withReport } from './support/browser.mjs';
import { faintWords } from './support/contrast.mjs';
import { settle, showPath, showStage } from './support/view.mjs';

const browser = await openBrowser();
const named = ['button', 'checkbox', 'combobox', 'image', 'link', 'radio', 'slider', 'spinbutton', 'tab',
  'textbox', 'tablist', 'application', 'table'];

async function openAll(page) {
  // A program without a design by one tool has one stage.
  if (await page.locator('[data-testid="view-stages"] [role=tab]').count() > 1) await showStage(page, 1);
  await showPath(page);
  await page.evaluate(() => document.querySelectorAll('details').forEach((d) => (d.open = true)));
  await settle(page);
}

/** The browser's own accessibility tree, as {role, name}. */
async function accessibilityTree(page) {
  const session = await page.context().newCDPSession(page);
  const { nodes } = await session.send('Accessibility.getFullAXTree');
  return nodes.filter((node) => !node.ignored)
    .map((node) => ({ role: node.role.value, name: node.name?.value ?? '', id: node.backendDOMNodeId }));
}

for (const name of ['failed', 'dome', 'cut'])
  test(`${name}: every control and picture has a name, headings leave out no level`, () =>
    withReport(browser, name, {}, async (page) => {
      await openAll(page);
      const tree = await accessibilityTree(page);
      const nameless = tree.filter(({ role, name }) => named.includes(role) && !name.trim());
      assert.deepEqual(nameless, []);
      for (const role of ['button', 'checkbox', 'combobox', 'slider', 'tab'])
        assert.ok(tree.some((node) => node.role === role), `there is a ${role}`);
      const levels = await page.evaluate(() =>
        [...document.querySelectorAll('h1, h2, h3, h4, h5, h6')]
          .filter((e) => e.checkVisibility()).map((e) => [Number(e.tagName[1]), e.textContent]));
      assert.equal(levels.filter(([level]) => level === 1).length, 1);
      const leaps = levels.filter(([level], i) => level > (levels[i - 1]?.[0] ?? 0) + 1);
      assert.deepEqual(leaps, []);
    }));

for (const name of ['passed', 'failed', 'undecided'])
  test(`${name}: all words stand out from their ground, in light and in dark`, () =>
    withReport(browser, name, { colorScheme: 'light' }, async (page) => {
      await openAll(page);
      for (const colorScheme of ['light', 'dark']) {
        await page.emulateMedia({ colorScheme });
        await settle(page);
        assert.deepEqual((await faintWords(page)).map((fault) => `${colorScheme}: ${fault}`), []);
      }
    }));
