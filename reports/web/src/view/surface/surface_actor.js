import vtkDataArray from '@kitware/vtk.js/Common/Core/DataArray';
import vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData';
import vtkActor from '@kitware/vtk.js/Rendering/Core/Actor';
import vtkMapper from '@kitware/vtk.js/Rendering/Core/Mapper';
import { coarsened, gathered } from './coarse.js';
import { sideUniform } from '../colour/colour_shader.js';
import { SURFACE_REPLACEMENTS } from './surface_shader.js';

const CANNOT_REACH = 1;
const EVERYTHING = [0, 0, 0, 1];

/**
 * The limit surface in the colours of a stage's deviation. Scale, band, borders and section are numbers
 * that the shader is given with each frame: changing them sends no geometry again.
 */
export function createSurfaceActor() {
  const look = {
    scale: null, band: false, map: true, borders: true, border: [0, 0, 0], back: [0.6, 0.6, 0.6],
    plane: EVERYTHING, pixelRatio: 1,
  };
  const fine = meshActor(look), coarse = meshActor(look);
  const coarser = new Map();
  let shown = null, coarseShows = null;
  const showCoarse = ({ surface, field }) => {
    if (!coarser.has(surface)) coarser.set(surface, coarsened(surface));
    const less = coarser.get(surface);
    if (less) {
      const { samples } = less;
      coarse.show(less.surface, gathered(field.deviation_mm, samples), gathered(field.flags, samples));
    }
    coarseShows = shown;
    return less !== null;
  };
  return {
    actors: [fine.actor, coarse.actor], look,
    /** Shows a stage's field on its surface. */
    show(surface, field) {
      fine.show(surface, field.deviation_mm, field.flags);
      shown = { surface, field };
    },
    /**
     * Draws with fewer cells. They are made when they are first wanted; then both meshes stay where they
     * are, on the graphics card.
     */
    setCoarse(wanted) {
      const ready = wanted
        && (coarseShows === shown ? coarser.get(shown.surface) !== null : showCoarse(shown));
      coarse.actor.setVisibility(ready);
      fine.actor.setVisibility(!ready);
    },
  };
}

function meshActor(look) {
  const mapper = vtkMapper.newInstance({ scalarVisibility: false });
  const actor = vtkActor.newInstance();
  mapper.setCustomShaderAttributes(['deviation', 'unreachable', 'place']);
  mapper.setViewSpecificProperties({
    OpenGL: { ShaderReplacements: SURFACE_REPLACEMENTS },
    ShadersCallbacks: [{ userData: look, callback: setUniforms }],
  });
  actor.setMapper(mapper);
  // Facing the reader, a place has exactly the legend's colour.
  actor.getProperty().set({ ambient: 0.76, diffuse: 0.24, specular: 0 });
  const meshes = new Map();
  return {
    actor,
    show(surface, deviation_mm, flags) {
      if (!meshes.has(surface)) meshes.set(surface, surfaceMesh(surface));
      const mesh = meshes.get(surface);
      setArray(mesh, 'deviation', deviation_mm, 1);
      setArray(mesh, 'unreachable', Float32Array.from(flags, (bits) => bits & CANNOT_REACH), 1);
      mesh.modified();
      mapper.setInputData(mesh);
    },
  };
}

function setArray(mesh, name, values, numberOfComponents) {
  mesh.getPointData().removeArray(name);
  mesh.getPointData().addArray(vtkDataArray.newInstance({ name, values, numberOfComponents }));
}

function surfaceMesh(surface) {
  const mesh = vtkPolyData.newInstance();
  mesh.getPoints().setData(surface.positions, 3);
  mesh.getPolys().setData(quads(surface.cells));
  mesh.getPointData().setNormals(
    vtkDataArray.newInstance({ name: 'normals', numberOfComponents: 3, values: surface.normals }),
  );
  setArray(mesh, 'place', places(surface), 2);
  return mesh;
}

/** Cells as vtk.js takes them: the number of corners before each. */
function quads(cells) {
  const polys = new Uint32Array((cells.length / 4) * 5);
  for (let cell = 0; cell < cells.length / 4; ++cell) {
    polys[5 * cell] = 4;
    polys.set(cells.subarray(4 * cell, 4 * cell + 4), 5 * cell + 1);
  }
  return polys;
}

/** u, v of every sample, by which the shader knows the borders of patches. */
function places({ patches, first, positions, u, v }) {
  const values = new Float32Array((positions.length / 3) * 2);
  patches.forEach(({ columns, rows }, patch) => {
    for (let k = 0; k < columns * rows; ++k) {
      const sample = first[patch] + k;
      values[2 * sample] = u ? u[sample] : (k % columns) / (columns - 1);
      values[2 * sample + 1] = v ? v[sample] : Math.floor(k / columns) / (rows - 1);
    }
  });
  return values;
}

function setUniforms(look, cells) {
  const program = cells.getProgram();
  if (!program.isUniformUsed('sectionPlane')) return;
  program.setUniform3fArray('scaleGouge', sideUniform(look.scale.gouge));
  program.setUniform3fArray('scaleUncut', sideUniform(look.scale.uncut));
  program.setUniformf('bandShown', look.band ? 1 : 0);
  program.setUniformf('mapShown', look.map ? 1 : 0);
  program.setUniform4f('borderColour', ...look.border, look.borders ? 0.55 : 0);
  program.setUniform3fArray('backColour', look.back);
  program.setUniformf('pixelRatio', look.pixelRatio);
  program.setUniform4f('sectionPlane', ...inMesh(look.plane, cells.getCABO()));
}

/** A plane in the coordinates that vtk.js hands to the card, which it may shift and scale. */
function inMesh([x, y, z, w], buffer) {
  if (!buffer.getCoordShiftAndScaleEnabled()) return [x, y, z, w];
  const shift = buffer.getCoordShift(), scale = buffer.getCoordScale();
  return [x / scale[0], y / scale[1], z / scale[2], w + x * shift[0] + y * shift[1] + z * shift[2]];
}
