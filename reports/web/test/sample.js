/**
 * A report as decodeReport gives it, from closed forms: two patches of a wave side by side, 40 x 20 mm,
 * with a gouge and a leftover, and a path of rows over them.
 */
export function sampleReport({ columns = 41, rows = 41 } = {}) {
  const surface = sampleSurface(columns, rows);
  const count = surface.positions.length / 3;
  const stages = ['rough', 'finish'].map((name, index) => sampleStage(name, index, surface, count));
  return {
    format: 'limitgauge.page/1',
    job: 'sample',
    created: '2026-01-01T00:00:00Z',
    version: '0.0.0',
    verdict: 'fail',
    bounds_mm: [[0, 0, -2], [40, 20, 2]],
    surfaces: [surface],
    stages,
  };
}

const height = (x, y) => 2 * Math.sin(x / 6) * Math.cos(y / 5);

function sampleSurface(columns, rows) {
  const patches = [0, 1].map((patch) => ({ patch, columns, rows }));
  const positions = [], normals = [], cells = [], first = [];
  for (const { patch } of patches) {
    const base = positions.length / 3;
    first.push(base);
    for (let j = 0; j < rows; ++j)
      for (let i = 0; i < columns; ++i) {
        const x = 20 * (patch + i / (columns - 1)), y = (20 * j) / (rows - 1);
        positions.push(x, y, height(x, y));
        const n = [-Math.cos(x / 6) * Math.cos(y / 5) / 3, 0.4 * Math.sin(x / 6) * Math.sin(y / 5), 1];
        const length = Math.hypot(...n);
        normals.push(...n.map((c) => c / length));
        if (i + 1 < columns && j + 1 < rows) {
          const a = base + j * columns + i;
          cells.push(a, a + 1, a + columns + 1, a + columns);
        }
      }
  }
  const place = (sample) => {
    const patch = sample < columns * rows ? 0 : 1;
    const k = sample - patch * columns * rows;
    return { patch, u: (k % columns) / (columns - 1), v: Math.floor(k / columns) / (rows - 1) };
  };
  return {
    patches, stride: 1, first, place,
    positions: Float32Array.from(positions), normals: Float32Array.from(normals),
    cells: Uint32Array.from(cells),
  };
}

function finding(id, x, y, depth_mm, line) {
  return {
    id, point_mm: [x, y, height(x, y)], normal: [0, 0, 1], depth_mm, area_mm2: 3,
    extent_mm: [[x - 1, y - 1, -1], [x + 1, y + 1, 1]], patch: x < 20 ? 0 : 1,
    u: (x % 20) / 20, v: y / 20, stage: 0, line, move: line - 1, body: 'cutter',
  };
}

function sampleStage(name, index, surface, count) {
  const deviation = new Float32Array(count), line = new Uint32Array(count);
  const flags = new Uint8Array(count), stage = new Uint8Array(count);
  for (let k = 0; k < count; ++k) {
    const [x, y] = surface.positions.subarray(3 * k, 3 * k + 2);
    const bump = (cx, cy) => Math.exp(-((x - cx) ** 2 + (y - cy) ** 2) / 2);
    deviation[k] = 0.004 * Math.sin(x) - 0.05 * bump(10, 10) + 0.03 * bump(30, 5);
    line[k] = 1 + Math.round(y);
    if (x > 39) flags[k] = 1;
  }
  return {
    name, index, tool: 'ball3', path_source: 'zigzag', ran: true,
    verdict: index === 0 ? 'pass' : 'fail', allowance_mm: index === 0 ? 0.2 : 0,
    limits: { gouge_mm: 0.01, uncut_mm: 0.02 },
    gouge_mm: { low: 0.0499, high: 0.0501 }, uncut_mm: { low: 0.0299, high: 0.0301 },
    field: { surface: 0, deviation_mm: deviation, line, stage, flags },
    gouges: [finding('G1', 10, 10, 0.05, 11)],
    uncuts: [{ ...finding('U1', 30, 5, 0.03, 6), passes: [{ stage: 0, line: 6, move: 5 }] }],
    process: [{ id: 'P1', kind: 'near_miss', words: 'near miss', line: 3, move: 2, point_mm: [5, 2, 3],
      depth_mm: -0.1, part: 'holder', against: 'stock' }],
    text: [3, 5, 6, 7, 10, 11, 12].map((n) => ({ line: n, text: `N${n} G1 X${n}` })),
    histogram: { edges_mm: [-0.05, -0.025, 0, 0.025, 0.05], area_mm2: [2, 398, 390, 10] },
    path: samplePath(),
  };
}

function samplePath() {
  const positions = [], kind = [], feed = [], rate = [], line = [], move = [], end = [];
  let time = 0;
  for (let row = 0; row <= 20; ++row)
    for (let step = 0; step <= 40; ++step) {
      const x = row % 2 ? 40 - step : step;
      positions.push(x, row, height(x, row));
      kind.push(row === 0 && step === 0 ? 0 : 1);
      feed.push(step < 3 ? 300 : 1200);
      rate.push(50 + 50 * Math.sin(x));
      line.push(row + 1);
      move.push(line.length - 1);
      end.push((time += 0.05));
    }
  return {
    moves: line.length, within_mm: 0, start_mm: [0, 0, 20],
    positions: Float32Array.from(positions), kind: Uint8Array.from(kind),
    feed_mm_min: Float32Array.from(feed), rate_mm3_min: Float32Array.from(rate),
    line: Uint32Array.from(line), move: Uint32Array.from(move), end_s: Float32Array.from(end),
  };
}
