import vtkCellArray from '@kitware/vtk.js/Common/Core/CellArray';
import vtkDataArray from '@kitware/vtk.js/Common/Core/DataArray';
import vtkPoints from '@kitware/vtk.js/Common/Core/Points';
import vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData';
import vtkActor from '@kitware/vtk.js/Rendering/Core/Actor';
import vtkMapper from '@kitware/vtk.js/Rendering/Core/Mapper';
import { pointAt } from '../../base/vector.js';

/**
 * The cut curve in the picture: the surface as a line, and from it, magnified, the deviation as a coloured
 * band in the section plane, outwards where material is left and inwards where it is cut too deep.
 */
export function createSectionActors() {
  const line = flatActor(), band = flatActor();
  return {
    actors: [band.actor, line.actor],
    setInk: (ink) => line.actor.getProperty().setColor(...ink),
    /**
     * @param {object[]} pieces of cutCurve
     * @param {{normals: Float32Array}} surface
     * @param {{axis: number, times: number, colourOf: (mm: number) => number[]}} look
     */
    show(pieces, surface, look) {
      const shown = pieces.length > 0;
      for (const { actor } of [line, band]) actor.setVisibility(shown);
      if (!shown) return;
      line.mapper.setInputData(curveLines(pieces));
      band.mapper.setInputData(curveBand(pieces, surface, look));
    },
  };
}

function flatActor() {
  const mapper = vtkMapper.newInstance();
  const actor = vtkActor.newInstance({ visibility: false });
  actor.setMapper(mapper);
  actor.getProperty().setLighting(false);
  actor.getProperty().setLineWidth(2);
  return { mapper, actor };
}

function polyData(points, { lines, polys, colours }) {
  const data = vtkPolyData.newInstance();
  data.setPoints(vtkPoints.newInstance({ values: Float32Array.from(points), numberOfComponents: 3 }));
  if (lines) data.setLines(vtkCellArray.newInstance({ values: Uint32Array.from(lines) }));
  if (polys) data.setPolys(vtkCellArray.newInstance({ values: Uint32Array.from(polys) }));
  if (colours)
    data.getPointData().setScalars(vtkDataArray.newInstance({
      name: 'colours', numberOfComponents: 3, values: Uint8Array.from(colours),
    }));
  return data;
}

function curveLines(pieces) {
  const points = pieces.flatMap(({ from, to }) => [...from, ...to]);
  return polyData(points, { lines: pieces.flatMap((_, k) => [2, 2 * k, 2 * k + 1]) });
}

function curveBand(pieces, { normals }, { axis, times, colourOf }) {
  const points = [], polys = [], colours = [];
  for (const { from, to, deviation_mm, corners } of pieces) {
    const out = inPlane(pointAt(normals, corners[0]), axis);
    const base = points.length / 3;
    [from, to].forEach((point, end) => {
      points.push(...point, ...point.map((c, k) => c + out[k] * times * deviation_mm[end]));
      const rgb = colourOf(deviation_mm[end]);
      colours.push(...rgb, ...rgb);
    });
    polys.push(4, base, base + 2, base + 3, base + 1);
  }
  return polyData(points, { polys, colours });
}

/** A normal's direction within the section plane. */
function inPlane(normal, axis) {
  const flat = normal.map((c, k) => (k === axis ? 0 : c));
  const length = Math.hypot(...flat);
  return length > 0 ? flat.map((c) => c / length) : flat;
}
