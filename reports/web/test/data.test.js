import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateSync } from 'node:zlib';
import { Blob32 } from '../src/data/blocks.js';
import { decodeReport } from '../src/data/decode.js';
import { decodeFixture } from '../src/data/fixture.js';
import { decodeSurface } from '../src/data/surface.js';
import { unpack } from '../src/data/unpack.js';

/** Writes blocks as the format's description says. */
class Packer {
  bytes = [];

  add(words, type, order = 0, components = 1) {
    const at = this.bytes.length, count = words.length;
    let w = Array.from(words, (x) => x >>> 0);
    for (let k = 0; k < order; ++k)
      w = w.map((x, i) => (i < components ? x : (x - w[i - components]) >>> 0));
    if (order > 0) w = w.map((x) => ((x << 1) ^ (x >> 31)) >>> 0);
    for (let plane = 0; plane < (type === 'u8' ? 1 : 4); ++plane)
      for (const x of w) this.bytes.push((x >>> (8 * plane)) & 255);
    return { at, count, type, order, ...(components > 1 ? { components } : {}) };
  }

  floats(values) {
    return this.add(new Uint32Array(Float32Array.from(values).buffer), 'f32');
  }

  get blob() {
    return new Blob32(Uint8Array.from(this.bytes));
  }
}

test('numbers of every kind and order come back', () => {
  const values = [5, 0, 4294967295, 7, 2147483648, 9, 9, 9, 1000000, 0, 1, 2];
  for (const order of [0, 1, 2])
    for (const components of [1, 3]) {
      const packer = new Packer();
      packer.add([1, 2, 3], 'u8');
      const u = packer.add(values, 'u32', order, components);
      const i = packer.add(values, 'i32', order, components);
      assert.deepEqual([...packer.blob.numbers(u)], values);
      assert.deepEqual([...packer.blob.numbers(i)], values.map((x) => x | 0));
    }
  const packer = new Packer();
  const f = packer.floats([1.5, -2e-30, 0]);
  const b = packer.add([0, 7, 255], 'u8');
  assert.deepEqual([...packer.blob.numbers(f)], [...Float32Array.of(1.5, -2e-30, 0)]);
  assert.deepEqual([...packer.blob.numbers(b)], [0, 7, 255]);
  const m = packer.add([-3, 2], 'i32', 1);
  assert.deepEqual([...packer.blob.multiples(m, 0.25)], [-0.75, 0.5]);
});

test('a block beyond the data, or of an unknown kind, is refused in words', () => {
  const blob = new Blob32(new Uint8Array(16));
  assert.throws(() => blob.numbers({ at: 4, count: 4, type: 'u32', order: 0 }), /cut short/);
  assert.throws(() => blob.numbers({ at: -1, count: 4, type: 'u8', order: 0 }), /cut short/);
  assert.throws(() => blob.numbers({ at: 0, count: 4, type: 'f64', order: 0 }), /unknown kind/);
  assert.throws(() => blob.numbers({ at: 0, count: 4, type: 'u32', order: 3 }), /unknown kind/);
});

/** A part of a cylinder of radius 10 about the y axis as one patch; outward is away from the axis. */
function cylinder(columns, rows, measured) {
  const packer = new Packer(), step = 1 / 1024, points = [];
  for (let j = 0; j < rows; ++j)
    for (let i = 0; i < columns; ++i) {
      // u runs along the axis, v around it.
      const angle = (2 * j) / (rows - 1), y = (8 * i) / (columns - 1);
      points.push(...[10 * Math.sin(angle), -y, 10 * Math.cos(angle)].map((c) => Math.round(c / step)));
    }
  const block = packer.add(points, 'i32', 2, 3);
  const patch = { patch: 4, columns, rows, ...(measured ? { measured } : {}) };
  const json = { patches: [patch], stride: 1, position: { block, step_mm: step } };
  return decodeSurface(json, packer.blob);
}

