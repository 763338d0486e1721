// node build.mjs NODE_MODULES OUT_DIR
//
// Bundles each page's script with its libraries into OUT_DIR/PAGE.js and OUT_DIR/PAGE.css, and writes
// OUT_DIR/PAGE.js.sha256, by which the page's content security policy knows the script.
import { createHash } from 'node:crypto';
import { readFile, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const [modules, out] = process.argv.slice(2).map((path) => resolve(path));
// esbuild lies with the other libraries, outside of the sources.
const require = createRequire(join(modules, 'limitgauge'));
const { build } = await import(pathToFileURL(require.resolve('esbuild')));

const pages = { report: 'src/main.js', study: 'src/study/main.js', history: 'src/history/main.js' };

for (const [page, entry] of Object.entries(pages)) {
  const result = await build({
    entryPoints: [join(here, entry)],
    outfile: join(out, `${page}.js`),
    absWorkingDir: here,
    nodePaths: [modules],
    bundle: true,
    minify: true,
    format: 'iife',
    charset: 'ascii',
    target: ['chrome100', 'firefox115'],
    legalComments: 'none',
    logLevel: 'warning',
  });
  if (result.warnings.length > 0) process.exit(1);
  const script = await readFile(join(out, `${page}.js`));
  await writeFile(join(out, `${page}.js.sha256`), createHash('sha256').update(script).digest('base64'));
}
