import './path.css';

import { createPanel, SPEEDS } from './panel.js';
import { createPathActor } from './path_actor.js';
import { createPlayer } from './player.js';
import { duration, instant, sliderScale, stepTime, timeNear, usualSpeed } from './timeline.js';
import { createToolMarker } from './tool_marker.js';
import { colourChoices, exactness, shareOf } from './values.js';
import { viridis } from './viridis.js';

/** Greys and a blue grey that no scale has, seen on the page's ground and on the pale map. */
const RAPID = { light: [90, 98, 110], dark: [138, 150, 165] };
/** How much of the path is shown about a finding, s: the rows beside it, no hairball. */
const ABOUT_FINDING_S = 20;
/** Of a longer path no more than the last minute is shown at first: all of it would be a hairball. */
const MOST_AT_ONCE = 4000, LAST_S = 60;
const TOOL = { light: [50, 60, 75], dark: [96, 128, 165] };

/**
 * The toolpath of a stage over the error map, with its controls.
 * @param {object} scene of view/scene/scene.js
 * @param {object} report as decodeReport gives it
 * @param {string} [veilWords] what the switch says that thins the path out
 * @returns {{element: HTMLElement, show: (stageIndex: number|null) => void,
 *   goNear: (finding: object) => void, setTheme: (dark: boolean) => void,
 *   setSection: (section: object|null) => void, state: () => object}}
 */
export function createPathLayer(scene, report, veilWords) {
  const layer = new PathLayer(scene, report, veilWords);
  // A click on a chart over machining time.
  document.addEventListener('limitgauge:time', ({ detail }) => layer.goTo(detail));
  return {
    element: layer.panel.element,
    show: (stageIndex) => layer.show(stageIndex),
    goNear: (finding) => layer.goNear(finding),
    setTheme: (dark) => layer.setTheme(dark),
    setSection: (section) => layer.setSection(section),
    state: () => layer.state(),
  };
}

/** What a section keeps: below its offset, above it where flipped; everything for null. */
function sectionPlane(section) {
  if (!section) return [0, 0, 0, 1];
  const sign = section.flip ? 1 : -1;
  return [...[0, 1, 2].map((axis) => (axis === section.axis ? sign : 0)), -sign * section.offset_mm];
}

class PathLayer {
  constructor(scene, report, veilWords) {
    this.scene = scene;
    this.report = report;
    this.drawn = new Map();
    this.stage = null;
    this.prepared = null;
    this.section = null;
    this.view = { colour: 'order', rapids: true, veil: false, window_s: 0, dark: false };
    this.time_s = 0;
    this.player = createPlayer((seconds) => this.advance(seconds));
    this.panel = createPanel({
      colour: (key) => this.setColour(key),
      rapids: (rapids) => this.setRapids(rapids),
      veil: (veil) => this.setVeil(veil),
      time: (time_s) => this.setTime(time_s),
      window: (window_s) => this.setWindow(window_s),
      speed: (factor) => this.player.setSpeed(factor),
      play: () => this.togglePlay(),
      step: (direction) => this.setTime(stepTime(this.path(), this.time_s, direction)),
    }, veilWords);
    this.panel.element.hidden = true;
  }

  path() {
    return this.stage === null ? null : (this.report.stages[this.stage].path ?? null);
  }

  show(stageIndex) {
    if (stageIndex === this.stage) return;
    this.stop();
    this.remove();
    this.stage = stageIndex;
    this.panel.element.hidden = stageIndex === null;
    const path = this.path(), usable = path !== null && path.end_s.length > 0;
    if (stageIndex !== null) this.panel.setAvailable(usable);
    if (usable) {
      if (this.prepared !== stageIndex) this.prepare(path);
      this.add();
    }
    this.scene.render();
  }

  /** Sets the controls to the stage's path, which stands at its end. */
  prepare(path) {
    this.prepared = this.stage;
    this.choices = colourChoices(path);
    const wanted = this.choices.find(({ key, reason }) => key === this.view.colour && !reason);
    this.chosen = wanted ?? this.choices[0];
    this.total_s = duration(path);
    this.scale = sliderScale(this.total_s);
    this.panel.setChoices(this.choices);
    this.panel.setColour(this.chosen);
    this.panel.setScale(this.scale);
    this.panel.setExact(exactness(path));
    const speed = usualSpeed(this.total_s, SPEEDS);
    this.player.setSpeed(speed);
    this.panel.setSpeed(speed);
    if (path.end_s.length > MOST_AT_ONCE && this.view.window_s === 0) this.view.window_s = LAST_S;
    this.panel.setWindow(this.view.window_s);
    this.setTime(this.total_s);
  }

  /** Puts the stage's lines into the scene; they are made when they are first wanted. */
  add() {
    const { lines, tool } = this.actors();
    this.scene.add(lines.actor);
    this.scene.add(tool.actor);
    this.paint();
    this.setTime(this.time_s);
  }