test('positions, cells and outward normals of a grid', () => {
  const surface = cylinder(9, 41);
  assert.equal(surface.positions.length, 3 * 9 * 41);
  assert.equal(surface.cells.length, 4 * 8 * 40);
  for (let k = 0; k < 9 * 41; ++k) {
    const p = surface.positions.subarray(3 * k, 3 * k + 3), n = surface.normals.subarray(3 * k, 3 * k + 3);
    const r = Math.hypot(p[0], p[2]);
    // Within what half a step does over two cells of half a millimetre.
    assert.ok(Math.hypot(n[0] - p[0] / r, n[1], n[2] - p[2] / r) < 5e-3, `sample ${k}`);
  }
  for (let c = 0; c < surface.cells.length; c += 4) {
    const [a, b, , d] = surface.cells.subarray(c, c + 4);
    const p = (k) => surface.positions.subarray(3 * k, 3 * k + 3);
    const u = p(b).map((x, i) => x - p(a)[i]), v = p(d).map((x, i) => x - p(a)[i]);
    const cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const n = surface.normals.subarray(3 * a, 3 * a + 3);
    assert.ok(cross[0] * n[0] + cross[1] * n[1] + cross[2] * n[2] > 0, `cell ${c / 4}`);
  }
});

test('where a grid shrinks to a point its normal is that of its neighbour', () => {
  // A triangle in the plane x = 0: columns at 0, 1 and 4 along y, of heights 0, 2 and 0.
  const packer = new Packer(), points = [];
  for (const up of [0, 1, 2]) points.push(0, 0, 0, 0, 1, up, 0, 4, 0);
  const position = { block: packer.add(points, 'i32', 2, 3), step_mm: 1 };
  const json = { patches: [{ patch: 6, columns: 3, rows: 3 }], stride: 1, position };
  const { normals } = decodeSurface(json, packer.blob);
  for (let k = 0; k < 9; ++k) assert.deepEqual([...normals.subarray(3 * k, 3 * k + 3)], [1, 0, 0], `sample ${k}`);
  const line = { ...json, position: { block: packer.add(new Array(27).fill(5), 'i32', 2, 3), step_mm: 1 } };
  assert.deepEqual([...decodeSurface(line, packer.blob).normals.subarray(0, 3)], [0, 0, 1]);
});

test('a sample’s place', () => {
  const surface = cylinder(9, 41);
  assert.deepEqual(surface.place(0), { patch: 4, u: 0, v: 0 });
  assert.deepEqual(surface.place(9 * 20 + 2), { patch: 4, u: 0.25, v: 0.5 });
  // Of 11 measured columns 5 are shown: 0, 3 (2.5, rounded up), 5, 8, 10.
  const thinned = cylinder(5, 3, [11, 5]);
  assert.deepEqual([0, 1, 2, 3, 4].map((k) => thinned.place(k).u), [0, 0.3, 0.5, 0.8, 1]);
  assert.deepEqual([0, 5, 10].map((k) => thinned.place(k).v), [0, 0.5, 1]);
});

/** A document that holds nothing but the page's data. */
function pageOf(report, bytes) {
  const texts = {
    'limitgauge-report': JSON.stringify(report),
    'limitgauge-blob': deflateSync(Uint8Array.from(bytes)).toString('base64'),
  };
  return {
    texts,
    getElementById: (id) => (texts[id] === undefined ? null : { textContent: texts[id] }),
  };
}

function smallPage({ axes } = {}) {
  const packer = new Packer();
  const position = { block: packer.add([0, 0, 0, 4, 0, 0, 0, 4, 0, 4, 4, 0], 'i32', 1, 3), step_mm: 0.25 };
  const surfaces = [{ patches: [{ patch: 0, columns: 2, rows: 2 }], stride: 1, position }];
  const utf8 = [...new TextEncoder().encode('G1 X1\n(höhe <b>)\n')];
  const stage = {
    name: 's', ran: true, gouges: [],
    field: {
      surface: 0, deviation_mm: packer.floats([0.5, 0, -0.5, 1]), line: packer.add([3, 3, 4, 4], 'u32', 1),
      stage: packer.add([0, 0, 0, 0], 'u32'), flags: packer.add([0, 1, 2, 4], 'u8'),
    },
    text: { line: packer.add([7, 9], 'u32'), utf8: packer.add(utf8, 'u8') },
    path: {
      moves: 2, within_mm: 0, start_mm: [0, 0, 5],
      position: { block: packer.add([0, 0, 0, 8, 8, 0], 'i32', 0, 3), step_mm: 0.5 },
      kind: packer.add([0, 1], 'u8'), feed_mm_min: packer.floats([0, 600]), rate_mm3_min: null,
      line: packer.add([1, 2], 'u32'), move: packer.add([0, 1], 'u32'),
      end_s: { block: packer.add([10, 30], 'u32'), step_s: 0.5 },
    },
  };
  if (axes) {
    const [x, y, z] = axes.map((part) => packer.floats(part));
    stage.path.axis = { start: [0, 0, 1], x, y, z };
  }
  const unrun = { name: 't', ran: false, field: null, path: null,
    text: { line: packer.add([], 'u32'), utf8: packer.add([], 'u8') } };
  const report = { format: 'limitgauge.page/1', job: 'j', surfaces, fixtures: [], stages: [stage, unrun],
    blob_bytes: packer.bytes.length };
  return pageOf(report, packer.bytes);
}

