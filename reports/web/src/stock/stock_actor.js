import vtkDataArray from '@kitware/vtk.js/Common/Core/DataArray';
import vtkActor from '@kitware/vtk.js/Rendering/Core/Actor';
import vtkMapper from '@kitware/vtk.js/Rendering/Core/Mapper';

import { inVertices } from '../path/path_actor.js';
import { facets } from '../view/scene/facets.js';

const EVERYTHING = [0, 0, 0, 1];

/**
 * The stock as flat facets, a colour each. `look.plane` says what a section keeps; what is seen from within
 * has `look.inside` without light, so that a cut looks like one through a solid.
 */
export function createStockActor(stock) {
  const look = { plane: EVERYTHING, inside: [0.6, 0.6, 0.6] };
  const data = facets(stock);
  const mapper = vtkMapper.newInstance();
  mapper.setInputData(data);
  mapper.setColorModeToDirectScalars();
  mapper.setScalarModeToUsePointData();
  mapper.setViewSpecificProperties({
    OpenGL: { ShaderReplacements: replacements() },
    ShadersCallbacks: [{ userData: look, callback: setUniforms }],
  });
  const actor = vtkActor.newInstance();
  actor.setMapper(mapper);
  actor.setPickable(false);
  actor.getProperty().set({ ambient: 0.45, diffuse: 0.55, specular: 0 });
  return {
    actor, look,
    /** @param {(triangle: number) => number[]} colourOf from 0 to 255 */
    setColours(colourOf) {
      const values = new Uint8Array(9 * stock.triangles);
      for (let k = 0; k < stock.triangles; ++k) {
        const colour = colourOf(k);
        for (let corner = 0; corner < 3; ++corner) values.set(colour, 9 * k + 3 * corner);
      }
      data.getPointData().setScalars(
        vtkDataArray.newInstance({ name: 'colour', numberOfComponents: 3, values }));
      data.modified();
    },
  };
}

function setUniforms(look, cells) {
  const program = cells.getProgram();
  if (!program.isUniformUsed('stockPlane')) return;
  program.setUniform4f('stockPlane', ...inVertices(look.plane, cells.getCABO()));
  program.setUniform3fArray('stockInside', look.inside);
}

function replacements() {
  const replace = (shaderType, originalValue, lines) => ({
    shaderType, originalValue, replaceFirst: true, replaceAll: false,
    replacementValue: lines.join('\n'),
  });
  return [
    replace('Vertex', '//VTK::Camera::Dec',
      ['//VTK::Camera::Dec', 'varying float stockSideVS;', 'uniform vec4 stockPlane;']),
    replace('Vertex', '//VTK::Light::Impl',
      ['//VTK::Light::Impl', '  stockSideVS = dot(stockPlane.xyz, vertexMC.xyz) + stockPlane.w;']),
    replace('Fragment', '//VTK::Color::Dec',
      ['//VTK::Color::Dec', 'varying float stockSideVS;', 'uniform vec3 stockInside;']),
    replace('Fragment', '//VTK::Color::Impl', ['  if (stockSideVS < 0.0) discard;', '//VTK::Color::Impl']),
    replace('Fragment', '//VTK::Light::Impl', [
      '//VTK::Light::Impl',
      '  if (gl_FrontFacing == false) gl_FragData[0] = vec4(stockInside, 1.0);',
    ]),
  ];
}
