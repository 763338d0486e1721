import { Blob32 } from './blocks.js';
import { decodeFixture } from './fixture.js';
import { lazily } from './lazy.js';
import { decodeStock } from './stock.js';
import { decodeSurface } from './surface.js';
import { unpack } from './unpack.js';

const FORMAT = 'limitgauge.page/1';

/**
 * The report's data as the page holds them (see ../../README.md), with each block a typed array.
 * Arrays are unpacked when they are first asked for: a stage that nobody looks at costs nothing.
 * @param {Document} document
 * @returns {Promise<object>}
 */
export async function decodeReport(document) {
  const report = JSON.parse(element(document, 'limitgauge-report').textContent);
  if (report.format !== FORMAT)
    throw new Error(`the page’s data have the format ${report.format}, not ${FORMAT}`);
  const bytes = await unpack(element(document, 'limitgauge-blob').textContent, report.blob_bytes);
  return decodeData(report, new Blob32(bytes));
}

function element(document, id) {
  const found = document.getElementById(id);
  if (!found) throw new Error('the page holds no data: was it cut short?');
  return found;
}

function decodeData(report, blob) {
  return {
    ...report,
    triangles: report.triangles && blob.numbers(blob.check(report.triangles)),
    surfaces: report.surfaces.map((surface) => decodeSurface(surface, blob)),
    fixtures: report.fixtures.map((fixture) => decodeFixture(fixture, blob)),
    stages: report.stages.map((stage) => decodeStage(stage, report.surfaces, blob)),
  };
}

function decodeStage(stage, surfaces, blob) {
  const { field, path, stock, text, ...rest } = stage;
  rest.field = field && decodeField(field, surfaces, blob);
  rest.path = path && decodePath(path, blob);
  rest.stock = stock && decodeStock(stock, blob);
  blob.check(text.line);
  blob.check(text.utf8);
  return lazily(rest, { text: () => decodeText(text, blob) });
}

function decodeField(field, surfaces, blob) {
  const { deviation_mm, line, stage, flags, ...rest } = field;
  const samples = surfaces[field.surface].position.block.count / 3;
  for (const block of [deviation_mm, line, stage, flags])
    if (blob.check(block).count !== samples)
      throw new Error('the page’s data have another number of deviations than of samples');
  return lazily(rest, arrays({ deviation_mm, line, stage, flags }, blob));
}

function decodePath(path, blob) {
  const { position, kind, feed_mm_min, rate_mm3_min, line, move, end_s, axis, ...rest } = path;
  const blocks = { kind, feed_mm_min, line, move };
  if (rate_mm3_min) blocks.rate_mm3_min = rate_mm3_min;
  else rest.rate_mm3_min = null;
  for (const block of [position.block, end_s.block, ...Object.values(blocks)]) blob.check(block);
  rest.step_mm = position.step_mm;
  if (axis) rest.axis = decodeAxis(axis, kind.count, blob);
  return lazily(rest, {
    ...arrays(blocks, blob),
    positions: () => blob.multiples(position.block, position.step_mm),
    end_s: () => blob.multiples(end_s.block, end_s.step_s),
  });
}

/** How the tool stands where each segment ends, and at the path's beginning. */
function decodeAxis({ start, x, y, z, ...rest }, segments, blob) {
  for (const block of [x, y, z])
    if (blob.check(block).count !== segments)
      throw new Error('the page’s data have another number of tool axes than of path segments');
  return lazily({ ...rest, start }, arrays({ x, y, z }, blob));
}

function arrays(blocks, blob) {
  return Object.fromEntries(
    Object.entries(blocks).map(([name, block]) => [name, () => blob.numbers(block)]));
}

/** Program lines: numbers beside the lines of one text. */
function decodeText(text, blob) {
  const lines = new TextDecoder().decode(blob.numbers(text.utf8)).split('\n');
  return Array.from(blob.numbers(text.line), (line, i) => ({ line, text: lines[i] }));
}
