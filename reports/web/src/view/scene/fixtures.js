import vtkActor from '@kitware/vtk.js/Rendering/Core/Actor';
import vtkMapper from '@kitware/vtk.js/Rendering/Core/Mapper';

import { make } from '../../base/dom.js';
import { facets } from './facets.js';

const OPACITY = 0.35;
const LIGHT = [0.42, 0.45, 0.5], DARK = [0.62, 0.66, 0.72];

/**
 * Clamps and tables as they stand about the part in the stage that is shown; it is seen through them.
 * `note` names those that move against the part then, which are not drawn.
 */
export function createFixtures(scene, { fixtures }) {
  const actors = new Map();
  const note = make('p', { class: 'view-note', data: { testid: 'view-fixtures-note' } });
  note.hidden = true;
  let stage = null, on = true;
  const shown = () => (on && stage ? stage.fixtures : []);
  const paint = () => {
    for (const actor of actors.values()) actor.getProperty().setColor(...(scene.theme().dark ? DARK : LIGHT));
  };
  const update = () => {
    for (const k of shown())
      if (!actors.has(k)) {
        actors.set(k, actorOf(fixtures[k]));
        scene.add(actors.get(k));
      }
    for (const [k, actor] of actors) actor.setVisibility(shown().includes(k));
    paint();
    scene.render();
  };
  scene.onTheme(paint);
  return {
    note,
    showStage(next) {
      stage = next;
      note.textContent = movingWords(stage.moving_fixtures);
      note.hidden = stage.moving_fixtures.length === 0;
      update();
    },
    show(wanted) {
      on = wanted;
      update();
    },
    /** Names of what is drawn. */
    state: () => shown().map((k) => fixtures[k].name),
  };
}

export function movingWords(names) {
  const list = names.map((name) => `\u201c${name}\u201d`).join(', ');
  return `Not drawn: ${list}, which ${names.length === 1 ? 'moves' : 'move'} against the part in this stage.`;
}

/** The switch of a toolbar; none where a run has no fixtures. */
export function fixtureToggle(report, change) {
  return report.fixtures.length > 0 ? [{ id: 'view-fixtures', text: 'Fixtures', checked: true, change }] : [];
}

function actorOf(fixture) {
  const mapper = vtkMapper.newInstance();
  mapper.setInputData(facets(fixture));
  const actor = vtkActor.newInstance();
  actor.setMapper(mapper);
  actor.setPickable(false);
  actor.getProperty().set({ ambient: 0.5, diffuse: 0.5, specular: 0, opacity: OPACITY });
  return actor;
}
