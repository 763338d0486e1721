import { pointAt } from '../../base/vector.js';

/**
 * Where a plane square to an axis cuts a surface: one piece for each triangle it passes.
 * @param {{positions, cells}} surface
 * @param {Float32Array} deviation_mm of the samples
 * @param {0|1|2} axis that the plane is square to
 * @param {number} offset_mm place of the plane on that axis
 * @returns {{from: number[], to: number[], deviation_mm: [number, number], corners: number[]}[]}
 *   points in mm with the deviations there, and the triangle
 */
export function cutCurve({ positions, cells }, deviation_mm, axis, offset_mm) {
  const pieces = [];
  for (let at = 0; at < cells.length; at += 4) {
    const a = cells[at], b = cells[at + 1], c = cells[at + 2], d = cells[at + 3];
    const above = positions[3 * a + axis] >= offset_mm;
    if (above === positions[3 * b + axis] >= offset_mm && above === positions[3 * c + axis] >= offset_mm
      && above === positions[3 * d + axis] >= offset_mm) continue;
    for (const corners of [[a, b, c], [a, c, d]]) {
      const piece = cutTriangle(positions, deviation_mm, corners, axis, offset_mm);
      if (piece) pieces.push(piece);
    }
  }
  return pieces;
}

function cutTriangle(positions, deviation_mm, corners, axis, offset_mm) {
  const ends = [];
  for (let k = 0; k < 3; ++k) {
    const p = corners[k], q = corners[(k + 1) % 3];
    const from = positions[3 * p + axis], to = positions[3 * q + axis];
    // Half open, so that a corner in the plane belongs to one side and a curve has no gaps.
    if (from >= offset_mm === to >= offset_mm) continue;
    const t = (offset_mm - from) / (to - from);
    const a = pointAt(positions, p), b = pointAt(positions, q);
    const point = [0, 1, 2].map((i) => (i === axis ? offset_mm : a[i] + (b[i] - a[i]) * t));
    ends.push({ point, deviation: deviation_mm[p] + (deviation_mm[q] - deviation_mm[p]) * t });
  }
  if (ends.length !== 2) return null;
  return {
    from: ends[0].point, to: ends[1].point,
    deviation_mm: [ends[0].deviation, ends[1].deviation], corners,
  };
}

/** Axes that a section's profile is drawn over: along, and up. */
export const profileAxes = (axis) => [[1, 2], [0, 2], [0, 1]][axis];

/**
 * How many times a deviation must be magnified to be seen: the largest that stays below a share of the
 * part's size, of 1, 2, 5 times a power of ten.
 */
export function magnification(largest_mm, size_mm, share = 0.06) {
  if (!(largest_mm > 0)) return 1;
  const wanted = (share * size_mm) / largest_mm;
  if (wanted < 1) return 1;
  const power = 10 ** Math.floor(Math.log10(wanted));
  return [5, 2, 1].find((step) => step * power <= wanted * (1 + 1e-9)) * power;
}
