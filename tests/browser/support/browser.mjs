import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after } from 'node:test';
import { pathToFileURL } from 'node:url';
import { given, reportFile } from './pages.mjs';

// Lies with the page's libraries in the build folder.
const { chromium } = createRequire(join(given('LIMITGAUGE_NODE_MODULES'), 'limitgauge'))('playwright-core');

/**
 * WebGL on a machine without a graphics card. All else of a page is drawn without it: done by the same substitute,
 * it took the graphics process twice the time.
 */
export const softwareGraphics = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-gpu-compositing'];

/**
 * Debian's Chromium without a window, closed when the file's tests are over. Without its sandbox, which
 * root and most containers cannot have: it opens nothing but pages written by this project.
 * @param {string[]} options of the command line
 */
export async function openBrowser(options = softwareGraphics) {
  const browser = await chromium.launch({
    executablePath: given('LIMITGAUGE_CHROMIUM'), chromiumSandbox: false, args: options,
  });
  after(() => browser.close());
  return browser;
}

/** Of the screen to one of the page's: what is laid out is the same, and a quarter as much is drawn. */
const screenScale = 0.5;

/** All that a page which minds its own business never does, as it happens: a list of sentences. */
function watch(page, address) {
  const faults = [];
  page.on('console', (message) => {
    if (message.type() === 'error') faults.push(`console: ${message.text()}`);
  });
  page.on('pageerror', (error) => faults.push(`error: ${error.stack ?? error}`));
  page.on('dialog', (dialog) => {
    faults.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  page.on('popup', (other) => faults.push(`window: ${other.url()}`));
  page.on('crash', () => faults.push('the page crashed'));
  page.on('request', (request) => {
    const url = request.url().split('#')[0];
    if (url !== address && !/^(data|blob):/.test(url)) faults.push(`request: ${url}`);
  });
  return faults;
}

/**
 * Opens a report from disk as a reader would, hands the page to `use`, and sees to it that nothing went
 * wrong in it meanwhile.
 * @param options width, height (px); early: a function that runs in the page before its own script; view: false
 *   for a page that cannot draw in 3D, which opens in two thirds of the time; file: what of the folder is opened,
 *   report.html else; all else as playwright's newContext takes it
 */
export async function withReport(browser, name, options, use) {
  const { width = 1280, height = 900, early, view = true, file, ...others } = options;
  const context = await browser.newContext({ viewport: { width, height }, deviceScaleFactor: screenScale, ...others });
  try {
    // Nothing here is timed: a machine that does three things at once may take its time.
    context.setDefaultTimeout(60_000);
    const page = await context.newPage();
    const address = pathToFileURL(reportFile(name, file)).href;
    const faults = watch(page, address);
    if (!view) await page.addInitScript(noContext);
    if (early) await page.addInitScript(early);
    await page.goto(address);
    if (others.javaScriptEnabled !== false) await whenReady(page);
    await use(page, faults);
    assert.deepEqual(faults, []);
  } finally {
    await context.close();
  }
}

/** In the page, before its script: no canvas gives a WebGL context. */
export function noContext() {
  const given = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, ...others) {
    return kind.startsWith('webgl') ? null : given.call(this, kind, ...others);
  };
}

/**
 * In the page: until what was asked for so far is on the screen. A browser on a machine that does three things at once
 * may forget a frame that was asked for, and a test would wait for it until its end: it is asked for again then.
 */
export async function twoFrames() {
  const patience_ms = 5_000;
  for (let i = 0; i < 2; ++i) {
    await new Promise((seen) => {
      requestAnimationFrame(seen);
      setTimeout(() => requestAnimationFrame(seen), patience_ms);
      setTimeout(seen, 2 * patience_ms);
    });
  }
}

/** Until the script says that all of it stands, and what it drew is on the screen. */
export async function whenReady(page) {
  await page.evaluate(() => window.limitgauge?.ready);
  await page.evaluate(twoFrames);
}

/**
 * Has everything drawn that is drawn when it comes into sight: goes from figure to figure, and stays with each that was
 * out of sight until it was on the screen. A page unfolded for a telephone is a hundred screens tall: to scroll through
 * it took a third of a test's time.
 */
export async function seeFigures(page) {
  await page.evaluate(`(async () => {
    ${twoFrames}
    for (const figure of document.querySelectorAll('figure, .chart-plot')) {
      const { top, bottom, height } = figure.getBoundingClientRect();
      if (height > 0 && top >= 0 && bottom <= innerHeight) continue;
      figure.scrollIntoView({ block: 'center', behavior: 'instant' });
      await twoFrames();
    }
  })()`);
}
