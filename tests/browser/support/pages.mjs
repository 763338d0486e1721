import { readFileSync } from 'node:fs';
import { join } from 'node:path';

/** What CMake tells the tests: an environment variable that must be there. */
export function given(name) {
  const value = process.env[name];
  if (!value) throw new Error(`${name} is not set: run these tests through ctest -L browser`);
  return value;
}

const folder = (name) => join(given('LIMITGAUGE_PAGES'), name);

/** The sample's or job's page, written by make_pages.mjs. */
export const reportFile = (name, file = 'report.html') => join(folder(name), file);

/** What stands in result.json beside it. */
export const resultOf = (name) => JSON.parse(readFileSync(join(folder(name), 'result.json'), 'utf8'));
