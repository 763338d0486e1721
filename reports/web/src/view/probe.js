import { colour, css } from './colour/colour_scale.js';
import { current } from './current.js';
import { onceAFrame } from '../base/dom.js';
import { createPicker } from './scene/pick.js';
import { readingAt } from './reading.js';
import { add, scaled } from '../base/vector.js';

function firstHit(viewer, ray) {
  const { surface } = current(viewer);
  const { pickers } = viewer.state;
  if (!pickers.has(surface)) pickers.set(surface, createPicker(surface));
  const [a, b, c, d] = viewer.layers.surface.look.plane;
  return pickers.get(surface).first(ray, ([x, y, z]) => a * x + b * y + c * z + d >= 0);
}

export function reading(viewer, x, y) {
  const { surface, field } = current(viewer);
  const hit = firstHit(viewer, viewer.scene.ray(x, y));
  return hit && readingAt(surface, field, hit);
}

export function read(viewer, value, spoken = false) {
  viewer.state.reading = value;
  showReading(viewer, spoken);
}

export function showReading(viewer, spoken) {
  const { state, report, colours } = viewer;
  const value = state.reading;
  viewer.legend.point(value ? value.deviation_mm : null);
  viewer.readout.show(value, {
    sign: colours.sign(), limits: current(viewer).stage.limits, stages: report.stages,
    triangles: report.triangles,
    colour: value && css(colour(state.scale, value.deviation_mm, colours.band())),
  }, spoken);
}

/** What the hand does beyond moving the camera. */
export function handOf(viewer) {
  const { scene, frame, hint } = viewer;
  let hintTimer = 0, byKey = false;
  const crosshair = (on) => {
    byKey = on;
    frame.classList.toggle('keyed', on);
  };
  const hover = onceAFrame((x, y) => {
    crosshair(false);
    read(viewer, reading(viewer, x, y));
  });
  scene.onFrame(({ moving }) => {
    if (!byKey || moving) return;
    const { width, height } = scene.size();
    read(viewer, reading(viewer, width / 2, height / 2), true);
  });
  frame.addEventListener('blur', () => crosshair(false));
  return {
    hover,
    tap: (x, y) => read(viewer, reading(viewer, x, y)),
    // By touch the reading stays until the next tap; a mouse that leaves takes it along.
    leave: () => { if (!byKey && matchMedia('(hover: hover)').matches) hover(-1, -1); },
    keyed: () => crosshair(true),
    wheelIgnored: () => {
      hint.classList.add('shown');
      clearTimeout(hintTimer);
      hintTimer = setTimeout(() => hint.classList.remove('shown'), 1600);
    },
  };
}

/** Whether a section has taken a finding away, or something of the surface stands before it. */
export function isBehind(viewer, { point_mm, normal }) {
  const { scene } = viewer;
  const [a, b, c, d] = viewer.layers.surface.look.plane;
  if (a * point_mm[0] + b * point_mm[1] + c * point_mm[2] + d < -1e-3 * scene.size_mm) return true;
  const lifted = add(point_mm, scaled(normal ?? [0, 0, 1], 2e-3 * scene.size_mm));
  const { x, y } = scene.project(lifted);
  const { origin } = scene.ray(x, y);
  return firstHit(viewer, { origin: lifted, direction: origin.map((c, k) => c - lifted[k]) }) !== null;
}
