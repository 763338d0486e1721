import './stock.css';

import { make, onceAFrame, uniqueId } from '../base/dom.js';
import { createPathLayer } from '../path/path_layer.js';
import { shareOf } from '../path/values.js';
import { viridis } from '../path/viridis.js';
import { KEPT, planeEquation } from '../view/appearance.js';
import { createFindingsPanel } from '../view/findings/findings_panel.js';
import { exceeds, findingsOf } from '../view/findings/findings.js';
import { createMarkers } from '../view/findings/markers.js';
import { linkStaticFindings } from '../view/findings/static_links.js';
import { attachHand } from '../view/scene/hand.js';
import { createPicker } from '../view/scene/pick.js';
import { createFixtures, fixtureToggle } from '../view/scene/fixtures.js';
import { createTriad } from '../view/scene/triad.js';
import { cutCurve } from '../view/section/section.js';
import { createSectionPanel } from '../view/section/section_panel.js';
import { createStageTabs } from '../view/stage_tabs.js';
import { createToolbar } from '../view/toolbar.js';
import { createStockColours } from './colour_panel.js';
import { plainColour, rawColour, removalTimes, stockChoices, toolColour } from './colours.js';
import { createMeasure } from './measure.js';
import { createStockActor } from './stock_actor.js';
import { createStockChart } from './stock_chart.js';
import { stockHit } from './stock_hit.js';
import { createStockReadout } from './stock_readout.js';

/** The stock of a run without a design in 3D: its elements, and what they do to each other. */
export class StockViewer {
  constructor(report, frame) {
    Object.assign(this, { report, frame, stage: null, finding: null, path: true, byKey: false });
    this.made = new Map();
    this.readout = createStockReadout();
    this.measure = createMeasure(() => this.readingInMiddle()?.point_mm ?? null);
    this.colours = createStockColours(() => this.paint());
    this.findings = createFindingsPanel(report, (id) => this.chooseFinding(id));
    this.panelId = uniqueId('panel');
    this.tabs = createStageTabs(report.stages, this.panelId, (index) => this.choose(index));
    this.chart = createStockChart();
    this.section = createSectionPanel(report.bounds_mm, () => this.finding?.point_mm,
      () => this.applySection(), this.chart);
    this.pathPlace = make('div', { class: 'view-path' });
    this.element = this.build();
  }

  build() {
    const toolbar = createToolbar({
      look: (view) => this.scene.home(view),
      toggles: [
        { id: 'stock-shown', text: 'Stock', checked: true, change: (on) => this.showStock(on) },
        { id: 'view-path', text: 'Toolpath', checked: this.path, change: (on) => this.showPath(on) },
        ...fixtureToggle(this.report, (on) => this.fixtures.show(on)),
      ],
    });
    this.hint = make('p', {
      class: 'view-hint', 'aria-hidden': 'true', text: 'Click here first, or hold Ctrl, to zoom with the wheel',
    });
    this.frame.append(make('i', { class: 'view-crosshair', 'aria-hidden': 'true' }), this.hint);
    this.main = make('div', { class: 'view-main' }, [this.frame, this.readout.element]);
    return make('div', { class: 'view', id: this.panelId, data: { testid: 'stock-view' } }, [
      make('p', { class: 'view-lead', text: 'The stock as it was simulated, not the part as it should be: '
        + 'nothing was measured against a design. Drag to turn it; choose a finding to go there.' }),
      make('div', { class: 'view-head' }, [this.tabs.element, toolbar]),
      make('div', { class: 'view-body' }, [this.main, this.findings.element]),
      this.colours.element, this.measure.element, this.section.element, this.pathPlace,
    ]);
  }

  attach(scene) {
    this.scene = scene;
    this.markers = createMarkers(scene, (id) => this.chooseFinding(id), () => false);
    createTriad(scene);
    this.fixtures = createFixtures(scene, this.report);
    this.main.append(this.fixtures.note);
    attachHand(scene, this.hand());
    this.measure.attach(scene);
    this.layer = createPathLayer(scene, this.report, 'Stock shows through');
    this.pathPlace.append(this.layer.element);
    const follow = (dark) => {
      this.layer.setTheme(dark);
      if (this.stage !== null) this.paint();
    };
    this.layer.setTheme(scene.theme().dark);
    scene.onTheme(follow);
    linkStaticFindings(document, (stage, id) => this.show(stage, id));
    document.addEventListener('limitgauge:time', ({ detail }) => this.choose(detail.stage), { capture: true });
    const stages = this.report.stages;
    this.choose(stages.findLastIndex(({ stock }) => stock));
    const [worst] = findingsOf(stages[this.stage]);
    if (worst && exceeds(worst)) this.mark(worst);
    scene.lookHome();
  }

  current() {
    return this.made.get(this.stage);
  }

  /** Actor, picker and colours of a stage's stock; made when they are first wanted. */
  makeStage(index) {
    if (!this.made.has(index)) {
      const { stock } = this.report.stages[index];
      const stages = this.report.stages.slice(0, index + 1);
      this.made.set(index, {
        stock, stages, body: createStockActor(stock), choices: stockChoices(stock, stages),
        times: removalTimes(stock, stages), picker: null,
      });
    }
    return this.made.get(index);
  }

  choose(index) {
    if (index === this.stage || !this.report.stages[index]?.stock) return;
    if (this.current()) this.scene.remove(this.current().body.actor);
    this.stage = index;
    const { body, choices, stock } = this.makeStage(index);
    this.scene.add(body.actor);
    this.colours.setChoices(choices);
    this.tabs.show(index);
    const stage = this.report.stages[index];
    this.fixtures.showStage(stage);
    this.findings.showStage(stage);
    this.markers.show(findingsOf(stage));
    this.mark(null);
    this.measure.setStock(stock);
    this.paint();
    this.applySection();
    this.showPath(this.path);
  }

