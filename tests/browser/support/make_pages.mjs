// make_pages.mjs PROGRAM WRITE_SAMPLES WRITE_STUDIES FIXTURES OUT_DIR
//
// The reports that the tests open: samples of known figures, a job as it is, and a job whose program
// gouges, with markup in its comments and in the cage's name.
import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const [program, writeSamples, writeStudies, fixtures, out] = process.argv.slice(2);
const hostileCage = 'plate"><img src=x onerror=window.hostile=1>.obj';
const hostileComment = '(</script><img src=x onerror=window.hostile=1><svg onload=window.hostile=1>)';

/** `text` with its one occurrence of `from` replaced. */
function replaceOne(text, from, to) {
  const parts = text.split(from);
  if (parts.length !== 2) throw new Error(`"${from}" stands ${parts.length - 1} times`);
  return parts.join(to);
}

/** Runs the program; a verdict that is no pass is exit code 1 or 2. */
function run(words, name, expected) {
  try {
    execFileSync(program, [...words, '-o', join(out, name), '--quiet'], { stdio: 'inherit' });
  } catch (error) {
    if (error.status !== expected) throw error;
    return;
  }
  if (expected !== 0) throw new Error(`${words.join(' ')} passed`);
}

/** Beside the plate, out of the tool's way. */
const clamp = ['', '[[fixture]]', 'name = "clamp"', 'file = "clamp.obj"', 'translate = [60, 0, -5]', ''].join('\n');

/** A groove of 60 µm in one row of the finish, off the floor of the plate. */
function gougingJob() {
  const folder = join(out, 'gouging-job');
  mkdirSync(folder, { recursive: true });
  cpSync(join(fixtures, 'plate.obj'), join(folder, hostileCage));
  cpSync(join(fixtures, '../findings/clamp.obj'), join(folder, 'clamp.obj'));
  const text = (name) => readFileSync(join(fixtures, name), 'latin1');
  const job = replaceOne(text('plate.toml'), '"plate.obj"', `'${hostileCage}'`);
  writeFileSync(join(folder, 'plate.toml'), job + clamp);
  const groove = `N185 Y-4. ${hostileComment}\nN190 Z-0.06 X14.`;
  let gouging = replaceOne(text('plate.ngc'), 'N185 Y-4.\nN190 X14.', groove);
  // A comment as a German controller's editor stores it: no UTF-8.
  gouging = replaceOne(gouging, 'N195 Y1.', 'N195 Z0. Y1. (TIEFE GEPR\xdcFT)');
  writeFileSync(join(folder, 'plate.ngc'), gouging, 'latin1');
  return join(folder, 'plate.toml');
}

/** Two slots of 6 mm, the second one cut by a rapid. */
function cutProgram() {
  const file = join(out, 'slots.ngc');
  writeFileSync(file, ['G21 G90 G17', 'T1 M6', 'S8000 M3', 'G0 Z10', '(first)', 'G0 X-6 Y10', 'G1 Z-2 F600',
    'G1 X56', 'G0 Z10', 'G0 X-6 Y28', 'G1 Z-4 F600', 'G0 X56', 'G0 Z10', 'M5', 'M30', ''].join('\n'));
  return ['cut', '--stock', 'box:50,40,20@0,0,-20', '--tool', 'flat:D=6,L=20,shank=6:20', '--program', file];
}

/** A triangulated ramp of 20 x 30 cells as the design, which a pocket of a flat cutter gouges. */
function meshTarget() {
  const [columns, rows] = [20, 30], at = (i, j) => `${2 * i} ${j} ${(-0.05 * i).toFixed(3)}`;
  const facets = [];
  const facet = (...corners) => facets.push('facet normal 0 0 1', 'outer loop',
    ...corners.map((corner) => `vertex ${corner}`), 'endloop', 'endfacet');
  for (let i = 0; i < columns; ++i)
    for (let j = 0; j < rows; ++j) {
      facet(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      facet(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  writeFileSync(join(out, 'ramp.stl'), ['solid ramp', ...facets, 'endsolid ramp', ''].join('\n'));
  const pocket = ['G21 G90 G17', 'T1 M6', 'S8000 M3', 'G0 Z10', 'G0 X20 Y15', 'G1 Z-2 F600', 'G1 X30',
    'G0 Z10', 'M5', 'M30', ''];
  writeFileSync(join(out, 'pocket.ngc'), pocket.join('\n'));
  return ['verify', '--target', join(out, 'ramp.stl'), '--stock', 'box:40,30,20@0,0,-20',
    '--tool', 'flat:D=6,L=20,shank=6:20', '--program', join(out, 'pocket.ngc'), '--gouge', '0.1'];
}

/** Three rows over the middle of the plate, too wide apart for what is not known of zero and cutter. */
function toleratedProgram() {
  const file = join(out, 'rows.ngc');
  const rows = [-6.5, 0, 6.5].flatMap((y) => ['G0 Z2', `X-30 Y${y}`, 'G1 Z0 F400', 'X30 F1000']);
  writeFileSync(file, ['G21 G90 G17 G94', 'T1 M6', 'S8000 M3', 'G0 Z20', ...rows, 'G0 Z20', 'M30', ''].join('\n'));
  return ['verify', '--cage', join(fixtures, 'plate.obj'), '--stock', 'box:44,44,6@-22,-22,-5',
    '--tool', '1=flat:D=8,L=20', '--program', file, '--gouge', '0.005', '--uncut', '2',
    '--tolerance', 'zero=0.002,0.002,0.004', '--tolerance', '1:radius=0.01,length=0.003'];
}

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
execFileSync(writeSamples, [out, 'passed', 'failed', 'undecided', 'hostile', 'large', 'turning']);
execFileSync(writeStudies, [join(out, 'studies')]);
run(['run', join(fixtures, '../jobs/quick-dome.toml')], 'dome', 0);
run(['run', gougingJob()], 'gouging', 1);
run(cutProgram(), 'cut', 1);
run(meshTarget(), 'mesh', 1);
run(toleratedProgram(), 'tolerated', 1);
run(['compare', join(out, 'passed'), join(out, 'failed')], 'compared', 1);
