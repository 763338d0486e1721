import { COLOUR_GLSL } from '../colour/colour_shader.js';

const VERTEX_DECLARATIONS = `
attribute float deviationMC;
attribute float unreachableMC;
attribute vec2 placeMC;
varying float deviationVS;
varying float unreachableVS;
varying vec2 placeVS;
varying vec3 pointVS;
//VTK::Color::Dec`;

const VERTEX_CODE = `
deviationVS = deviationMC;
unreachableVS = unreachableMC;
placeVS = placeMC;
pointVS = vertexMC.xyz;
//VTK::Color::Impl`;

const FRAGMENT_DECLARATIONS = `
varying float deviationVS;
varying float unreachableVS;
varying vec2 placeVS;
varying vec3 pointVS;
uniform float mapShown;
uniform vec4 borderColour;
uniform vec3 backColour;
uniform float pixelRatio;
uniform vec4 sectionPlane;
${COLOUR_GLSL}
//VTK::Color::Dec`;

/** Stripes of screen pixels, as in a drawing: they keep their width at every distance. */
const HATCH = `
  if (unreachableVS > 0.5) {
    float stripe = mod((gl_FragCoord.x + gl_FragCoord.y) / pixelRatio, 9.0);
    map = stripe < 3.2 ? vec3(0.46, 0.47, 0.49) : vec3(0.74, 0.75, 0.76);
  }`;

/** Distance to the patch's border in pixels; the patch beside draws the other half of the line. */
const BORDERS = `
  vec2 toBorder = min(placeVS, 1.0 - placeVS) / max(fwidth(placeVS), vec2(1e-9));
  float line = 1.0 - smoothstep(0.15, 0.8, min(toBorder.x, toBorder.y) / pixelRatio);`;

const FRAGMENT_CODE = `
${BORDERS}
  if (dot(sectionPlane.xyz, pointVS) + sectionPlane.w < 0.0) discard;
//VTK::Color::Impl
  vec3 map = mapShown > 0.5 ? deviationColour(deviationVS) : vec3(0.80, 0.81, 0.83);
  if (mapShown > 0.5) { ${HATCH} }
  map = mix(map, borderColour.rgb, line * borderColour.a);
  if (gl_FrontFacing == false) map = mix(backColour, borderColour.rgb, 0.5 * line * borderColour.a);
  ambientColor = map;
  diffuseColor = map;`;

/** What is put into vtk.js' shaders to colour a surface pixel by pixel. */
export const SURFACE_REPLACEMENTS = [
  ['Vertex', '//VTK::Color::Dec', VERTEX_DECLARATIONS],
  ['Vertex', '//VTK::Color::Impl', VERTEX_CODE],
  ['Fragment', '//VTK::Color::Dec', FRAGMENT_DECLARATIONS],
  ['Fragment', '//VTK::Color::Impl', FRAGMENT_CODE],
].map(([shaderType, originalValue, replacementValue]) => ({
  shaderType, originalValue, replacementValue, replaceFirst: true, replaceAll: false,
}));
