import { beginning } from './timeline.js';

/** Numbers of a vertex for the shader: time (s), 1 for a feed move or 0, way along the rapids (mm). */
export const TRAIT_COMPONENTS = 3;

/**
 * The path as line segments, two vertices of its own each: time runs along a segment, so that a shader
 * can end the path inside it, while kind and colour stay the same on it.
 * @returns {{points: Float32Array, traits: Float32Array, lines: Uint32Array}} lines as VTK has cells:
 *   2, first vertex, second vertex, ...
 */
export function pathGeometry(path) {
  const count = path.end_s.length;
  const points = new Float32Array(6 * count);
  const traits = new Float32Array(2 * TRAIT_COMPONENTS * count);
  const lines = new Uint32Array(3 * count);
  let along = 0;
  for (let i = 0; i < count; ++i) {
    if (i === 0) points.set(path.start_mm, 0);
    else points.set(path.positions.subarray(3 * i - 3, 3 * i), 6 * i);
    points.set(path.positions.subarray(3 * i, 3 * i + 3), 6 * i + 3);
    const kind = path.kind[i] === 0 ? 0 : 1;
    const before = kind === 0 ? along : 0;
    along = kind === 0 ? before + segmentLength(points, 6 * i) : 0;
    traits.set([beginning(path, i), kind, before, path.end_s[i], kind, along], 2 * TRAIT_COMPONENTS * i);
    lines.set([2, 2 * i, 2 * i + 1], 3 * i);
  }
  return { points, traits, lines };
}

function segmentLength(points, at) {
  return Math.hypot(...[0, 1, 2].map((i) => points[at + 3 + i] - points[at + i]));
}

/**
 * A colour for each vertex of `pathGeometry`.
 * @param {(segment: number) => [number, number, number]} colourOf of a segment, from 0 to 255
 */
export function vertexColours(count, colourOf) {
  const colours = new Uint8Array(6 * count);
  for (let i = 0; i < count; ++i) {
    const colour = colourOf(i);
    colours.set(colour, 6 * i);
    colours.set(colour, 6 * i + 3);
  }
  return colours;
}
