import { pointAt } from '../../base/vector.js';

/** Cells a leaf; small enough that a ray tests few, large enough that the tree stays small. */
const LEAF_CELLS = 32;

/**
 * Finds where rays hit a surface, by a tree of boxes over its cells. Cells are taken as the two triangles
 * that are drawn, (a, b, c) and (a, c, d), so that what is found is what is seen.
 * @param {{positions: Float32Array, cells: Uint32Array}} surface as decodeReport gives it
 */
export function createPicker(surface) {
  const tree = buildTree(surface);
  return {
    /**
     * The first hit along a ray.
     * @param {{origin: number[], direction: number[]}} ray
     * @param {(point: number[]) => boolean} [shown] false for what a section plane takes away
     * @returns {{point_mm, corners: number[], weights: number[], cell: number}|null} three sample indices,
     *   weights sum 1; the cell that was hit
     */
    first: (ray, shown = () => true) => firstHit(surface, tree, ray, shown),
    nodes: tree.count,
  };
}

function cellBoxes({ positions, cells }) {
  const count = cells.length / 4;
  const boxes = new Float32Array(6 * count);
  for (let cell = 0; cell < count; ++cell)
    for (let axis = 0; axis < 3; ++axis) {
      let low = Infinity, high = -Infinity;
      for (let corner = 0; corner < 4; ++corner) {
        const value = positions[3 * cells[4 * cell + corner] + axis];
        if (value < low) low = value;
        if (value > high) high = value;
      }
      boxes[6 * cell + axis] = low;
      boxes[6 * cell + 3 + axis] = high;
    }
  return boxes;
}

/**
 * Cells come patch by patch and row by row; sorted along a Morton curve, runs of them are compact, and
 * a tree over equal runs needs no search for splits.
 */
function sortedCells(boxes) {
  const count = boxes.length / 6;
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let k = 0; k < boxes.length; k += 6)
    for (let axis = 0; axis < 3; ++axis) {
      low[axis] = Math.min(low[axis], boxes[k + axis]);
      high[axis] = Math.max(high[axis], boxes[k + 3 + axis]);
    }
  const spread = (v) => {
    let x = v & 1023;
    x = (x | (x << 16)) & 0x030000ff;
    x = (x | (x << 8)) & 0x0300f00f;
    x = (x | (x << 4)) & 0x030c30c3;
    return (x | (x << 2)) & 0x09249249;
  };
  // Key above, cell below, in one number: sorting a typed array needs no comparison function.
  const keyed = new Float64Array(count);
  for (let cell = 0; cell < count; ++cell) {
    let key = 0;
    for (let axis = 0; axis < 3; ++axis) {
      const middle = (boxes[6 * cell + axis] + boxes[6 * cell + 3 + axis]) / 2;
      const extent = high[axis] - low[axis] || 1;
      key |= spread(Math.min(1023, Math.floor(((middle - low[axis]) / extent) * 1024))) << axis;
    }
    keyed[cell] = key * count + cell;
  }
  keyed.sort();
  return Uint32Array.from(keyed, (value) => value % count);
}

function buildTree(surface) {
  const boxes = cellBoxes(surface);
  const order = sortedCells(boxes);
  const leaves = Math.max(1, 2 ** Math.ceil(Math.log2(order.length / LEAF_CELLS || 1)));
  const count = 2 * leaves;
  // Node 1 is the root, node n has children 2n and 2n + 1, leaves stand at the end.
  const nodes = new Float32Array(6 * count);
  for (let k = 0; k < nodes.length; ++k) nodes[k] = k % 6 < 3 ? Infinity : -Infinity;
  const grow = (node, array, at) => {
    for (let axis = 0; axis < 3; ++axis) {
      nodes[6 * node + axis] = Math.min(nodes[6 * node + axis], array[at + axis]);
      nodes[6 * node + 3 + axis] = Math.max(nodes[6 * node + 3 + axis], array[at + 3 + axis]);
    }
  };
  const start = (leaf) => Math.floor((leaf * order.length) / leaves);
  for (let leaf = 0; leaf < leaves; ++leaf)
    for (let k = start(leaf); k < start(leaf + 1); ++k) grow(leaves + leaf, boxes, 6 * order[k]);
  for (let node = leaves - 1; node >= 1; --node) {
    grow(node, nodes, 12 * node);
    grow(node, nodes, 12 * node + 6);
  }
  return { nodes, leaves, order, start, count };
}

