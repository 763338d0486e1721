// node build.mjs NODE_MODULES OUT_DIR
//
// Bundles each page's script with its libraries into OUT_DIR/PAGE.js and OUT_DIR/PAGE.css, and writes
// OUT_DIR/PAGE.js.sha256, by which the page's content security policy knows the script. Whose libraries
// went into the bundles, and their licences, goes to OUT_DIR/third-party.txt.
import { createHash } from 'node:crypto';
import { readFile, readdir, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const [modules, out] = process.argv.slice(2).map((path) => resolve(path));
// esbuild lies with the other libraries, outside of the sources.
const require = createRequire(join(modules, 'limitgauge'));
const { build } = await import(pathToFileURL(require.resolve('esbuild')));

const pages = { report: 'src/main.js', study: 'src/study/main.js', history: 'src/history/main.js' };

/// Folders of the packages that an input of a bundle comes from.
const packages = new Set();
function note(inputs) {
  for (const input of Object.keys(inputs)) {
    const found = /^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(resolve(here, input));
    if (found && !input.startsWith('(')) packages.add(found[1]);
  }
}

/// Licences and notices that a package brings, beside its manifest or in a folder of their own.
async function noticesOf(folder) {
  const { name, version, license } = JSON.parse(await readFile(join(folder, 'package.json'), 'utf8'));
  const entries = await readdir(folder, { withFileTypes: true });
  const files = entries.filter((e) => e.isFile() && /^(licen[cs]e|notice|copying)\b/i.test(e.name))
    .map((e) => join(folder, e.name));
  if (entries.some((e) => e.isDirectory() && e.name === 'licenses'))
    files.push(...(await readdir(join(folder, 'licenses'))).map((file) => join(folder, 'licenses', file)));
  const texts = await Promise.all(files.sort().map((file) => readFile(file, 'utf8')));
  return [`##### ${name} ${version}: ${license}`, ...texts.map((text) => text.trim())].join('\n\n');
}

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
    metafile: true,
    logLevel: 'warning',
  });
  if (result.warnings.length > 0) process.exit(1);
  note(result.metafile.inputs);
  const script = await readFile(join(out, `${page}.js`));
  await writeFile(join(out, `${page}.js.sha256`), createHash('sha256').update(script).digest('base64'));
}

const notices = await Promise.all([...packages].sort().map(noticesOf));
await writeFile(join(out, 'third-party.txt'), notices.join('\n\n\n') + '\n');
