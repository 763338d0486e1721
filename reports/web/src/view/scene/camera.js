import { add, dot, scaled, subtract } from '../../base/vector.js';

/**
 * A camera that turns about Z like a part on a table. Plain values, angles in degrees:
 * `azimuth` of the eye about Z from +X, `elevation` above the XY plane, `focal` (mm) the point in the
 * middle of the picture, `scale` (mm) half the picture's height there, `perspective` or parallel.
 */
export const VIEWS = {
  top: { azimuth: -90, elevation: 90, perspective: false },
  front: { azimuth: -90, elevation: 0, perspective: false },
  right: { azimuth: 0, elevation: 0, perspective: false },
  perspective: { azimuth: -62, elevation: 38, perspective: true },
  below: { azimuth: -62, elevation: -38, perspective: true },
  bottom: { azimuth: -90, elevation: -90, perspective: false },
};

/** The first look at a stage: from above, or from below where the tool comes from there. */
export const firstView = ({ setup }) => (setup && setup.rotation[2][2] < -0.3 ? 'below' : 'perspective');

export const HALF_ANGLE_DEG = 12;
const radians = (degrees) => (degrees * Math.PI) / 180;
/** Eye to focal point per scale, in perspective. */
const REACH = 1 / Math.tan(radians(HALF_ANGLE_DEG));

/** Directions of the picture: `right`, `up`, and `back` from the focal point to the eye. */
export function axes({ azimuth, elevation }) {
  const a = radians(azimuth), e = radians(elevation);
  const [ca, sa, ce, se] = [Math.cos(a), Math.sin(a), Math.cos(e), Math.sin(e)];
  return { right: [-sa, ca, 0], up: [-se * ca, -se * sa, ce], back: [ce * ca, ce * sa, se] };
}

/** Eye's distance from the focal point, mm; a parallel camera stands off far enough to see all. */
export function eyeDistance(camera, size_mm) {
  return camera.perspective ? camera.scale * REACH : 4 * size_mm + camera.scale;
}

/** Place of a point in a picture of `width` x `height` pixels; `depth` grows towards the eye. */
export function project(camera, { width, height }, point) {
  const { right, up, back } = axes(camera);
  const from = subtract(point, camera.focal);
  const depth = dot(from, back);
  const distance = camera.scale * REACH;
  const shrink = camera.perspective ? distance / Math.max(distance - depth, 1e-9) : 1;
  const pixels = (shrink * height) / (2 * camera.scale);
  return {
    x: width / 2 + dot(from, right) * pixels,
    y: height / 2 - dot(from, up) * pixels,
    depth,
    visible: !camera.perspective || depth < distance,
  };
}

/** The ray through a pixel: `origin`, `direction` (not of unit length), away from the eye. */
export function ray(camera, { width, height }, x, y, size_mm) {
  const { right, up, back } = axes(camera);
  const pixel = (2 * camera.scale) / height;
  const inPlane = add(
    camera.focal,
    add(scaled(right, (x - width / 2) * pixel), scaled(up, (height / 2 - y) * pixel)),
  );
  const distance = eyeDistance(camera, size_mm);
  if (!camera.perspective)
    return { origin: add(inPlane, scaled(back, distance)), direction: scaled(back, -1) };
  const eye = add(camera.focal, scaled(back, distance));
  return { origin: eye, direction: subtract(inPlane, eye) };
}

/** Moved so that what lies under the pointer follows it by `dx`, `dy` pixels. */
export function panned(camera, { height }, dx, dy) {
  const { right, up } = axes(camera);
  const pixel = (2 * camera.scale) / height;
  const shift = add(scaled(right, -dx * pixel), scaled(up, dy * pixel));
  return { ...camera, focal: add(camera.focal, shift) };
}

/** Turned as a part under the hand, half a turn over the picture's height. */
export function turned(camera, { height }, dx, dy) {
  const perPixel = 180 / height;
  const elevation = Math.max(-90, Math.min(90, camera.elevation + dy * perPixel));
  return { ...camera, azimuth: camera.azimuth - dx * perPixel, elevation };
}

/** Magnified by `factor` about a pixel, within what a part of `size_mm` can need. */
export function zoomed(camera, size, factor, x, y, size_mm) {
  const scale = Math.min(3 * size_mm, Math.max(size_mm * 1e-5, camera.scale / factor));
  const applied = camera.scale / scale;
  const dx = (size.width / 2 - x) * (applied - 1), dy = (size.height / 2 - y) * (applied - 1);
  return panned({ ...camera, scale }, size, dx, dy);
}

/**
 * A camera with `view`'s directions that sees all of some points, as large as they go.
 * @param {number[][]} points mm; enough of them to stand for the part
 */
export function fitted(view, points, { width, height }) {
  const { right, up, back } = axes(view);
  const [across, along, deep] = [right, up, back].map((axis) => spanOn(axis, points));
  const focal = [[right, across], [up, along], [back, deep]]
    .reduce((sum, [axis, span]) => add(sum, scaled(axis, (span.low + span.high) / 2)), [0, 0, 0]);
  const aspect = width / Math.max(1, height);
  let scale = Math.max(half(along), half(across) / aspect, 1e-9) * MARGIN;
  // What is nearer than the focal point looks larger.
  if (view.perspective) scale *= 1 + half(deep) / (scale * REACH);
  return { ...view, focal, scale };
}

const MARGIN = 1.08;
const half = ({ low, high }) => (high - low) / 2;

function spanOn(axis, points) {
  let low = Infinity, high = -Infinity;
  for (const point of points) {
    const at = dot(axis, point);
    low = Math.min(low, at);
    high = Math.max(high, at);
  }
  return { low, high };
}

/** The corners of a box. */
export const corners = ([low, high]) =>
  Array.from({ length: 8 }, (_, k) => [0, 1, 2].map((axis) => ((k >> axis) & 1 ? high : low)[axis]));

const shortWay = (from, to) => from + ((((to - from) % 360) + 540) % 360) - 180;

/** Between two cameras, `t` from 0 to 1; scales in their ratio, angles the short way. */
export function between(from, to, t) {
  const azimuth = from.azimuth + (shortWay(from.azimuth, to.azimuth) - from.azimuth) * t;
  return {
    azimuth,
    elevation: from.elevation + (to.elevation - from.elevation) * t,
    focal: add(from.focal, scaled(subtract(to.focal, from.focal), t)),
    scale: from.scale * (to.scale / from.scale) ** t,
    perspective: t < 1 ? from.perspective : to.perspective,
  };
}

/** A camera that looks at a place about along its normal, never from below the part's own horizon. */
export function lookingAt(camera, point, normal, scale) {
  const flat = Math.hypot(normal[0], normal[1]);
  const steep = (Math.atan2(normal[2], flat) * 180) / Math.PI;
  const azimuth = flat > 0.25
    ? shortWay(camera.azimuth, (Math.atan2(normal[1], normal[0]) * 180) / Math.PI)
    : camera.azimuth;
  const elevation = Math.max(-80, Math.min(62, flat > 0.25 ? steep + 12 : 58 * Math.sign(normal[2] || 1)));
  return { ...camera, azimuth, elevation, focal: [...point], scale };
}
