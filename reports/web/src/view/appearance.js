import { colour, scaleFor } from './colour/colour_scale.js';
import { current } from './current.js';
import { showReading } from './probe.js';
import { cutCurve, magnification } from './section/section.js';

const CANNOT_REACH = 1;

export function applyLook({ layers, scene }, look) {
  Object.assign(layers.surface.look, look);
  scene.render();
}

export function applyColours(viewer) {
  const { stage, field } = current(viewer);
  const { colours, state } = viewer;
  state.scale = scaleFor(stage, colours.choice(scaleFor(stage)));
  const band = colours.band(), sign = colours.sign();
  const hasUnreachable = field.flags.some((flags) => flags & CANNOT_REACH);
  viewer.legend.show(state.scale, { band, sign, hasUnreachable });
  applyLook(viewer, { scale: state.scale, band });
  applySection(viewer);
  showReading(viewer, false);
}

export function applySection(viewer) {
  const { scene, layers, section, state } = viewer;
  const plane = section.section();
  layers.surface.look.plane = plane ? planeEquation(plane) : [0, 0, 0, 1];
  const { surface, field, stage } = current(viewer);
  const pieces = plane ? cutCurve(surface, field.deviation_mm, plane.axis, plane.offset_mm) : [];
  const times = magnification(Math.max(stage.gouge_mm?.high ?? 0, stage.uncut_mm?.high ?? 0), scene.size_mm);
  const band = viewer.colours.band();
  const colourOf = (mm) => colour(state.scale, mm, band);
  layers.section.show(pieces, surface, { axis: plane?.axis, times, colourOf });
  section.setNote(pieces.length === 0 ? 'The plane does not meet the surface here.'
    : `Deviation along the section of ${stage.name}; in the picture it stands ${times} times magnified.`);
  section.chart.show(pieces, {
    axis: plane?.axis, bounds_mm: viewer.report.bounds_mm, scale: state.scale,
    sign: viewer.colours.sign(), band,
  });
  viewer.path.setSection(plane && { ...plane, flip: (plane.flip ? -1 : 1) * KEPT[plane.axis] > 0 });
  scene.render();
}

/** The half that is kept, so that the cut faces the usual eye: below in X and Z, above in Y. */
export const KEPT = [-1, 1, -1];

/** What is kept is where this is not negative. */
export function planeEquation({ axis, offset_mm, flip }) {
  const way = flip ? -KEPT[axis] : KEPT[axis];
  const plane = [0, 0, 0, -way * offset_mm];
  plane[axis] = way;
  return plane;
}
