/**
 * The colours of a deviation map, the same as in the report's pictures (reports/picture/deviation_scale):
 * ColorBrewer's RdBu, material left red, cut too deep blue, nearly white on the surface. Each side of
 * zero has its own full scale; where it has a gate limit, the limit stands in its middle and the colour
 * jumps there.
 */
export const ZERO = [247, 247, 247];
/** Inside the limit, outwards; then beyond it, outwards. */
export const UNCUT = [[253, 219, 199], [244, 165, 130], [214, 96, 77], [178, 24, 43], [103, 0, 31]];
export const GOUGE = [[209, 229, 240], [146, 197, 222], [67, 147, 195], [33, 102, 172], [5, 48, 97]];
/** Inside both limits where the in-tolerance band is shown as one. */
export const BAND = [205, 207, 210];

const FINEST_SCALE_MM = 1e-6;

/** The next of 1, 2, 5 times a power of ten. */
export function roundedUp(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  for (const step of [1, 2, 5]) if (value <= step * power * (1 + 1e-9)) return step * power;
  return 10 * power;
}

/**
 * One side of a scale.
 * @param {number|undefined} limit_mm the gate's limit, undefined where there is none
 * @param {number} measured_mm the largest deviation on this side
 */
export function gateSide(limit_mm, measured_mm) {
  if (limit_mm > 0) {
    const beyond = measured_mm > 2 * limit_mm ? roundedUp(measured_mm) : 0;
    return { limit_mm, end_mm: Math.max(2 * limit_mm, beyond), hasLimit: true };
  }
  return plainSide(roundedUp(Math.max(measured_mm, FINEST_SCALE_MM)));
}

const plainSide = (end_mm) => ({ limit_mm: end_mm / 2, end_mm, hasLimit: false });

/** A side that ends where the reader says; the limit keeps its jump while it lies inside. */
function ownSide(limit_mm, end_mm) {
  if (limit_mm > 0 && limit_mm < end_mm) return { limit_mm, end_mm, hasLimit: true };
  return plainSide(Math.max(end_mm, FINEST_SCALE_MM));
}

/**
 * @param {object} stage of the report
 * @param {{range: 'gate'|'measured'|'own', ownGouge_mm?: number, ownUncut_mm?: number}} choice
 * @returns {{gouge: object, uncut: object}} the two sides
 */
export function scaleFor(stage, choice = { range: 'gate' }) {
  const { limits } = stage;
  const gouge = stage.gouge_mm?.high ?? 0, uncut = stage.uncut_mm?.high ?? 0;
  if (choice.range === 'measured') {
    const both = gateSide(undefined, Math.max(gouge, uncut));
    return { gouge: both, uncut: both };
  }
  if (choice.range === 'own')
    return {
      gouge: ownSide(limits?.gouge_mm, choice.ownGouge_mm),
      uncut: ownSide(limits?.uncut_mm, choice.ownUncut_mm),
    };
  return { gouge: gateSide(limits?.gouge_mm, gouge), uncut: gateSide(limits?.uncut_mm, uncut) };
}

function positionOn(side, size_mm) {
  if (size_mm <= side.limit_mm) return (0.5 * size_mm) / side.limit_mm;
  return Math.min(1, 0.5 + (0.5 * (size_mm - side.limit_mm)) / (side.end_mm - side.limit_mm));
}

/** -1 at the full scale of gouge, 0 at zero, 1 at the full scale of uncut; clamped. */
export function position(scale, deviation_mm) {
  return deviation_mm < 0
    ? -positionOn(scale.gouge, -deviation_mm)
    : positionOn(scale.uncut, deviation_mm);
}

const between = (a, b, t) => [0, 1, 2].map((k) => a[k] + (b[k] - a[k]) * t);
const bend = (a, b, c, t) => (t < 0.5 ? between(a, b, 2 * t) : between(b, c, 2 * t - 1));

/** Colour at `t` in [0, 1] along a side; with a limit it jumps at one half, which itself still passes. */
function along(ramp, t, hasLimit) {
  if (t <= 0.5) return bend(ZERO, ramp[0], ramp[1], 2 * t);
  if (hasLimit) return bend(ramp[2], ramp[3], ramp[4], 2 * t - 1);
  const s = (2 * t - 1) * 3;
  const i = Math.min(2, Math.floor(s));
  return between(ramp[1 + i], ramp[2 + i], s - i);
}

/**
 * Red, green, blue from 0 to 255.
 * @param {boolean} [band] one grey for what lies inside a limit
 */
export function colour(scale, deviation_mm, band = false) {
  const side = deviation_mm < 0 ? scale.gouge : scale.uncut;
  const t = positionOn(side, Math.abs(deviation_mm));
  if (band && side.hasLimit && t <= 0.5) return BAND;
  return along(deviation_mm < 0 ? GOUGE : UNCUT, t, side.hasLimit);
}

/** Places that a legend names, ascending: both ends, both limits, zero. */
export function ticks_mm(scale) {
  return [-scale.gouge.end_mm, -scale.gouge.limit_mm, 0, scale.uncut.limit_mm, scale.uncut.end_mm];
}

export const css = ([r, g, b]) => `rgb(${Math.round(r)}, ${Math.round(g)}, ${Math.round(b)})`;
