import { BAND, GOUGE, UNCUT, ZERO } from './colour_scale.js';

const vec3 = (rgb) => `vec3(${rgb.map((c) => (c / 255).toFixed(6)).join(', ')})`;
const ramp = (name, colours) =>
  `const vec3 ${name}[5] = vec3[5](${colours.map(vec3).join(', ')});`;

/**
 * colour_scale.js for the graphics card: `vec3 deviationColour(float mm)`, worked out pixel by pixel, so
 * that the jump at a limit is as sharp as the picture. Uniforms: `scaleGouge`, `scaleUncut` (limit, end,
 * 1 with a limit), `bandShown`.
 */
export const COLOUR_GLSL = `
uniform vec3 scaleGouge;
uniform vec3 scaleUncut;
uniform float bandShown;
const vec3 rampZero = ${vec3(ZERO)};
const vec3 bandColour = ${vec3(BAND)};
${ramp('rampGouge', GOUGE)}
${ramp('rampUncut', UNCUT)}
vec3 bend(vec3 a, vec3 b, vec3 c, float t) {
  return t < 0.5 ? mix(a, b, 2.0 * t) : mix(b, c, 2.0 * t - 1.0);
}
vec3 alongRamp(vec3 ramp[5], vec3 side, float size) {
  if (size <= side.x) {
    if (bandShown > 0.5 && side.z > 0.5) return bandColour;
    return bend(rampZero, ramp[0], ramp[1], size / side.x);
  }
  float t = min(1.0, (size - side.x) / (side.y - side.x));
  if (side.z > 0.5) return bend(ramp[2], ramp[3], ramp[4], t);
  if (t < 1.0 / 3.0) return mix(ramp[1], ramp[2], 3.0 * t);
  if (t < 2.0 / 3.0) return mix(ramp[2], ramp[3], 3.0 * t - 1.0);
  return mix(ramp[3], ramp[4], 3.0 * t - 2.0);
}
vec3 deviationColour(float mm) {
  return mm < 0.0 ? alongRamp(rampGouge, scaleGouge, -mm) : alongRamp(rampUncut, scaleUncut, mm);
}
`;

/** A side as the shader takes it. */
export const sideUniform = (side) => [side.limit_mm, side.end_mm, side.hasLimit ? 1 : 0];
