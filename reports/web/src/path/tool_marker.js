import vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData';
import vtkActor from '@kitware/vtk.js/Rendering/Core/Actor';
import vtkMapper from '@kitware/vtk.js/Rendering/Core/Mapper';

import { cutterOutline, standing, wireBody } from './cutter.js';

/**
 * The cutter as a body of wires with its tip on the path: a see-through one would have the whole scene
 * drawn again for its sake.
 * @param {object|undefined} cutter of the stage; a ball of `fallback_mm` where the data have none
 * @param {object|undefined} setup of the stage: how the tool stands; along Z where there is none
 */
export function createToolMarker(cutter, setup, fallback_mm) {
  const ball = { type: 'ball', diameter_mm: fallback_mm, corner_radius_mm: fallback_mm / 2,
    flute_length_mm: fallback_mm };
  const { points, lines } = wireBody(cutterOutline(cutter) ?? cutterOutline(ball));
  const data = vtkPolyData.newInstance();
  data.getPoints().setData(setup ? standing(points, setup.rotation) : points, 3);
  data.getLines().setData(lines);
  const mapper = vtkMapper.newInstance({ scalarVisibility: false });
  mapper.setInputData(data);
  const actor = vtkActor.newInstance();
  actor.setMapper(mapper);
  actor.setPickable(false);
  actor.getProperty().setLighting(false);
  return {
    actor,
    setColour: (rgb) => actor.getProperty().setColor(...rgb.map((c) => c / 255)),
    moveTo: (point_mm) => actor.setPosition(...point_mm),
  };
}
