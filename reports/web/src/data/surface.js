import { lazily } from './lazy.js';

/**
 * A surface of the page's data with its positions, normals and cells, each worked out when first
 * asked for.
 * @param {object} json {patches: [{patch, columns, rows, measured?}], stride, position}
 * @param {import('./blocks.js').Blob32} blob
 */
export function decodeSurface(json, blob) {
  const { patches, stride, measured_samples, position } = json;
  const first = [];
  let samples = 0;
  for (const { columns, rows } of patches) {
    first.push(samples);
    samples += columns * rows;
  }
  if (blob.check(position.block).count !== 3 * samples)
    throw new Error('the page’s data have another number of positions than of samples');
  const surface = { patches, stride, measured_samples, step_mm: position.step_mm, samples, first };
  surface.place = (sample) => placeOf(sample, patches, first);
  return lazily(surface, {
    positions: () => blob.multiples(position.block, position.step_mm),
    normals: () => gridNormals(surface.positions, patches, first),
    cells: () => gridCells(patches, first),
  });
}

/** Which of `measured` lines the shown line `i` of `shown` is: as reports/page has it. */
function measuredIndex(i, shown, measured) {
  return Math.floor((2 * i * (measured - 1) + (shown - 1)) / (2 * (shown - 1)));
}

function parameter(i, shown, measured = shown) {
  return measuredIndex(i, shown, measured) / (measured - 1);
}

/** @returns {{patch: number, u: number, v: number}} where a sample lies */
function placeOf(sample, patches, first) {
  let low = 0, high = patches.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (first[middle] <= sample) low = middle;
    else high = middle;
  }
  const { patch, columns, rows, measured = [columns, rows] } = patches[low];
  const k = sample - first[low];
  return {
    patch,
    u: parameter(k % columns, columns, measured[0]),
    v: parameter(Math.floor(k / columns), rows, measured[1]),
  };
}

/** Four corners a cell, counter-clockwise from outside. */
function gridCells(patches, first) {
  const count = patches.reduce((sum, p) => sum + (p.columns - 1) * (p.rows - 1), 0);
  const cells = new Uint32Array(4 * count);
  let at = 0;
  patches.forEach(({ columns, rows }, p) => {
    for (let j = 0; j + 1 < rows; ++j)
      for (let i = 0; i + 1 < columns; ++i) {
        const corner = first[p] + j * columns + i;
        cells[at++] = corner;
        cells[at++] = corner + 1;
        cells[at++] = corner + columns + 1;
        cells[at++] = corner + columns;
      }
  });
  return cells;
}

/** Unit normals, outward, from differences along the grids: of second order at the borders, too. */
function gridNormals(positions, patches, first) {
  const normals = new Float32Array(positions.length);
  const du = [0, 0, 0], dv = [0, 0, 0];
  patches.forEach(({ columns, rows }, p) => {
    for (let j = 0; j < rows; ++j)
      for (let i = 0; i < columns; ++i) {
        const at = first[p] + j * columns + i;
        difference(positions, at, i, columns, 1, du);
        difference(positions, at, j, rows, columns, dv);
        setNormal(normals, 3 * at, du, dv);
      }
    fillNormals(normals, 3 * first[p], 3 * (first[p] + columns * rows));
  });
  return normals;
}

/**
 * Where a grid has shrunk to a point, as at the tips of a triangle, differences give no normal: it is that
 * of the sample before, or else of the first one behind; upwards where the whole grid has shrunk.
 */
function fillNormals(normals, from, to) {
  const isZero = (at) => normals[at] === 0 && normals[at + 1] === 0 && normals[at + 2] === 0;
  let known = from;
  while (known < to && isZero(known)) known += 3;
  if (known === to) normals.set([0, 0, 1], known = from);
  for (let at = from; at < to; at += 3) {
    if (isZero(at)) normals.copyWithin(at, known, known + 3);
    else known = at;
  }
}

/** Derivative along a grid line, times an even number of steps that is left out of account. */
function difference(positions, at, i, count, step, out) {
  const p = 3 * at, s = 3 * step;
  for (let c = p, k = 0; k < 3; ++c, ++k) {
    if (i > 0 && i + 1 < count) out[k] = positions[c + s] - positions[c - s];
    else if (count === 2) out[k] = i === 0 ? positions[c + s] - positions[c] : positions[c] - positions[c - s];
    else if (i === 0) out[k] = 4 * positions[c + s] - 3 * positions[c] - positions[c + 2 * s];
    else out[k] = 3 * positions[c] - 4 * positions[c - s] + positions[c - 2 * s];
  }
}

function setNormal(normals, at, du, dv) {
  const x = du[1] * dv[2] - du[2] * dv[1];
  const y = du[2] * dv[0] - du[0] * dv[2];
  const z = du[0] * dv[1] - du[1] * dv[0];
  const length = Math.hypot(x, y, z);
  if (!(length > 0)) return;
  normals[at] = x / length;
  normals[at + 1] = y / length;
  normals[at + 2] = z / length;
}
