import vtkDataArray from '@kitware/vtk.js/Common/Core/DataArray';
import vtkPlane from '@kitware/vtk.js/Common/DataModel/Plane';
import vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData';
import vtkActor from '@kitware/vtk.js/Rendering/Core/Actor';
import vtkMapper from '@kitware/vtk.js/Rendering/Core/Mapper';

import { pathGeometry, TRAIT_COMPONENTS, vertexColours } from './geometry.js';

const DASH_PIXELS = 9;
/** In parts of the depth range: enough to lift a line off the surface that it was cut along. */
const LIFT = 6e-5;

/**
 * The lines of a path. Its geometry goes to the graphics card once; which part of it is seen is two
 * numbers that the shader is told before each drawing.
 */
export function createPathActor(path) {
  const { points, traits, lines } = pathGeometry(path);
  const data = vtkPolyData.newInstance();
  data.getPoints().setData(points, 3);
  data.getLines().setData(lines);
  data.getPointData().addArray(
    vtkDataArray.newInstance({ name: 'trait', numberOfComponents: TRAIT_COMPONENTS, values: traits }));

  const shown = { from_s: 0, to_s: Infinity, rapids: true };
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
  actor.getProperty().setLineWidth(1);

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
    /** Shows only what stands on one side of a plane across an axis; all of it for null. */
    setSection(section) {
      mapper.removeAllClippingPlanes();
      if (section) mapper.addClippingPlane(sectionPlane(section));
    },
    /** What is seen: machining time in s, and whether rapids are. Takes effect with the next drawing. */
    setShown: (part) => Object.assign(shown, part),
    uploads: () => uploads,
  };
}

function sectionPlane({ axis, offset_mm, flip }) {
  const unit = [0, 1, 2].map((i) => (i === axis ? 1 : 0));
  return vtkPlane.newInstance({
    origin: unit.map((c) => c * offset_mm), normal: unit.map((c) => (flip ? c : -c)),
  });
}

function setUniforms(shown, cells, renderer) {
  const program = cells.getProgram();
  const set = (name, value) => program.isUniformUsed(name) && program.setUniformf(name, value);
  set('pathFrom', shown.from_s);
  set('pathTo', Math.min(shown.to_s, 3e38));
  set('pathRapids', shown.rapids ? 1 : 0);
  set('pathDash', DASH_PIXELS * pixelSize(renderer));
}

/** What a pixel is in mm where the camera looks at. */
function pixelSize(renderer) {
  const camera = renderer.getActiveCamera();
  const [, height] = renderer.getRenderWindow().getViews()[0].getViewportSize(renderer);
  const seen = camera.getParallelProjection()
    ? 2 * camera.getParallelScale()
    : 2 * camera.getDistance() * Math.tan((camera.getViewAngle() * Math.PI) / 360);
  return seen / Math.max(height, 1);
}

function shaderReplacements() {
  const replace = (shaderType, originalValue, lines) => ({
    shaderType, originalValue, replaceFirst: true, replaceAll: false,
    replacementValue: [originalValue, ...lines].join('\n'),
  });
  return [
    replace('Vertex', '//VTK::Camera::Dec', ['attribute vec3 traitMC;', 'varying vec3 traitVSOutput;']),
    replace('Vertex', '//VTK::Light::Impl',
      ['  traitVSOutput = traitMC;', `  gl_Position.z -= ${2 * LIFT} * gl_Position.w;`]),
    replace('Fragment', '//VTK::Color::Dec', [
      'varying vec3 traitVSOutput;',
      'uniform float pathFrom;', 'uniform float pathTo;', 'uniform float pathRapids;', 'uniform float pathDash;',
    ]),
    replace('Fragment', '//VTK::Color::Impl', [
      '  if (traitVSOutput.x < pathFrom || traitVSOutput.x > pathTo) discard;',
      '  if (traitVSOutput.y < 0.5 && (pathRapids < 0.5 || fract(traitVSOutput.z / pathDash) > 0.55)) discard;',
    ]),
  ];
}
