import { make } from '../../base/dom.js';
import { exceeds, findingsOf, headline, leftOut, programAround } from './findings.js';
import { coordinate, parameter, statedLength } from '../../base/format.js';

/**
 * The findings of a stage, worst first, and what is to be said about the chosen one.
 * @param {object} report
 * @param {(id: string) => void} choose
 */
export function createFindingsPanel(report, choose) {
  const title = make('h3');
  const list = make('ul', { class: 'view-findings', data: { testid: 'view-findings' } });
  const detail = make('div', {
    class: 'view-detail', data: { testid: 'view-finding' }, 'aria-live': 'polite',
  });
  const element = make('div', { class: 'view-side' }, [title, list, detail]);
  return {
    element,
    showStage(stage) {
      const findings = findingsOf(stage);
      title.textContent = titleOf(findings, leftOut(stage));
      list.replaceChildren(...findings.map((finding) => make('li', {}, [button(finding, choose)])));
      list.hidden = findings.length === 0;
      detail.replaceChildren();
    },
    showFinding(stageIndex, finding) {
      for (const entry of list.querySelectorAll('button'))
        entry.setAttribute('aria-pressed', String(entry.dataset.findingId === finding?.id));
      detail.replaceChildren(...(finding ? details(report, stageIndex, finding) : []));
      setData(detail, finding);
      scrollWithin(list, list.querySelector('[aria-pressed=true]'));
    },
  };
}

function titleOf(findings, more) {
  if (findings.length === 0) return 'No findings in this stage';
  const beyond = findings.filter(exceeds).length;
  const count = findings.length === 1 ? '1 finding' : `${findings.length} findings`;
  if (more > 0) return `The worst ${findings.length} of ${findings.length + more} findings`;
  return beyond === 0 ? `${count}, none beyond a limit` : `${count}, worst first`;
}

function button(finding, choose) {
  return make('button', {
    type: 'button', class: `view-entry ${finding.kind}`, 'aria-pressed': 'false',
    data: { findingId: finding.id }, on: { click: () => choose(finding.id) },
  }, [
    make('b', { class: 'view-id', text: finding.id }),
    make('span', { class: 'view-headline', text: headline(finding) }),
    make('small', { text: whereOf(finding) }),
  ]);
}

function whereOf({ patch, triangle, line, raw_stock }) {
  const parts = [];
  if (raw_stock) parts.push('raw stock');
  else if (line) parts.push(`line ${line}`);
  if (triangle) parts.push(`triangle ${triangle}`);
  else if (patch !== undefined && patch !== null) parts.push(`patch ${patch}`);
  return parts.join(' · ');
}

/** Scrolls the list alone: the page must not move when a finding is chosen. */
function scrollWithin(list, entry) {
  if (!entry) return;
  const box = entry.getBoundingClientRect(), frame = list.getBoundingClientRect();
  if (box.top < frame.top) list.scrollTop -= frame.top - box.top;
  else if (box.bottom > frame.bottom) list.scrollTop += box.bottom - frame.bottom;
}

function details(report, stageIndex, finding) {
  const figures = [['Place', placeOf(finding)], [finding.triangle ? 'Triangle' : 'Patch', patchOf(finding)], ['Size', sizeOf(finding)],
    ['With', finding.with], ['Program', lineOf(report, stageIndex, finding)]];
  return [
    make('h4', {}, [
      make('b', { class: `view-id ${finding.kind}`, text: finding.id }), ' ', sentence(finding),
    ]),
    make('dl', {}, figures.filter(([, text]) => text).flatMap(([name, text]) =>
      [make('div', {}, [make('dt', { text: name }), make('dd', { text })])])),
    listing(programAround(report, stageIndex, finding), finding),
  ];
}

function sentence(finding) {
  if (finding.limit_mm === undefined) return headline(finding);
  const than = exceeds(finding) ? 'beyond the limit of' : 'within the limit of';
  return `${headline(finding)}, ${than} ${statedLength(finding.limit_mm)}`;
}

const placeOf = ({ point_mm }) => point_mm && `${point_mm.map(coordinate).join(', ')} mm`;

function patchOf({ patch, triangle, u, v }) {
  if (triangle) return String(triangle);
  return patch === undefined || patch === null ? '' : `${patch}, u ${parameter(u)}, v ${parameter(v)}`;
}

function sizeOf({ area_mm2, kind }) {
  if (kind === 'process' || !area_mm2) return '';
  return `about ${Number(area_mm2.toPrecision(2))} mm²`;
}

function lineOf(report, stageIndex, { line, stage, body, part, against, raw_stock }) {
  if (raw_stock) return 'no pass: a face of the raw stock';
  if (!line) return '';
  const name = report.stages[stage ?? stageIndex]?.name;
  const words = [`line ${line}`];
  if (name) words.push(` of ${name}`);
  if (part && against) words.push(`, ${part} against ${against}`);
  else if (body && body !== 'cutter') words.push(`, by the ${body}`);
  return words.join('');
}

function listing(lines, finding) {
  if (lines.length === 0) return '';
  const entry = ({ line, text }) => {
    const named = line === finding.line;
    return make('li', { class: named ? 'named' : '', 'aria-current': named && 'true' }, [
      make('span', { text: String(line) }), make('code', { text }),
    ]);
  };
  return make('ol', { class: exceeds(finding) ? 'view-listing beyond' : 'view-listing' }, lines.map(entry));
}

function setData(detail, finding) {
  const values = { id: finding?.id, depthMm: finding?.depth_mm, line: finding?.line };
  for (const [name, value] of Object.entries(values)) {
    if (value === undefined || value === null) delete detail.dataset[name];
    else detail.dataset[name] = String(value);
  }
}
