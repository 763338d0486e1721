import { applyColours } from './appearance.js';
import { scaleFor } from './colour/colour_scale.js';
import { exceeds, findingsOf } from './findings/findings.js';
import { read } from './probe.js';
import { firstView } from './scene/camera.js';

/** The failing stage with its worst finding chosen, or else the last stage that ran; all of the part seen. */
export function open(viewer) {
  const { stages } = viewer.report;
  const shown = (wanted) => stages.findLastIndex((stage) => stage.field && wanted(stage));
  const verdicts = ['fail', 'indeterminate'].map((word) => shown(({ verdict }) => verdict === word));
  const index = [...verdicts, shown(() => true)].find((k) => k >= 0);
  chooseStage(viewer, index);
  const [worst] = findingsOf(stages[index]);
  if (worst && exceeds(worst)) markFinding(viewer, worst);
  viewer.scene.lookHome(firstView(stages[index]));
}

export function chooseStage(viewer, index) {
  const { report, state, layers } = viewer;
  if (state.stage === index) return;
  const stage = report.stages[index], before = report.stages[state.stage];
  if (before && firstView(before) !== firstView(stage)) viewer.scene.home(firstView(stage));
  state.stage = index;
  viewer.tabs.show(index);
  layers.surface.show(report.surfaces[stage.field.surface], stage.field);
  viewer.fixtures.showStage(stage);
  viewer.findings.showStage(stage);
  viewer.markers.show(findingsOf(stage));
  viewer.scene.setInterest(findingsOf(stage).flatMap(({ point_mm }) => (point_mm ? [point_mm] : [])));
  markFinding(viewer, null);
  viewer.colours.suggest(scaleFor(stage));
  applyColours(viewer);
  read(viewer, null);
  showPath(viewer, state.path);
}

/** The path begins where the chosen finding is, or the worst one of the stage. */
export function showPath(viewer, on) {
  const { state, report, path } = viewer, fresh = on && path.state().stage !== state.stage;
  state.path = on;
  path.show(on ? state.stage : null);
  const finding = state.finding ?? findingsOf(report.stages[state.stage])[0];
  if (fresh && finding) path.goNear(finding);
}

/** A click on a chart over time: the path layer goes to the moment once its stage and path are shown. */
export function goToTime(viewer, stage) {
  if (!viewer.report.stages[stage]?.field) return;
  chooseStage(viewer, stage);
  viewer.pathBox().checked = true;
  showPath(viewer, true);
  viewer.frame.scrollIntoView({ block: 'center', behavior: 'instant' });
}

function markFinding(viewer, finding) {
  viewer.state.finding = finding;
  viewer.findings.showFinding(viewer.state.stage, finding);
  viewer.markers.choose(finding);
}

export function chooseFinding(viewer, id) {
  const { scene, state } = viewer;
  const finding = findingsOf(viewer.report.stages[state.stage]).find((one) => one.id === id);
  if (!finding) return Promise.resolve();
  markFinding(viewer, finding);
  if (!finding.point_mm) return Promise.resolve();
  if (state.path) viewer.path.goNear(finding);
  viewer.section.through(finding.point_mm);
  const { point_mm, normal } = finding;
  return scene.flyTo({ point_mm, normal, distance_mm: distanceFor(scene, finding) });
}

/** How much of the part's height is seen about a finding: several times its own extent, never a speck. */
function distanceFor({ size_mm }, { kind, extent_mm }) {
  // A collision is understood by what is around it.
  if (kind === 'process') return 0.8 * size_mm;
  const extent = extent_mm ? Math.hypot(...[0, 1, 2].map((k) => extent_mm[1][k] - extent_mm[0][k])) : 0;
  return Math.min(0.8 * size_mm, Math.max(0.28 * size_mm, 4 * extent));
}

/** Comes from elsewhere in the page: to a finding, and to the view itself. */
export function show(viewer, stage, id) {
  if (!viewer.report.stages[stage]?.field) return Promise.resolve();
  viewer.frame.scrollIntoView({ block: 'center', behavior: 'instant' });
  viewer.frame.focus({ preventScroll: true });
  return choose(viewer, stage, id);
}

export async function choose(viewer, stage, id) {
  chooseStage(viewer, stage);
  await chooseFinding(viewer, id);
  await viewer.scene.settled();
}
