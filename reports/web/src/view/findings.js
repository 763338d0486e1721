import { measuredLength } from './format.js';

const KINDS = { G: 'gouge', U: 'uncut', P: 'process' };

/**
 * All findings of a stage, the worst first: collisions, then gouges and leftovers by how many times
 * they exceed their limit, then near misses.
 */
export function findingsOf(stage) {
  const all = [
    ...(stage.gouges ?? []).map((finding) => ({ ...finding, kind: 'gouge', limit_mm: stage.limits?.gouge_mm })),
    ...(stage.uncuts ?? []).map((finding) => ({ ...finding, kind: 'uncut', limit_mm: stage.limits?.uncut_mm })),
    ...(stage.process ?? []).map((finding) => ({ ...finding, kind: 'process', process: finding.kind })),
  ];
  return all.sort((a, b) => severity(b) - severity(a));
}

const COLLISION = 1e9;

function severity({ kind, process, depth_mm, limit_mm }) {
  if (kind === 'process') return process === 'near_miss' ? -1 / (1 + Math.abs(depth_mm ?? 0)) : COLLISION + (depth_mm ?? 0);
  // Without a limit nothing is exceeded: such findings follow those that count, the deeper first.
  return limit_mm > 0 ? depth_mm / limit_mm : Math.min(1, depth_mm / 1e3);
}

/** The same in a sentence's words: "49.9 µm too deep". */
export function headline(finding) {
  if (finding.kind === 'gouge') return `${measuredLength(finding.depth_mm)} too deep`;
  if (finding.kind === 'uncut') return `${measuredLength(finding.depth_mm)} left standing`;
  const depth = finding.depth_mm;
  if (!depth) return finding.words;
  return finding.process === 'near_miss'
    ? `${finding.words}, ${measuredLength(Math.abs(depth))} away`
    : `${finding.words}, ${measuredLength(Math.abs(depth))} deep`;
}

/** Whether a finding alone would fail its gate. */
export function exceeds(finding) {
  if (finding.kind === 'process') return finding.process !== 'near_miss';
  return finding.limit_mm !== undefined && finding.depth_mm > finding.limit_mm;
}

export const kindOfId = (id) => KINDS[id[0]];

/** Lines of program text around `line`, from what the page holds; empty where it holds none. */
export function programAround(report, stageIndex, finding, reach = 3) {
  const near = (stage) => (stage?.text ?? []).filter(({ line }) => Math.abs(line - finding.line) <= reach);
  const own = near(report.stages[finding.stage ?? stageIndex]);
  return own.some(({ line }) => line === finding.line) ? own : near(report.stages[stageIndex]);
}
