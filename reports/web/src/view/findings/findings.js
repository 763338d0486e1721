import { measuredLength } from '../../base/format.js';

/**
 * All findings of a stage, the worst first: gouges and leftovers beyond their limit, by how many times,
 * then collisions and faults, then what is within its limit, then near misses.
 */
export function findingsOf(stage) {
  if (!sorted.has(stage)) sorted.set(stage, worstFirst(stage));
  return sorted.get(stage);
}

const sorted = new WeakMap();

/** How many findings the page leaves out: it lists no more than the worst of each kind. */
export function leftOut(stage) {
  return ['gouges', 'uncuts', 'process'].reduce((sum, kind) =>
    sum + Math.max(0, (stage[`${kind}_total`] ?? 0) - (stage[kind]?.length ?? 0)), 0);
}

function worstFirst({ gouges = [], uncuts = [], tolerated = [], process = [], limits }) {
  const all = [
    ...tolerated.map((finding) => (finding.id.startsWith('G')
      ? { ...finding, kind: 'gouge', limit_mm: limits?.gouge_mm }
      : { ...finding, kind: 'uncut', limit_mm: limits?.uncut_mm })),
    ...gouges.map((finding) => ({ ...finding, kind: 'gouge', limit_mm: limits?.gouge_mm })),
    ...uncuts.map((finding) => ({ ...finding, kind: 'uncut', limit_mm: limits?.uncut_mm })),
    ...process.map((finding) => ({ ...finding, kind: 'process', process: finding.kind,
      fails: finding.fails ?? finding.kind !== 'near_miss' })),
  ];
  return all.sort((a, b) => severity(b) - severity(a));
}

/** What stands before what, whatever the depth. */
const BEYOND_LIMIT = 2e9, FAILS = 1e9;

function severity(finding) {
  const { kind, depth_mm, limit_mm } = finding;
  if (kind === 'process') return finding.fails ? FAILS + (depth_mm ?? 0) : -1 / (1 + Math.abs(depth_mm ?? 0));
  // Without a limit nothing is exceeded: such findings follow those that count, the deeper first.
  if (!(limit_mm > 0)) return Math.min(1, depth_mm / 1e3);
  return depth_mm / limit_mm + (exceeds(finding) ? BEYOND_LIMIT : 0);
}

/** The same in a sentence's words: "49.9 µm too deep". */
export function headline(finding) {
  const over = finding.with === undefined ? '' : ' over the tolerances';
  if (finding.kind === 'gouge') return `${measuredLength(finding.depth_mm)} too deep${over}`;
  if (finding.kind === 'uncut') return `${measuredLength(finding.depth_mm)} left standing${over}`;
  const depth = finding.depth_mm;
  if (!depth) return finding.words;
  return finding.process === 'near_miss'
    ? `${finding.words}, ${measuredLength(Math.abs(depth))} away`
    : `${finding.words}, ${measuredLength(Math.abs(depth))} deep`;
}

/** Whether a finding alone would fail its gate. */
export function exceeds(finding) {
  if (finding.kind === 'process') return finding.fails;
  return finding.limit_mm !== undefined && finding.depth_mm > finding.limit_mm;
}

/** Lines around a finding's, of the stage whose program it is; empty where the page has none. */
export function programAround(report, stageIndex, finding, reach = 3) {
  if (finding.raw_stock || !finding.line) return [];
  const { text = [] } = report.stages[finding.stage ?? stageIndex] ?? {};
  return text.filter(({ line }) => Math.abs(line - finding.line) <= reach);
}