  remove() {
    const drawn = this.drawn.get(this.stage);
    if (!drawn) return;
    this.scene.remove(drawn.lines.actor);
    this.scene.remove(drawn.tool.actor);
  }

  actors() {
    if (!this.drawn.has(this.stage)) {
      const [low, high] = this.report.bounds_mm;
      const size = Math.hypot(...high.map((c, i) => c - low[i]));
      this.drawn.set(this.stage, {
        lines: createPathActor(this.path(), () => this.scene.element.clientHeight),
        tool: createToolMarker(this.report.stages[this.stage], size / 40),
        painted: '',
      });
    }
    return this.drawn.get(this.stage);
  }

  /** Colours the lines, where they have other colours so far. */
  paint() {
    const drawn = this.drawn.get(this.stage);
    if (!drawn) return;
    const wanted = `${this.chosen.key} ${this.view.dark}`;
    if (drawn.painted === wanted) return;
    const theme = this.view.dark ? 'dark' : 'light', { chosen } = this, { kind } = this.path();
    const ofFeed = (i) => viridis(shareOf(chosen, chosen.values[i]));
    drawn.lines.setColours((i) => (kind[i] === 0 ? RAPID[theme] : ofFeed(i)));
    drawn.tool.setColour(TOOL[theme]);
    drawn.painted = wanted;
  }

  setColour(key) {
    this.view.colour = key;
    this.chosen = this.choices.find((choice) => choice.key === key);
    this.panel.setColour(this.chosen);
    this.paint();
    this.scene.render();
  }

  setTheme(dark) {
    this.view.dark = dark;
    this.paint();
    this.scene.render();
  }

  setSection(section) {
    this.section = section;
    this.drawn.get(this.stage)?.lines.setShown(this.shownPart());
    this.scene.render();
  }

  setRapids(rapids) {
    this.view.rapids = rapids;
    this.panel.setRapids(rapids);
    this.setTime(this.time_s);
  }

  setVeil(veil) {
    this.view.veil = veil;
    this.setTime(this.time_s);
  }

  setWindow(window_s) {
    this.view.window_s = window_s;
    this.setTime(this.time_s);
  }

  /** The tool where a finding was made, with the last of the path that led there. */
  goNear({ point_mm, stage, move, raw_stock }) {
    const path = this.path();
    if (path === null || path.end_s.length === 0 || !point_mm) return;
    this.stop();
    const own = !raw_stock && (stage === undefined || stage === this.stage);
    this.view.window_s = ABOUT_FINDING_S;
    this.panel.setWindow(ABOUT_FINDING_S);
    this.setTime(timeNear(path, point_mm, own ? move : undefined));
  }

  /** Shows the path up to `time_s`: two numbers for the shader, a place for the tool. */
  setTime(time_s) {
    const path = this.path();
    if (path === null) return;
    this.time_s = Math.min(Math.max(time_s, 0), this.total_s);
    this.now = instant(path, this.time_s);
    this.panel.setTime(this.now, this.total_s, this.scale.decimals, this.programText(this.now.line));
    const drawn = this.drawn.get(this.stage);
    if (!drawn) return;
    drawn.lines.setShown(this.shownPart());
    drawn.tool.place(this.now);
    // With the whole path in sight the tool would only hide some of it.
    drawn.tool.actor.setVisibility(this.time_s < this.total_s || this.view.window_s > 0);
    this.scene.render();
  }

  shownPart() {
    const { window_s, rapids, veil } = this.view;
    const from_s = window_s > 0 ? this.time_s - window_s : -1;
    return { from_s, to_s: this.time_s, rapids, veil, plane: sectionPlane(this.section) };
  }

  programText(line) {
    return this.report.stages[this.stage].text?.find((entry) => entry.line === line)?.text;
  }

  goTo({ stage, time_s }) {
    if (stage !== this.stage || this.prepared !== stage) return;
    this.stop();
    this.setTime(time_s);
  }

  togglePlay() {
    if (this.player.playing()) {
      this.stop();
      return;
    }
    if (this.time_s >= this.total_s) this.setTime(0);
    this.player.start();
    this.panel.setPlaying(true);
  }

  stop() {
    this.player.stop();
    this.panel.setPlaying(false);
  }

  advance(seconds) {
    this.setTime(this.time_s + seconds);
    if (this.time_s < this.total_s) return true;
    this.panel.setPlaying(false);
    return false;
  }

  state() {
    const path = this.path(), drawn = this.drawn.get(this.stage);
    return {
      stage: this.stage,
      visible: Boolean(drawn),
      colour: this.chosen?.key ?? null,
      rapids: this.view.rapids,
      time_s: this.time_s,
      total_s: path ? this.total_s : null,
      shown: path ? this.shownPart() : null,
      now: path ? this.now : null,
      playing: this.player.playing(),
      speed: this.player.speed(),
      segments: path ? path.end_s.length : 0,
      tool_matrix: drawn ? drawn.tool.matrix() : null,
      uploads: drawn ? drawn.lines.uploads() : 0,
    };
  }
}
