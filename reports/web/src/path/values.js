import { statedLength } from '../base/format.js';
import { beginning, duration } from './timeline.js';
import { grouped } from '../base/figure_text.js';

const FEED = 1;

/**
 * What the path may be coloured by. `values` is one number a segment, `low` and `high` are the ends of
 * the scale; `clipped` where some segments lie beyond `high`. A choice that the data have no figures
 * for has a `reason` instead.
 * @returns {{key, label, unit, reason?, values?, low?, high?, clipped?}[]}
 */
export function colourChoices(path) {
  return [order(path), feed(path), rate(path), line(path)];
}

function order(path) {
  return {
    key: 'order', label: 'Order (machining time)', unit: 's', values: path.end_s,
    low: 0, high: duration(path), clipped: false,
  };
}

function feed(path) {
  const choice = { key: 'feed', label: 'Feed', unit: 'mm/min' };
  const [low, high] = extremes(path, path.feed_mm_min);
  if (low > high) return { ...choice, reason: 'this path has no feed moves' };
  return { ...choice, values: path.feed_mm_min, low, high, clipped: false };
}

function rate(path) {
  const choice = { key: 'rate', label: 'Removal rate', unit: 'mm\u00b3/min' };
  if (!path.rate_mm3_min) return { ...choice, reason: 'the report holds no removal rates of this stage' };
  const most = extremes(path, path.rate_mm3_min)[1];
  if (!(most > 0)) return { ...choice, reason: 'this path removes nothing' };
  // A few short peaks would leave one colour for all the rest.
  const usual = quantileInTime(path, path.rate_mm3_min, 0.9);
  const high = usual > 0 ? usual : most;
  return { ...choice, values: path.rate_mm3_min, low: 0, high, clipped: most > high };
}

function line(path) {
  const choice = { key: 'line', label: 'Program line', unit: '' };
  const [low, high] = extremes(path, path.line);
  if (!(high > 0)) return { ...choice, reason: 'its moves have no program lines' };
  return { ...choice, values: path.line, low, high, clipped: false };
}

/** Least and largest of `values` over the feed moves. */
function extremes(path, values) {
  let low = Infinity, high = -Infinity;
  for (let i = 0; i < values.length; ++i) {
    if (path.kind[i] !== FEED) continue;
    if (values[i] < low) low = values[i];
    if (values[i] > high) high = values[i];
  }
  return [low, high];
}

/** The value that the feed moves do not exceed during `share` of their time. */
export function quantileInTime(path, values, share) {
  const seconds = (i) => path.end_s[i] - beginning(path, i);
  const order = [];
  let total = 0;
  for (let i = 0; i < values.length; ++i)
    if (path.kind[i] === FEED) {
      order.push(i);
      total += seconds(i);
    }
  if (order.length === 0) return 0;
  order.sort((a, b) => values[a] - values[b]);
  let passed = 0;
  for (const i of order) if ((passed += seconds(i)) >= share * total) return values[i];
  return values[order[order.length - 1]];
}

/** Where `value` lies on a choice's scale, 0 to 1; the middle where the scale has no length. */
export function shareOf(choice, value) {
  if (!(choice.high > choice.low)) return 0.5;
  return Math.min(Math.max((value - choice.low) / (choice.high - choice.low), 0), 1);
}

/** Numbers for a legend, from `low` to `high`: its ends and what lies evenly between. */
export function legendTicks(choice, count) {
  if (!(choice.high > choice.low)) return [choice.low];
  return Array.from({ length: count }, (_, i) => choice.low + (i * (choice.high - choice.low)) / (count - 1));
}

/** How much of the program is drawn and how exactly, in words. */
export function exactness(path) {
  const moves = grouped(path.moves);
  if (!(path.within_mm > 0) && !(path.axis?.within_deg > 0)) return `All ${moves} moves of the program are drawn.`;
  return `${grouped(path.end_s.length)} lines are drawn for the ${moves} moves of the program: ` +
    `every move lies within ${statedLength(roundedUp(path.within_mm))} of what is drawn${axisWords(path)}.`;
}

function axisWords({ axis }) {
  return axis?.within_deg > 0 ? `, its tool’s axis within ${roundedUp(axis.within_deg)}°` : '';
}

/** To two digits, upwards: what is said stays true. */
function roundedUp(value) {
  const unit = 10 ** (Math.floor(Math.log10(value)) - 1);
  return Number((Math.ceil(value / unit - 1e-9) * unit).toPrecision(12));
}
