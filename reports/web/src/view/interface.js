import { reading } from './probe.js';
import { choose } from './selection.js';

/** What browser tests ask and do: see README.md. */
export function interfaceOf(viewer) {
  const { scene, state, frame, report } = viewer;
  const corner = () => frame.getBoundingClientRect();
  return {
    state: () => stateOf(viewer),
    project(point_mm) {
      const { x, y } = scene.project(point_mm);
      return { x: x + corner().left, y: y + corner().top };
    },
    pick: (x, y) => reading(viewer, x - corner().left, y - corner().top),
    choose: (stage, id) => choose(viewer, stage, id),
    settled: () => scene.settled(),
    samples(stageIndex) {
      const { field } = report.stages[stageIndex];
      const surface = report.surfaces[field.surface];
      return {
        count: field.deviation_mm.length,
        at: (k) => ({
          point_mm: [...surface.positions.subarray(3 * k, 3 * k + 3)], deviation_mm: field.deviation_mm[k],
          line: field.line[k], stage: field.stage[k], flags: field.flags[k], ...surface.place(k),
        }),
      };
    },
    scene,
    path: viewer.path,
  };
}

const sideOf = ({ limit_mm, end_mm, hasLimit }) => ({ limit: hasLimit ? limit_mm : null, end: end_mm });

function stateOf({ scene, state, colours, section, layers, fixtures }) {
  const { focal, scale, azimuth, elevation, perspective } = scene.camera();
  return {
    stage: state.stage, finding: state.finding?.id ?? null, readout: state.reading,
    camera: {
      focal: [...focal], scale_mm: scale, azimuth_deg: azimuth, elevation_deg: elevation, perspective,
    },
    moving: scene.moving(), frames: scene.frames(), pixelRatio: scene.pixelRatio(),
    scale: {
      sign: colours.sign() > 0 ? 'uncut' : 'gouge', band: colours.band(),
      gouge_mm: sideOf(state.scale.gouge), uncut_mm: sideOf(state.scale.uncut),
      range: colours.choice(state.scale).range,
    },
    section: section.section(),
    layers: { map: layers.surface.look.map, borders: layers.surface.look.borders, path: state.path },
    fixtures: fixtures.state(),
  };
}
