import { colour, css, scaleFor } from './colour_scale.js';
import { createColourPanel } from './colour_panel.js';
import { make, onceAFrame, uniqueId } from './dom.js';
import { createFindingsPanel } from './findings_panel.js';
import { exceeds, findingsOf } from './findings.js';
import { attachHand } from './hand.js';
import { createLegend } from './legend.js';
import { createMarkers } from './markers.js';
import { createPicker } from './pick.js';
import { readingAt } from './reading.js';
import { createReadout } from './readout.js';
import { createSectionPanel } from './section_panel.js';
import { cutCurve, magnification } from './section.js';
import { linkStaticFindings } from './static_links.js';
import { createStageTabs } from './stage_tabs.js';
import { createToolbar } from './toolbar.js';
import { add, scaled } from './vector.js';

const CANNOT_REACH = 1;

/**
 * The whole of the view: its elements, and what they do to each other.
 * @param {object} report
 * @param {HTMLElement} frame that the scene is drawn in
 */
export function createViewer(report, frame) {
  const state = { stage: null, finding: null, reading: null, scale: null, pickers: new Map() };
  const viewer = { report, state, frame };
  buildElements(viewer);
  viewer.attach = (scene, layers) => {
    Object.assign(viewer, { scene, layers });
    viewer.markers = createMarkers(scene, (id) => chooseFinding(viewer, id), (finding) => isBehind(viewer, finding));
    attachHand(scene, handOf(viewer));
    linkStaticFindings(document, (stage, id) => show(viewer, stage, id));
    open(viewer);
    return interfaceOf(viewer);
  };
  return viewer;
}

function buildElements(viewer) {
  const { report, frame } = viewer;
  const panelId = uniqueId('panel');
  viewer.tabs = createStageTabs(report.stages, panelId, (index) => chooseStage(viewer, index));
  viewer.legend = createLegend();
  viewer.readout = createReadout();
  viewer.findings = createFindingsPanel(report, (id) => chooseFinding(viewer, id));
  viewer.colours = createColourPanel(() => applyColours(viewer));
  viewer.section = createSectionPanel(report.bounds_mm, () => applySection(viewer));
  viewer.hint = make('p', { class: 'view-hint', 'aria-hidden': 'true', text: 'Click here first, or hold Ctrl, to zoom with the wheel' });
  viewer.pathPlace = make('div', { class: 'view-path' });
  frame.append(make('i', { class: 'view-crosshair', 'aria-hidden': 'true' }), viewer.hint);
  const toolbar = createToolbar({
    look: (view) => viewer.scene.home(view),
    toggles: [
      { id: 'view-map', text: 'Error map', checked: true, change: (on) => applyLook(viewer, { map: on }) },
      { id: 'view-borders', text: 'Patch borders', checked: true, change: (on) => applyLook(viewer, { borders: on }) },
    ],
  });
  viewer.element = make('div', { class: 'view', id: panelId, data: { testid: 'view' } }, [
    make('p', { class: 'view-lead' }, [
      make('b', { class: 'deep', text: 'Blue' }), ' is cut too deep, ', make('b', { class: 'left', text: 'red' }),
      ' is material left, pale is in tolerance. Drag to turn the part; choose a finding to go there.',
    ]),
    make('div', { class: 'view-head' }, [viewer.tabs.element, toolbar]),
    make('div', { class: 'view-body' }, [
      make('div', { class: 'view-main' }, [frame, viewer.readout.element, viewer.legend.element]),
      viewer.findings.element,
    ]),
    viewer.colours.element, viewer.section.element, viewer.pathPlace,
  ]);
}

/** The failing stage with its worst finding chosen, or else the last stage that ran; all of the part seen. */
function open(viewer) {
  const { stages } = viewer.report;
  const shown = (wanted) => stages.findLastIndex((stage) => stage.field && wanted(stage));
  const failed = shown(({ verdict }) => verdict === 'fail'), unclear = shown(({ verdict }) => verdict === 'indeterminate');
  const index = [failed, unclear, shown(() => true)].find((k) => k >= 0);
  chooseStage(viewer, index);
  const [worst] = findingsOf(stages[index]);
  if (worst && exceeds(worst)) markFinding(viewer, worst);
}

function chooseStage(viewer, index) {
  const { report, state, layers } = viewer;
  if (state.stage === index) return;
  const stage = report.stages[index];
  state.stage = index;
  viewer.tabs.show(index);
  layers.surface.show(report.surfaces[stage.field.surface], stage.field);
  viewer.findings.showStage(stage);
  viewer.markers.show(findingsOf(stage));
  markFinding(viewer, null);
  viewer.colours.suggest(scaleFor(stage));
  applyColours(viewer);
  read(viewer, null);
  viewer.path?.show(index);
}

/** The chosen stage, its surface and field. */
function current({ report, state }) {
  const stage = report.stages[state.stage];
  return { stage, field: stage.field, surface: report.surfaces[stage.field.surface] };
}

function markFinding(viewer, finding) {
  viewer.state.finding = finding;
  viewer.findings.showFinding(viewer.state.stage, finding);
  viewer.markers.choose(finding);
}

function chooseFinding(viewer, id) {
  const { scene, state } = viewer;
  const finding = findingsOf(viewer.report.stages[state.stage]).find((one) => one.id === id);
  if (!finding) return Promise.resolve();
  markFinding(viewer, finding);
  if (!finding.point_mm) return Promise.resolve();
  viewer.section.through(finding.point_mm);
  return scene.flyTo({ point_mm: finding.point_mm, normal: finding.normal, distance_mm: distanceFor(scene, finding) });
}

