// node check_pages.mjs WRITE_SAMPLES: pages as the program writes them, unpacked by their own script,
// hold what the result holds: positions within the stated step, deviations within 2^-13 of themselves,
// findings, lines, text and paths as they are.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { decodeReport } from '../../reports/web/src/data/decode.js';

const folder = mkdtempSync(join(tmpdir(), 'limitgauge-'));
try {
  execFileSync(process.argv[2], [folder, 'passed', 'failed', 'undecided', 'thinned']);
  for (const name of ['passed', 'failed', 'undecided']) await checkPage(name);
  await checkThinnedPage();
} finally {
  rmSync(folder, { recursive: true });
}

/** The page's data, taken out of the file by the tags alone. */
async function decoded(name) {
  const page = readFileSync(join(folder, name, 'report.html'), 'utf8');
  const getElementById = (id) => {
    const found = page.match(new RegExp(`<script type="[^"]*" id="${id}">([^<]*)</script>`));
    return found && { textContent: found[1] };
  };
  return decodeReport({ getElementById });
}

/** The sample job's surface: closed forms of tests/reports/sample_result.cpp. */
function surfacePoint({ patch, u, v }) {
  const x = (((patch % 6) + u) / 6 - 0.5) * 80, y = ((Math.floor(patch / 6) + v) / 5 - 0.5) * 65;
  return [x, y, 9 * Math.cos(x / 26) * Math.cos(y / 21) + 0.6 * Math.sin(x / 5) * Math.cos(y / 6)];
}

function checkSurface(surface) {
  const { positions, normals, step_mm } = surface;
  for (let k = 0; k < surface.samples; ++k) {
    const place = surface.place(k), point = surfacePoint(place), h = 1e-5;
    for (let axis = 0; axis < 3; ++axis)
      assert.ok(Math.abs(positions[3 * k + axis] - point[axis]) <= step_mm, `position ${k}`);
    const slope = (axis) => {
      const moved = { ...place, [axis]: place[axis] + h };
      return surfacePoint(moved).map((c, i) => (c - point[i]) / h);
    };
    const [ax, , az] = slope('u'), [, by, bz] = slope('v');
    const exact = [-az / ax, -bz / by, 1], length = Math.hypot(...exact);
    const off = Math.hypot(...exact.map((c, i) => c / length - normals[3 * k + i]));
    assert.ok(off < 0.01, `normal ${k} is off by ${off}`);
  }
}

function checkField(field, name, stage) {
  const lines = readFileSync(join(folder, name, stage, 'field.txt'), 'utf8').trim().split('\n');
  assert.equal(field.deviation_mm.length, lines.length);
  lines.forEach((text, k) => {
    const [deviation, line, by, reachable] = text.split(' ').map(Number);
    assert.ok(Math.abs(field.deviation_mm[k] - deviation) <= Math.abs(deviation) * 2 ** -13, `sample ${k}`);
    assert.equal(field.line[k], line);
    assert.equal(field.stage[k], by);
    assert.equal(field.flags[k], reachable ? 0 : 1);
  });
}

function checkFindings(shown, written, stages) {
  assert.equal(shown.length, written.length);
  shown.forEach((finding, k) => {
    const { x, y, z, stage, ...rest } = written[k];
    assert.deepEqual(finding.point_mm, [x, y, z]);
    assert.equal(stages[finding.stage].name, stage);
    for (const key of ['depth_mm', 'area_mm2', 'patch', 'u', 'v', 'line', 'move', 'body', 'extent_mm'])
      assert.deepEqual(finding[key], rest[key], key);
    assert.ok(Math.abs(Math.hypot(...finding.normal) - 1) < 1e-12);
  });
}

function checkText(stage, stages) {
  const named = stages.flatMap((by) => [...(by.gouges ?? []), ...(by.uncuts ?? [])])
    .filter((finding) => finding.stage === stage.index && finding.line > 0).map((f) => f.line);
  const texts = new Map(stage.text.map(({ line, text }) => [line, text]));
  for (const line of [...named, ...stage.process.map((p) => p.line)])
    if (line <= stage.path.line.at(-1)) assert.match(texts.get(line), /^G1 X/, `line ${line}`);
}

function checkPath(path, toolpath) {
  assert.equal(path.moves, toolpath.moves);
  assert.equal(path.within_mm, 0);
  assert.equal(path.kind.length, toolpath.moves);
  assert.ok(Math.abs(path.end_s.at(-1) / toolpath.machining_time_s - 1) < 1e-6);
  assert.equal(path.rate_mm3_min, null);
  let from = path.start_mm, cut = 0, rapid = 0, seconds = 0;
  for (let k = 0; k < path.moves; ++k) {
    const to = path.positions.subarray(3 * k, 3 * k + 3);
    const length = Math.hypot(...from.map((c, i) => to[i] - c));
    if (path.kind[k] === 1) cut += length;
    else rapid += length;
    seconds += (60 * length) / (path.kind[k] === 1 ? path.feed_mm_min[k] : 5000);
    assert.ok(Math.abs(path.end_s[k] - seconds) < 1e-3 * (1 + seconds), `end of move ${k}`);
    from = to;
  }
  assert.ok(Math.abs(cut / toolpath.cut_length_mm - 1) < 1e-5);
  assert.ok(Math.abs(rapid / toolpath.rapid_length_mm - 1) < 1e-5);
}

async function checkPage(name) {
  const report = await decoded(name);
  const result = JSON.parse(readFileSync(join(folder, name, 'result.json'), 'utf8'));
  assert.equal(report.job, result.job);
  assert.equal(report.verdict, result.verdict);
  assert.equal(report.surfaces.length, 1);
  checkSurface(report.surfaces[0]);
  result.stages.forEach((written, k) => {
    const stage = report.stages[k];
    assert.equal(stage.name, written.name);
    assert.equal(stage.verdict, written.verdict);
    assert.equal(stage.ran, written.deviation !== undefined);
    if (!stage.ran) return;
    checkField(stage.field, name, stage.name);
    assert.deepEqual(stage.gouge_mm, written.deviation.gouge_mm);
    assert.deepEqual(stage.histogram, written.deviation.histogram);
    checkFindings(stage.gouges, written.deviation.gouges, result.stages);
    checkFindings(stage.uncuts, written.deviation.uncuts, result.stages);
    assert.deepEqual(stage.process.map((p) => p.line).sort(),
      written.simulation.findings.map((p) => p.line).sort());
    checkText(stage, report.stages);
    checkPath(stage.path, written.toolpath);
  });
}

async function checkThinnedPage() {
  const { surfaces: [surface], stages: [stage] } = await decoded('thinned');
  assert.equal(surface.stride, 2);
  assert.equal(surface.measured_samples, 30 * 100 * 100);
  assert.equal(surface.cells.length, 4 * 30 * 50 * 50);
  assert.equal(stage.field.flags.length, surface.samples);
  checkSurface(surface);
}