  paint() {
    const { body, choices, stages, stock } = this.current();
    const { dark, background, ink } = this.scene.theme();
    const chosen = this.colours.chosen(choices);
    this.colours.show(chosen, stages, dark);
    const raw = rawColour(dark), plain = plainColour(dark);
    body.look.inside = background.map((c, k) => c + (ink[k] - c) * (dark ? 0.35 : 0.3));
    body.setColours((k) => {
      if (stock.maker[k] === 0) return raw;
      if (chosen.key === 'plain') return plain;
      if (!chosen.values) return toolColour(stock.maker[k] - 1);
      return Number.isNaN(chosen.values[k]) ? raw : viridis(shareOf(chosen, chosen.values[k]));
    });
    this.scene.render();
  }

  showStock(on) {
    for (const { body } of this.made.values()) body.actor.setVisibility(on);
    this.scene.render();
  }

  /** It begins where the chosen finding is, or the worst one; without a finding all of it is shown. */
  showPath(on) {
    const fresh = on && this.layer.state().stage !== this.stage;
    this.path = on;
    this.layer.show(on ? this.stage : null);
    const finding = this.finding ?? findingsOf(this.report.stages[this.stage])[0];
    if (fresh && finding) this.layer.goNear(finding);
  }

  applySection() {
    if (this.stage === null) return;
    const { body, stock } = this.current();
    const plane = this.section.section();
    body.look.plane = plane ? planeEquation(plane) : [0, 0, 0, 1];
    if (plane) this.drawSection(stock, plane);
    this.layer.setSection(plane && { ...plane, flip: (plane.flip ? -1 : 1) * KEPT[plane.axis] > 0 });
    this.scene.render();
  }

  drawSection(stock, { axis, offset_mm }) {
    this.flat ??= new Float32Array(0);
    if (this.flat.length < stock.positions.length / 3) this.flat = new Float32Array(stock.positions.length / 3);
    const drawn = this.chart.show(cutCurve(stock, this.flat, axis, offset_mm), axis);
    this.section.setNote(drawn ? `${drawn.words}.` : 'The plane does not meet the stock here.');
  }

  mark(finding) {
    this.finding = finding;
    this.findings.showFinding(this.stage, finding);
    this.markers.choose(finding);
  }

  chooseFinding(id) {
    const finding = findingsOf(this.report.stages[this.stage]).find((one) => one.id === id);
    if (!finding) return Promise.resolve();
    this.mark(finding);
    if (!finding.point_mm) return Promise.resolve();
    this.section.through(finding.point_mm);
    if (this.path) this.layer.goNear(finding);
    return this.scene.flyTo({ point_mm: finding.point_mm, distance_mm: 0.8 * this.scene.size_mm });
  }

  /** Comes from elsewhere in the page. */
  async show(stage, id) {
    this.choose(stage);
    this.frame.scrollIntoView({ block: 'center', behavior: 'instant' });
    this.frame.focus({ preventScroll: true });
    await this.chooseFinding(id);
    await this.scene.settled();
  }

  readingAt(x, y) {
    const made = this.current();
    made.picker ??= createPicker(made.stock);
    const hit = stockHit(made.stock, made.picker, made.body.look.plane, this.scene.ray(x, y));
    if (!hit) return null;
    const { cell, point_mm } = hit, { stock, times } = made;
    if (cell === null) return { point_mm, maker: null, line: 0, time_s: NaN };
    return { point_mm, maker: stock.maker[cell], line: stock.line[cell], time_s: times[cell] };
  }

  readingInMiddle() {
    const { width, height } = this.scene.size();
    return this.readingAt(width / 2, height / 2);
  }

  read(reading, spoken) {
    this.readout.show(reading, this.report.stages, spoken);
  }

  hand() {
    const crosshair = (on) => {
      this.byKey = on;
      this.frame.classList.toggle('keyed', on);
    };
    let hintTimer = 0;
    const hover = onceAFrame((x, y) => {
      crosshair(false);
      this.read(this.readingAt(x, y));
    });
    this.scene.onFrame(({ moving }) => { if (this.byKey && !moving) this.read(this.readingInMiddle(), true); });
    this.frame.addEventListener('blur', () => crosshair(false));
    this.frame.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' || event.target !== this.frame) return;
      event.preventDefault();
      crosshair(true);
      this.measure.take(this.readingInMiddle()?.point_mm ?? null);
    });
    return {
      hover,
      tap: (x, y) => {
        const reading = this.readingAt(x, y);
        this.read(reading);
        if (this.measure.on()) this.measure.take(reading?.point_mm ?? null);
      },
      leave: () => { if (!this.byKey && matchMedia('(hover: hover)').matches) this.read(null); },
      keyed: () => crosshair(true),
      wheelIgnored: () => {
        this.hint.classList.add('shown');
        clearTimeout(hintTimer);
        hintTimer = setTimeout(() => this.hint.classList.remove('shown'), 1600);
      },
    };
  }

  state() {
    return {
      stage: this.stage, finding: this.finding?.id ?? null, moving: this.scene.moving(),
      colour: this.colours.chosen(this.current().choices).key, section: this.section.section(),
      measure: this.measure.state(), path: this.path, fixtures: this.fixtures.state(),
    };
  }
}
