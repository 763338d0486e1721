/** Surfaces below this many cells are never slow. */
const FEW_CELLS = 20000;

/**
 * A surface with fewer samples, to be shown while it moves where drawing all of it is slow.
 * @param {object} surface of the report, decoded
 * @returns {{surface: object, samples: Uint32Array}|null} the surface, and which sample each of its samples
 *   is; null where there is nothing to gain
 */
export function coarsened(surface) {
  const step = Math.ceil(Math.sqrt(surface.cells.length / 4 / FEW_CELLS));
  if (step < 2) return null;
  const samples = [], cells = [], first = [], patches = [], u = [], v = [];
  surface.patches.forEach(({ columns, rows }, patch) => {
    const across = picked(columns, step), along = picked(rows, step);
    const base = samples.length;
    first.push(base);
    patches.push({ columns: across.length, rows: along.length });
    along.forEach((row, j) => across.forEach((column, i) => {
      samples.push(surface.first[patch] + row * columns + column);
      u.push(column / (columns - 1));
      v.push(row / (rows - 1));
      const a = base + j * across.length + i;
      if (i > 0 && j > 0) cells.push(a - across.length - 1, a - across.length, a, a - 1);
    }));
  });
  return {
    samples: Uint32Array.from(samples),
    surface: {
      patches, first, cells: Uint32Array.from(cells), u, v,
      positions: gathered(surface.positions, samples, 3), normals: gathered(surface.normals, samples, 3),
    },
  };
}

/** Every step-th index and always the last, so that patches keep their borders. */
function picked(count, step) {
  const indices = [];
  for (let k = 0; k < count - 1; k += step) indices.push(k);
  indices.push(count - 1);
  return indices;
}

/** The values of chosen samples. */
export function gathered(values, samples, components = 1) {
  const out = new values.constructor(samples.length * components);
  for (let k = 0; k < samples.length; ++k)
    for (let c = 0; c < components; ++c) out[components * k + c] = values[components * samples[k] + c];
  return out;
}