/** Where a ray enters a box, infinite where it misses. */
function entry(nodes, node, origin, inverse) {
  let near = 0, far = Infinity;
  for (let axis = 0; axis < 3; ++axis) {
    const a = (nodes[6 * node + axis] - origin[axis]) * inverse[axis];
    const b = (nodes[6 * node + 3 + axis] - origin[axis]) * inverse[axis];
    // A ray in the plane of a face gives 0 times infinity there, which bounds nothing.
    if (Number.isNaN(a) || Number.isNaN(b)) continue;
    near = Math.max(near, Math.min(a, b));
    far = Math.min(far, Math.max(a, b));
  }
  return near <= far ? near : Infinity;
}

function firstHit(surface, tree, ray, shown) {
  const inverse = ray.direction.map((c) => 1 / c);
  const stack = [[1, entry(tree.nodes, 1, ray.origin, inverse)]];
  let best = null, nearest = Infinity;
  const leaf = (node) => {
    const index = node - tree.leaves;
    for (let k = tree.start(index); k < tree.start(index + 1); ++k)
      for (const corners of triangles(surface.cells, tree.order[k])) {
        const hit = hitTriangle(surface.positions, corners, ray);
        if (hit && hit.t < nearest && shown(hit.point_mm))
          [best, nearest] = [{ ...hit, cell: tree.order[k] }, hit.t];
      }
  };
  while (stack.length > 0) {
    const [node, near] = stack.pop();
    if (near >= nearest) continue;
    if (node >= tree.leaves) {
      leaf(node);
      continue;
    }
    const children = [2 * node, 2 * node + 1].map((n) => [n, entry(tree.nodes, n, ray.origin, inverse)]);
    children.sort((a, b) => b[1] - a[1]);
    stack.push(...children.filter(([, at]) => at < nearest));
  }
  return best && {
    point_mm: best.point_mm, corners: best.corners, weights: best.weights, cell: best.cell,
  };
}

function triangles(cells, cell) {
  const [a, b, c, d] = cells.subarray(4 * cell, 4 * cell + 4);
  return [[a, b, c], [a, c, d]];
}

/** Möller and Trumbore's test, from both sides. */
function hitTriangle(positions, corners, { origin, direction }) {
  const [a, b, c] = corners.map((k) => pointAt(positions, k));
  const ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
  const vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
  const [dx, dy, dz] = direction;
  const px = dy * vz - dz * vy, py = dz * vx - dx * vz, pz = dx * vy - dy * vx;
  const determinant = ux * px + uy * py + uz * pz;
  if (determinant === 0) return null;
  const sx = origin[0] - a[0], sy = origin[1] - a[1], sz = origin[2] - a[2];
  const beta = (sx * px + sy * py + sz * pz) / determinant;
  if (beta < 0 || beta > 1) return null;
  const qx = sy * uz - sz * uy, qy = sz * ux - sx * uz, qz = sx * uy - sy * ux;
  const gamma = (dx * qx + dy * qy + dz * qz) / determinant;
  if (gamma < 0 || beta + gamma > 1) return null;
  const t = (vx * qx + vy * qy + vz * qz) / determinant;
  if (t <= 0) return null;
  const point_mm = [origin[0] + t * dx, origin[1] + t * dy, origin[2] + t * dz];
  return { t, point_mm, corners, weights: [1 - beta - gamma, beta, gamma] };
}
