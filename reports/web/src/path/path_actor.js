import vtkDataArray from '@kitware/vtk.js/Common/Core/DataArray';
import vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData';
import vtkActor from '@kitware/vtk.js/Rendering/Core/Actor';
import vtkMapper from '@kitware/vtk.js/Rendering/Core/Mapper';

import { pathGeometry, TRAIT_COMPONENTS, vertexColours } from './geometry.js';

const DASH_PIXELS = 9;
/** Of the depth's range of two: lifts a line off the surface that it was cut along. */
const LIFT = 5e-4;
/** Lines of two pixels are drawn four times: too slow without a graphics card where there are many. */
const MOST_WIDE = 8000;
const EVERYWHERE = [0, 0, 0, 1];

/**
 * The lines of a path. Its geometry goes to the graphics card once; which part of it is seen is two
 * numbers that the shader is told before each drawing.
 * @param {() => number} heightOf the picture in CSS pixels
 */
export function createPathActor(path, heightOf) {
  const { points, traits, lines } = pathGeometry(path);
  const data = vtkPolyData.newInstance();
  data.getPoints().setData(points, 3);
  data.getLines().setData(lines);
  data.getPointData().addArray(
    vtkDataArray.newInstance({ name: 'trait', numberOfComponents: TRAIT_COMPONENTS, values: traits }));

  const shown = { from_s: 0, to_s: Infinity, rapids: true, veil: false, plane: EVERYWHERE, heightOf };
  const mapper = vtkMapper.newInstance();
  mapper.setInputData(data);
  mapper.setColorModeToDirectScalars();
  mapper.setScalarModeToUsePointData();
  mapper.setCustomShaderAttributes(['trait']);
  mapper.setViewSpecificProperties({
    OpenGL: { ShaderReplacements: shaderReplacements() },
    ShadersCallbacks: [{ userData: shown, callback: setUniforms }],
  });
  const actor = vtkActor.newInstance();
  actor.setMapper(mapper);
  actor.setPickable(false);
  actor.getProperty().setLighting(false);
  actor.getProperty().setLineWidth(path.end_s.length > MOST_WIDE ? 1 : 2);

  let uploads = 0;
  return {
    actor,
    /** Colours every segment anew: the one thing that sends data to the graphics card again. */
    setColours(colourOf) {
      const values = vertexColours(path.end_s.length, colourOf);
      data.getPointData().setScalars(
        vtkDataArray.newInstance({ name: 'colour', numberOfComponents: 3, values }));
      data.modified();
      uploads += 1;
    },
    /**
     * What is seen: from_s to to_s, rapids or not, every other pixel where there is a veil, and the side
     * of `plane` ([x, y, z, offset]) where it is not negative. Takes effect with the next drawing.
     */
    setShown: (part) => Object.assign(shown, part),
    uploads: () => uploads,
  };
}

function setUniforms(shown, cells, renderer) {
  const program = cells.getProgram();
  program.setUniformf('pathFrom', shown.from_s);
  program.setUniformf('pathTo', Math.min(shown.to_s, 3e38));
  program.setUniformf('pathRapids', shown.rapids ? 1 : 0);
  program.setUniformf('pathVeil', shown.veil ? 1 : 0);
  program.setUniformf('pathDash', DASH_PIXELS * pixelSize(renderer.getActiveCamera(), shown.heightOf()));
  program.setUniform4f('pathPlane', ...inVertices(shown.plane, cells.getCABO()));
}

/** What a pixel is in mm where the camera looks at. */
function pixelSize(camera, height) {
  const seen = camera.getParallelProjection()
    ? 2 * camera.getParallelScale()
    : 2 * camera.getDistance() * Math.tan((camera.getViewAngle() * Math.PI) / 360);
  return seen / Math.max(height, 1);
}

/** A plane in mm for the vertices as vtk.js keeps them: it shifts and scales those of large bodies. */
export function inVertices(plane, buffer) {
  if (!buffer.getCoordShiftAndScaleEnabled()) return plane;
  const shift = buffer.getCoordShift(), scale = buffer.getCoordScale();
  const [x, y, z, offset] = plane;
  return [x / scale[0], y / scale[1], z / scale[2], offset + x * shift[0] + y * shift[1] + z * shift[2]];
}

function shaderReplacements() {
  const replace = (shaderType, originalValue, lines) => ({
    shaderType, originalValue, replaceFirst: true, replaceAll: false,
    replacementValue: [originalValue, ...lines].join('\n'),
  });
  return [
    replace('Vertex', '//VTK::Camera::Dec', [
      'attribute vec3 traitMC;', 'varying vec3 traitVSOutput;', 'varying float sideVSOutput;',
      'uniform vec4 pathPlane;',
    ]),
    replace('Vertex', '//VTK::Light::Impl', [
      '  traitVSOutput = traitMC;',
      '  sideVSOutput = dot(pathPlane.xyz, vertexMC.xyz) + pathPlane.w;',
      `  gl_Position.z -= ${LIFT} * gl_Position.w;`,
    ]),
    replace('Fragment', '//VTK::Color::Dec', [
      'varying vec3 traitVSOutput;', 'varying float sideVSOutput;',
      'uniform float pathFrom;', 'uniform float pathTo;', 'uniform float pathRapids;',
      'uniform float pathDash;', 'uniform float pathVeil;',
    ]),
    replace('Fragment', '//VTK::Color::Impl', [
      '  if (sideVSOutput < 0.0) discard;',
      '  if (traitVSOutput.x < pathFrom || traitVSOutput.x > pathTo) discard;',
      '  bool gap = pathRapids < 0.5 || fract(traitVSOutput.z / pathDash) > 0.55;',
      '  if (traitVSOutput.y < 0.5 && gap) discard;',
      // Blending would have the whole scene drawn again.
      '  if (pathVeil > 0.5 && mod(floor(gl_FragCoord.x) + floor(gl_FragCoord.y), 2.0) < 0.5) discard;',
    ]),
  ];
}
