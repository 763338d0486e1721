import vtkDataArray from '@kitware/vtk.js/Common/Core/DataArray';
import vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData';

/**
 * What vtk.js draws of a mesh as flat facets: each triangle has corners of its own, so that it has its own
 * normal and colour.
 * @param {{positions: Float32Array, corners: Uint32Array, triangles: number}} mesh
 */
export function facets({ positions, corners, triangles }) {
  const points = new Float32Array(9 * triangles), normals = new Float32Array(9 * triangles);
  const cells = new Uint32Array(4 * triangles);
  for (let k = 0; k < triangles; ++k) {
    for (let corner = 0; corner < 3; ++corner) {
      const at = 3 * corners[3 * k + corner];
      for (let axis = 0; axis < 3; ++axis) points[9 * k + 3 * corner + axis] = positions[at + axis];
    }
    const normal = normalOf(points, 9 * k);
    for (let corner = 0; corner < 3; ++corner) normals.set(normal, 9 * k + 3 * corner);
    cells.set([3, 3 * k, 3 * k + 1, 3 * k + 2], 4 * k);
  }
  const data = vtkPolyData.newInstance();
  data.getPoints().setData(points, 3);
  data.getPolys().setData(cells);
  data.getPointData().setNormals(
    vtkDataArray.newInstance({ name: 'normals', numberOfComponents: 3, values: normals }));
  return data;
}

function normalOf(points, at) {
  const side = (from) => [0, 1, 2].map((axis) => points[at + from + axis] - points[at + axis]);
  const [a, b, c] = side(3), [d, e, f] = side(6);
  const normal = [b * f - c * e, c * d - a * f, a * e - b * d];
  const size = Math.hypot(...normal) || 1;
  return normal.map((component) => component / size);
}
