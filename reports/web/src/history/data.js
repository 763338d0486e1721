import { fixed, threeDigits, unitFor } from '../base/format.js';

/**
 * The page's data, as reports/history/history_json.cpp writes them, with what charts need of them:
 * runs have `index` and `time_ms`, series a `scale`.
 * @returns {{file: string, jobs: object[]}}
 */
export function decodeHistory(root) {
  const history = JSON.parse(root.getElementById('limitgauge-data').textContent);
  if (history.schema !== 'limitgauge.history/1') throw new Error(`unknown data: ${history.schema}`);
  for (const job of history.jobs) {
    job.runs.forEach((run, index) => Object.assign(run, { index, time_ms: Date.parse(run.created) }));
    for (const series of job.series) series.scale = scaleOf(series);
  }
  return history;
}

/** Of what the figures are shown in: lengths in one unit, shares in percent. */
export function scaleOf({ unit, metric, values }) {
  if (metric === 'coverage') return { factor: 100, symbol: '%' };
  if (unit !== 'mm') return { factor: 1, symbol: unit };
  const ends = values.flatMap((value) => (value ? [value.low, value.high] : []));
  const { perMm, symbol } = unitFor(Math.max(0, ...ends.map(Math.abs)));
  return { factor: perMm, symbol };
}

/** "finish gouge" */
export const seriesTitle = ({ stage, label }) => (stage ? `${stage} ${label}` : label);

/** Of these the lower end is promised: the more, the better. */
const PROMISED_LOW = ['coverage', 'margin'];

/** What a figure of the series is drawn at: of an interval the end that the gate is held against. */
export const drawnAt = (series, value) =>
  (PROMISED_LOW.includes(series.metric) ? value.low : value.high) * series.scale.factor;

/**
 * How a figure itself stands against its limit: the mark of a run that failed stands at the figure that
 * failed, and at no other. Of a figure without a limit nothing can be said.
 * @returns {'pass'|'fail'|'indeterminate'|'no limit'}
 */
export function standingOf({ metric }, value) {
  if (!value || value.limit === undefined) return 'no limit';
  const { low, high, limit } = value;
  if (metric === 'coverage') return low >= limit ? 'pass' : 'fail';
  if (high <= limit) return 'pass';
  return low > limit ? 'fail' : 'indeterminate';
}

/** A commit as short as it tells, or the label, or the number. */
export function runName(run) {
  if (run.commit) return /^[0-9a-f]{11,}$/i.test(run.commit) ? run.commit.slice(0, 7) : run.commit;
  return run.label || `run ${run.id}`;
}

const number = (shown) => (Math.abs(shown) >= 1000 ? fixed(shown, 0) : threeDigits(shown));

/** A certified interval is rounded outwards, so that what is shown stays true. */
export function figureText({ scale, source, metric }, value) {
  if (!value) return 'not measured';
  const unit = scale.symbol ? ` ${scale.symbol}` : '';
  const [low, high] = [value.low, value.high].map((end) => end * scale.factor);
  const limit = value.limit === undefined ? undefined : statedLimit(scale, value.limit);
  if (metric === 'coverage') return `${roundedText(low, 2, Math.floor, limit)}${unit}`;
  if (source !== 'certified') return `${number(high)}${unit}`;
  return `${intervalText(low, high, limit, scale)}${unit}`;
}

const statedLimit = (scale, limit) => Number((limit * scale.factor).toPrecision(12));

function intervalText(low, high, limit, { symbol }) {
  if (low === 0 && high === 0) return '[0, 0]';
  // A tenth of a nanometre is the last that is shown, in either unit.
  const digits = high > low ? Math.ceil(-Math.log10((high - low) / 5)) : 4;
  const decimals = Math.min(symbol === 'mm' ? 7 : 4, Math.max(0, digits));
  return `[${roundedText(low, decimals, Math.floor, limit)}, ${roundedText(high, decimals, Math.ceil, limit)}]`;
}

/** As model/text/rounded.h has it: what is printed lies on the side of the limit that the figure lies on. */
function roundedText(value, decimals, round, limit) {
  const side = Math.sign(near(value, limit) ? 0 : value - limit);
  for (let places = decimals; ; ++places) {
    const shown = rounded(value, places, round);
    if (limit === undefined || places >= 15 || Math.sign(shown - limit) === side) return fixed(shown, places);
  }
}

/** Two numbers that only the binary form of one tells apart. */
const near = (value, limit) => Math.abs(value - limit) <= 4e-16 * Math.abs(limit);

/** What already has no more places, but for the last bits of its binary form, stays. */
function rounded(value, places, round) {
  const scale = 10 ** places, nearest = Math.round(value * scale);
  return (Math.abs(value * scale - nearest) < 1e-6 ? nearest : round(value * scale)) / scale;
}

/** "limit 30 µm" */
export function limitText({ scale }, limit) {
  const figure = statedLimit(scale, limit);
  return `limit ${figure}${scale.symbol ? ` ${scale.symbol}` : ''}`;
}

/** "2026-11-22 01:37 UTC" */
export const momentText = ({ created }) => `${created.slice(0, 16).replace('T', ' ')} UTC`;

/** The run nearest to a place on the axis, which counts runs or milliseconds. */
export function nearestRun(runs, at, byTime) {
  if (!byTime) return runs[Math.min(runs.length - 1, Math.max(0, Math.round(at)))];
  const distance = (run) => Math.abs(run.time_ms - at);
  return runs.reduce((best, run) => (distance(run) <= distance(best) ? run : best));
}
