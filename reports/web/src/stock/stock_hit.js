import { cross, dot, pointAt, subtract } from '../base/vector.js';

/**
 * Where a ray meets the stock as it is seen: on its surface, or, where a section has taken the surface away and
 * the ray meets what is left from within, on the section's plane.
 * @param {object} picker of the stock
 * @param {number[]} plane [x, y, z, offset], not negative where the stock is kept
 * @returns {{point_mm, cell: number|null}|null} no cell on the plane
 */
export function stockHit(stock, picker, plane, ray) {
  const side = (point) => dot(plane, point) + plane[3];
  const hit = picker.first(ray, (point) => side(point) >= 0);
  if (!hit || !isFromWithin(stock, hit.cell, ray.direction)) return hit && { point_mm: hit.point_mm, cell: hit.cell };
  const along = dot(plane, ray.direction);
  if (along === 0) return { point_mm: hit.point_mm, cell: hit.cell };
  const t = -side(ray.origin) / along;
  return { point_mm: ray.origin.map((c, k) => c + t * ray.direction[k]), cell: null };
}

function isFromWithin({ positions, cells }, cell, direction) {
  const [a, b, c] = [0, 1, 2].map((k) => pointAt(positions, cells[4 * cell + k]));
  return dot(cross(subtract(b, a), subtract(c, a)), direction) > 0;
}