/** How much of the part's height is seen about a finding: several times its own extent, never a speck. */
function distanceFor({ size_mm }, { extent_mm }) {
  const extent = extent_mm ? Math.hypot(...[0, 1, 2].map((k) => extent_mm[1][k] - extent_mm[0][k])) : 0;
  return Math.min(0.8 * size_mm, Math.max(0.22 * size_mm, 4 * extent));
}

/** Comes from elsewhere in the page: to a finding, and to the view itself. */
function show(viewer, stage, id) {
  if (!viewer.report.stages[stage]?.field) return Promise.resolve();
  viewer.frame.scrollIntoView({ block: 'center', behavior: 'instant' });
  viewer.frame.focus({ preventScroll: true });
  return choose(viewer, stage, id);
}

async function choose(viewer, stage, id) {
  chooseStage(viewer, stage);
  await chooseFinding(viewer, id);
  await viewer.scene.settled();
}

function applyLook({ layers, scene }, look) {
  Object.assign(layers.surface.look, look);
  scene.render();
}

function applyColours(viewer) {
  const { stage, field } = current(viewer);
  const { colours, state } = viewer;
  state.scale = scaleFor(stage, colours.choice(scaleFor(stage)));
  const band = colours.band(), sign = colours.sign();
  viewer.legend.show(state.scale, { band, sign, hasUnreachable: field.flags.some((flags) => flags & CANNOT_REACH) });
  applyLook(viewer, { scale: state.scale, band });
  applySection(viewer);
  showReading(viewer, false);
}

function applySection(viewer) {
  const { scene, layers, section, state } = viewer;
  const plane = section.section();
  layers.surface.look.plane = plane ? planeEquation(plane) : [0, 0, 0, 1];
  const { surface, field, stage } = current(viewer);
  const pieces = plane ? cutCurve(surface, field.deviation_mm, plane.axis, plane.offset_mm) : [];
  const { gouge, uncut } = state.scale;
  const times = magnification(Math.max(gouge.end_mm, uncut.end_mm), scene.size_mm);
  const band = viewer.colours.band();
  layers.section.show(pieces, surface, { axis: plane?.axis, times, colourOf: (mm) => colour(state.scale, mm, band) });
  section.setNote(pieces.length === 0 ? 'The plane does not meet the surface here.'
    : `Deviation along the section of ${stage.name}; in the picture it stands ${times} times magnified.`);
  section.chart.show(pieces, {
    axis: plane?.axis, bounds_mm: viewer.report.bounds_mm, scale: state.scale, sign: viewer.colours.sign(), band,
  });
  scene.render();
}

/** Keeps what lies below the plane on its axis, or with `flip` above it. */
function planeEquation({ axis, offset_mm, flip }) {
  const way = flip ? 1 : -1;
  const plane = [0, 0, 0, -way * offset_mm];
  plane[axis] = way;
  return plane;
}

function pickAt(viewer, x, y) {
  return firstHit(viewer, viewer.scene.ray(x, y));
}

function firstHit(viewer, ray) {
  const { surface } = current(viewer);
  const { pickers } = viewer.state;
  if (!pickers.has(surface)) pickers.set(surface, createPicker(surface));
  const [a, b, c, d] = viewer.layers.surface.look.plane;
  return pickers.get(surface).first(ray, ([x, y, z]) => a * x + b * y + c * z + d >= 0);
}

function reading(viewer, x, y) {
  const { surface, field } = current(viewer);
  const hit = pickAt(viewer, x, y);
  return hit && readingAt(surface, field, hit);
}

function read(viewer, value, spoken = false) {
  viewer.state.reading = value;
  showReading(viewer, spoken);
}

function showReading(viewer, spoken) {
  const { state, report, colours } = viewer;
  const value = state.reading;
  viewer.legend.point(value ? value.deviation_mm : null);
  viewer.readout.show(value, {
    sign: colours.sign(), limits: current(viewer).stage.limits, stages: report.stages,
    colour: value && css(colour(state.scale, value.deviation_mm, colours.band())),
  }, spoken);
}

/** What the hand does beyond moving the camera. */
function handOf(viewer) {
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

/** Whether something of the surface stands between the eye and a finding. */
function isBehind(viewer, { point_mm, normal = [0, 0, 1] }) {
  const { scene } = viewer;
  const lifted = add(point_mm, scaled(normal, 2e-3 * scene.size_mm));
  const { x, y } = scene.project(lifted);
  const { origin } = scene.ray(x, y);
  return firstHit(viewer, { origin: lifted, direction: origin.map((c, k) => c - lifted[k]) }) !== null;
}

/** What browser tests ask and do: see README.md. */
function interfaceOf(viewer) {
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
    path: () => viewer.path ?? null,
  };
}

function stateOf({ scene, state, colours, section, layers }) {
  const { focal, scale, azimuth, elevation, perspective } = scene.camera();
  return {
    stage: state.stage, finding: state.finding?.id ?? null, readout: state.reading,
    camera: { focal: [...focal], scale_mm: scale, azimuth_deg: azimuth, elevation_deg: elevation, perspective },
    moving: scene.moving(), frames: scene.frames(), pixelRatio: scene.pixelRatio(),
    scale: {
      sign: colours.sign() > 0 ? 'uncut' : 'gouge', band: colours.band(),
      gouge_mm: { ...state.scale.gouge }, uncut_mm: { ...state.scale.uncut },
    },
    section: section.section(),
    layers: { map: layers.surface.look.map, borders: layers.surface.look.borders },
  };
}
