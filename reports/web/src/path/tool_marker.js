import vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData';
import vtkActor from '@kitware/vtk.js/Rendering/Core/Actor';
import vtkMapper from '@kitware/vtk.js/Rendering/Core/Mapper';

import { cutterOutline, joined, shaftOutlines, standing, wireBody } from './cutter.js';
import { poseMatrix } from './pose.js';

/**
 * The cutter as a body of wires with its tip on the path: a see-through one would have the whole scene
 * drawn again for its sake. One that turns as it goes is drawn with its shank and holder.
 * @param {object} stage its `cutter`, a ball of `fallback_mm` where the data have none; its `setup`: how the
 *   tool stands, along Z where there is none; its `path`, which may turn the tool
 */
export function createToolMarker({ cutter, setup, path }, fallback_mm) {
  const turns = Boolean(path?.axis);
  const actor = vtkActor.newInstance();
  actor.setMapper(mapperOf(turns ? wholeTool(cutter, fallback_mm) : uprightTool(cutter, setup, fallback_mm)));
  actor.setPickable(false);
  actor.getProperty().setLighting(false);
  return {
    actor,
    setColour: (rgb) => actor.getProperty().setColor(...rgb.map((c) => c / 255)),
    /** To an `instant` of the path. A path's axes are in the part's frame, whatever the setup. */
    place({ point_mm, axis }) {
      if (turns) actor.setUserMatrix(poseMatrix(point_mm, axis));
      else actor.setPosition(...point_mm);
    },
    matrix: () => Array.from(actor.getMatrix()),
  };
}

function mapperOf({ points, lines }) {
  const data = vtkPolyData.newInstance();
  data.getPoints().setData(points, 3);
  data.getLines().setData(lines);
  const mapper = vtkMapper.newInstance({ scalarVisibility: false });
  mapper.setInputData(data);
  return mapper;
}

function cutterBody(cutter, fallback_mm) {
  const ball = { type: 'ball', diameter_mm: fallback_mm, corner_radius_mm: fallback_mm / 2,
    flute_length_mm: fallback_mm };
  return wireBody(cutterOutline(cutter) ?? cutterOutline(ball));
}

function uprightTool(cutter, setup, fallback_mm) {
  const { points, lines } = cutterBody(cutter, fallback_mm);
  return { points: setup ? standing(points, setup.rotation) : points, lines };
}

const wholeTool = (cutter, fallback_mm) =>
  joined([cutterBody(cutter, fallback_mm), ...shaftOutlines(cutter).map((outline) => wireBody(outline))]);
