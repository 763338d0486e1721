import { add, cross, dot, length, scaled } from '../base/vector.js';

/**
 * How the tool stands along a path that turns it. `path.axis` is what `decodeReport` gives: the direction
 * from the tip to the spindle at the end of each segment (`x`, `y`, `z`) and at the path's beginning
 * (`start`).
 */

/** Below it two directions are as good as one, or as opposite, mm/mm. */
const NO_TURN = 1e-9;

const unit = (a) => scaled(a, 1 / length(a));

/** The tool's axis where segment `index` ends, of length 1; its beginning is the end of the one before. */
export function endAxis({ axis }, index) {
  return unit(index < 0 ? axis.start : [axis.x[index], axis.y[index], axis.z[index]]);
}

/**
 * The direction at `share` (0 to 1) of the way from `a` to `b`, along the great circle through both.
 * Between opposite ones there is no such circle: then that of the nearer end.
 */
export function turnedAxis(a, b, share) {
  const across = length(cross(a, b)), along = dot(a, b);
  if (across < NO_TURN) return share < 0.5 && along < 0 ? a : b;
  const angle = Math.atan2(across, along);
  return unit(add(scaled(a, Math.sin((1 - share) * angle)), scaled(b, Math.sin(share * angle))));
}

/** How far the tool leans from +Z, degrees. */
export const leanDegrees = ([x, y, z]) => (Math.atan2(Math.hypot(x, y), z) * 180) / Math.PI;

/**
 * Puts an upright body with its tip at the origin to where `point_mm` is its tip and `axis` its axis, by the
 * least turn: 16 numbers, column after column, as graphics libraries have them.
 */
export function poseMatrix(point_mm, [x, y, z]) {
  // Columns are the images of X, Y and Z; straight down it is turned over about X.
  const share = 1 / (1 + z);
  const [right, ahead] = z < -1 + NO_TURN
    ? [[1, 0, 0], [0, -1, 0]]
    : [[1 - x * x * share, -x * y * share, -x], [-x * y * share, 1 - y * y * share, -y]];
  return [...right, 0, ...ahead, 0, x, y, z, 0, ...point_mm, 1];
}
