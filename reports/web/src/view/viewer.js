import { createPathLayer } from '../path/path_layer.js';
import { applyColours, applyLook, applySection } from './appearance.js';
import { createColourPanel } from './colour/colour_panel.js';
import { make, uniqueId } from '../base/dom.js';
import { createFindingsPanel } from './findings/findings_panel.js';
import { createFixtures, fixtureToggle } from './scene/fixtures.js';
import { attachHand } from './scene/hand.js';
import { interfaceOf } from './interface.js';
import { createLegend } from './colour/legend.js';
import { createMarkers } from './findings/markers.js';
import { handOf, isBehind } from './probe.js';
import { createReadout } from './readout.js';
import { createSectionPanel } from './section/section_panel.js';
import { chooseFinding, chooseStage, goToTime, open, show, showPath } from './selection.js';
import { createStageTabs } from './stage_tabs.js';
import { linkStaticFindings } from './findings/static_links.js';
import { createToolbar } from './toolbar.js';
import { createTriad } from './scene/triad.js';

/**
 * The whole of the view: its elements, and what they do to each other.
 * @param {object} report
 * @param {HTMLElement} frame that the scene is drawn in
 */
export function createViewer(report, frame) {
  const borders = hasFewPatches(report);
  const state = { stage: null, finding: null, reading: null, scale: null, path: false, pickers: new Map() };
  const viewer = { report, state, frame };
  buildElements(viewer, borders);
  viewer.attach = (scene, layers) => {
    Object.assign(viewer, { scene, layers });
    layers.surface.look.borders = borders;
    viewer.markers = createMarkers(scene, (id) => chooseFinding(viewer, id),
      (finding) => isBehind(viewer, finding));
    createTriad(scene);
    viewer.fixtures = createFixtures(scene, report);
    viewer.main.append(viewer.fixtures.note);
    attachHand(scene, handOf(viewer));
    viewer.path = createPathLayer(scene, report);
    viewer.pathPlace.append(viewer.path.element);
    viewer.path.setTheme(scene.theme().dark);
    scene.onTheme((dark) => viewer.path.setTheme(dark));
    document.addEventListener('limitgauge:time', ({ detail }) => goToTime(viewer, detail.stage),
      { capture: true });
    linkStaticFindings(document, (stage, id) => show(viewer, stage, id));
    open(viewer);
    return interfaceOf(viewer);
  };
  return viewer;
}

/** The borders of more patches would make the whole map dark. */
const MOST_BORDERED = 500;
const hasFewPatches = ({ surfaces }) => surfaces.every(({ patches }) => patches.length <= MOST_BORDERED);

function buildElements(viewer, borders) {
  const { report, frame } = viewer;
  const panelId = uniqueId('panel');
  viewer.tabs = createStageTabs(report.stages, panelId, (index) => chooseStage(viewer, index));
  viewer.legend = createLegend();
  viewer.readout = createReadout();
  viewer.findings = createFindingsPanel(report, (id) => chooseFinding(viewer, id));
  viewer.colours = createColourPanel(() => applyColours(viewer));
  viewer.section = createSectionPanel(report.bounds_mm, () => viewer.state.finding?.point_mm,
    () => applySection(viewer));
  viewer.hint = make('p', {
    class: 'view-hint', 'aria-hidden': 'true', text: 'Click here first, or hold Ctrl, to zoom with the wheel',
  });
  viewer.pathPlace = make('div', { class: 'view-path' });
  frame.append(make('i', { class: 'view-crosshair', 'aria-hidden': 'true' }), viewer.hint);
  const toolbar = createToolbar({
    look: (view) => viewer.scene.home(view),
    below: report.stages.some(({ setup }) => setup),
    toggles: [
      { id: 'view-map', text: 'Error map', checked: true, change: (on) => applyLook(viewer, { map: on }) },
      { id: 'view-path', text: 'Toolpath', checked: false, change: (on) => showPath(viewer, on) },
      {
        id: 'view-borders', text: 'Patch borders', checked: borders,
        change: (on) => applyLook(viewer, { borders: on }),
      },
      ...fixtureToggle(report, (on) => viewer.fixtures.show(on)),
    ],
  });
  viewer.pathBox = () => toolbar.querySelector('[data-testid=view-path]');
  viewer.main = make('div', { class: 'view-main' }, [frame, viewer.readout.element, viewer.legend.element]);
  viewer.element = make('div', { class: 'view', id: panelId, data: { testid: 'view' } }, [
    make('p', { class: 'view-lead' }, [
      make('b', { class: 'deep', text: 'Blue' }), ' is cut too deep, ',
      make('b', { class: 'left', text: 'red' }), ' is material left, pale is in tolerance. ',
      'Drag to turn the part; choose a finding to go there.',
    ]),
    make('div', { class: 'view-head' }, [viewer.tabs.element, toolbar]),
    make('div', { class: 'view-body' }, [viewer.main, viewer.findings.element]),
    viewer.colours.element, viewer.section.element, viewer.pathPlace,
  ]);
}
