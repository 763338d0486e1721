import { lazily } from './lazy.js';

/**
 * A fixture where it stands about the part, its arrays unpacked when they are first asked for.
 * @param {object} json {name, position, triangle, file_triangles}
 * @param {import('./blocks.js').Blob32} blob
 */
export function decodeFixture({ position, triangle, ...rest }, blob) {
  for (const block of [position.block, triangle]) blob.check(block);
  return lazily({ ...rest, triangles: triangle.count / 3 }, {
    positions: () => blob.multiples(position.block, position.step_mm),
    corners: () => Uint32Array.from(blob.numbers(triangle)),
  });
}