test('a whole page is unpacked', async () => {
  const report = await decodeReport(smallPage());
  assert.deepEqual([...report.surfaces[0].positions], [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0]);
  assert.deepEqual([...report.surfaces[0].cells], [0, 1, 3, 2]);
  assert.deepEqual([...report.surfaces[0].normals], [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]);
  const { field, path, text } = report.stages[0];
  assert.deepEqual([...field.deviation_mm], [0.5, 0, -0.5, 1]);
  assert.deepEqual([...field.line], [3, 3, 4, 4]);
  assert.deepEqual([...field.flags], [0, 1, 2, 4]);
  assert.deepEqual(text, [{ line: 7, text: 'G1 X1' }, { line: 9, text: '(höhe <b>)' }]);
  assert.deepEqual([...path.positions], [0, 0, 0, 4, 4, 0]);
  assert.deepEqual([...path.end_s], [5, 15]);
  assert.equal(path.rate_mm3_min, null);
  assert.deepEqual(report.stages[1].text, []);
  assert.equal(report.stages[1].field, null);
  // Worked out once.
  assert.equal(field.deviation_mm, report.stages[0].field.deviation_mm);
});

test('the axes of a path that turns its tool are unpacked, one a segment', async () => {
  const { path } = (await decodeReport(smallPage({ axes: [[0, 1], [0.5, 0], [0.75, 0]] }))).stages[0];
  assert.deepEqual(path.axis.start, [0, 0, 1]);
  assert.deepEqual(['x', 'y', 'z'].map((k) => [...path.axis[k]]), [[0, 1], [0.5, 0], [0.75, 0]]);
  assert.equal((await decodeReport(smallPage())).stages[0].path.axis, undefined);
  await assert.rejects(decodeReport(smallPage({ axes: [[0], [0], [1]] })), /number of tool axes/);
});

test('a page that was cut short or is not ours says so', async () => {
  const damaged = async (change, message) => {
    const page = smallPage();
    change(page.texts);
    await assert.rejects(decodeReport(page), message);
  };
  await damaged((t) => delete t['limitgauge-blob'], /holds no data/);
  await damaged((t) => delete t['limitgauge-report'], /holds no data/);
  await damaged((t) => (t['limitgauge-blob'] = t['limitgauge-blob'].slice(0, -12)), /cut short/);
  await damaged((t) => (t['limitgauge-blob'] = '%%'), /damaged/);
  await damaged((t) => (t['limitgauge-report'] = '{"format":"other/1"}'), /format other\/1/);
  await damaged((t) => {
    t['limitgauge-report'] = t['limitgauge-report'].replace(/"blob_bytes":\d+/, '"blob_bytes":9');
  }, /cut short/);
});

test('a browser without the means to unpack is told', async () => {
  const kept = globalThis.DecompressionStream;
  try {
    delete globalThis.DecompressionStream;
    await assert.rejects(unpack('eJwDAAAAAAE='), /too old/);
  } finally {
    globalThis.DecompressionStream = kept;
  }
});

test('a fixture stands where its numbers say', () => {
  const packer = new Packer();
  const block = packer.add([100, 0, 0, 110, 0, 0, 100, 10, 0, 100, 0, 10], 'i32', 1, 3);
  const triangle = packer.add([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3], 'i32', 1, 3);
  const position = { block, step_mm: 0.5 };
  const fixture = decodeFixture({ name: 'clamp', position, triangle, file_triangles: 4 }, packer.blob);
  assert.equal(fixture.triangles, 4);
  assert.deepEqual([...fixture.positions.subarray(3, 6)], [55, 0, 0]);
  assert.deepEqual([...fixture.corners], [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
  assert.throws(() => decodeFixture({ name: 'cut short', position, triangle }, new Blob32(new Uint8Array(9))));
});
