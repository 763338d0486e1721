import { lazily } from './lazy.js';

/**
 * The simulated stock of a stage, each array unpacked when it is first asked for. `cells` are its triangles
 * as a picker has cells, the last corner twice; `maker`, `move` and `line` are one a triangle.
 * @param {object} json {position, triangle, maker, move, line, within_mm, checked, surface_triangles}
 * @param {import('./blocks.js').Blob32} blob
 */
export function decodeStock(json, blob) {
  const { position, triangle, maker, move, line, ...rest } = json;
  for (const block of [position.block, triangle, maker, move, line]) blob.check(block);
  const count = triangle.count / 3;
  if ([maker, move, line].some((block) => block.count !== count))
    throw new Error('the page’s data have another number of makers than of triangles');
  return lazily({ ...rest, triangles: count }, {
    positions: () => blob.multiples(position.block, position.step_mm),
    corners: () => Uint32Array.from(blob.numbers(triangle)),
    maker: () => blob.numbers(maker),
    move: () => blob.numbers(move),
    line: () => blob.numbers(line),
    cells() {
      const cells = new Uint32Array(4 * count);
      for (let k = 0; k < count; ++k) {
        const [a, b, c] = this.corners.subarray(3 * k, 3 * k + 3);
        cells.set([a, b, c, c], 4 * k);
      }
      return cells;
    },
  });
}
