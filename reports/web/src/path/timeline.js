import { endAxis, turnedAxis } from './pose.js';

/**
 * The toolpath against machining time. A path is what `decodeReport` gives: segment i runs from the end
 * of segment i - 1 (from `start_mm` where i is 0) to its own, and ends at `end_s[i]` seconds.
 */

/** Machining time of the whole path, s. */
export function duration(path) {
  const count = path.end_s.length;
  return count > 0 ? path.end_s[count - 1] : 0;
}

/** Machining time at which segment `index` begins, s. */
export function beginning(path, index) {
  return index > 0 ? path.end_s[index - 1] : 0;
}

/** The first segment that ends at or after `time_s`: the one under way; the last one beyond the end. */
export function segmentAt(path, time_s) {
  let low = 0, high = path.end_s.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (path.end_s[middle] < time_s) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** The first segment that holds `move` of the program or a later one; -1 where there is none. */
export function segmentOfMove(path, move) {
  let low = 0, high = path.move.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (path.move[middle] < move) low = middle + 1;
    else high = middle;
  }
  return low < path.move.length ? low : -1;
}

/**
 * When the tool is nearest to a place, s: on the segment of `move`, or of the whole path where no move is
 * named or it is none of the path's.
 */
export function timeNear(path, point_mm, move) {
  const named = move === undefined || move === null ? -1 : segmentOfMove(path, move);
  const [first, last] = named >= 0 ? [named, named] : [0, path.end_s.length - 1];
  let best = { distance: Infinity, time_s: 0 };
  for (let i = first; i <= last; ++i) {
    const { share, distance } = nearestOn(endPoint(path, i - 1), endPoint(path, i), point_mm);
    const from = beginning(path, i);
    if (distance < best.distance) best = { distance, time_s: from + share * (path.end_s[i] - from) };
  }
  return best.time_s;
}

/** The point of a segment nearest to `p`: how far along it, 0 to 1, and its distance. */
function nearestOn(a, b, p) {
  const along = b.map((c, k) => c - a[k]), square = along.reduce((sum, c) => sum + c * c, 0);
  const dot = along.reduce((sum, c, k) => sum + c * (p[k] - a[k]), 0);
  const share = square > 0 ? Math.min(1, Math.max(0, dot / square)) : 1;
  return { share, distance: Math.hypot(...a.map((c, k) => c + share * along[k] - p[k])) };
}

/** Where segment `index` ends, mm; its beginning is the end of the one before. */
export function endPoint(path, index) {
  return Array.from(index < 0 ? path.start_mm : path.positions.subarray(3 * index, 3 * index + 3));
}

/**
 * What the machine does at `time_s`.
 * @returns {{segment, time_s, point_mm, kind: 'rapid'|'feed', feed_mm_min, rate_mm3_min: number|null,
 *   line, move, axis: [i, j, k]|null}} `axis`: the tool's, of a path that turns it
 */
export function instant(path, time_s) {
  const time = Math.min(Math.max(time_s, 0), duration(path));
  const segment = segmentAt(path, time);
  const from = beginning(path, segment), length = path.end_s[segment] - from;
  const share = length > 0 ? (time - from) / length : 1;
  const a = endPoint(path, segment - 1), b = endPoint(path, segment);
  return {
    segment,
    time_s: time,
    point_mm: a.map((c, i) => c + share * (b[i] - c)),
    kind: path.kind[segment] === 0 ? 'rapid' : 'feed',
    feed_mm_min: path.feed_mm_min[segment],
    rate_mm3_min: path.rate_mm3_min ? path.rate_mm3_min[segment] : null,
    line: path.line[segment],
    move: path.move[segment],
    axis: path.axis ? turnedAxis(endAxis(path, segment - 1), endAxis(path, segment), share) : null,
  };
}

/**
 * The end of the segment after (`direction` 1) or before (-1) what stands at `time_s`, s. A segment that
 * takes no time, as where the tool turns about its tip, is passed together with the next one.
 */
export function stepTime(path, time_s, direction) {
  let here = segmentAt(path, time_s);
  if (direction < 0) return beginning(path, here);
  while (here < path.end_s.length - 1 && path.end_s[here] <= time_s) here += 1;
  return path.end_s[here];
}

/**
 * A slider over `total_s` seconds: its step is 1, 2 or 5 times a power of ten, so that there are 500 to
 * 1250 steps, and its last step is the end or just after it.
 * @returns {{step_s, max_s, decimals}} decimals: of a time as the slider states it
 */
export function sliderScale(total_s) {
  if (!(total_s > 0)) return { step_s: 1, max_s: 0, decimals: 0 };
  const power = Math.floor(Math.log10(total_s / 500));
  const rough = total_s / 500 / 10 ** power;
  const decimals = Math.max(0, -power);
  const step = Number(((rough >= 5 ? 5 : rough >= 2 ? 2 : 1) * 10 ** power).toFixed(decimals));
  const steps = Math.ceil(total_s / step - 1e-6);
  return { step_s: step, max_s: Number((steps * step).toFixed(decimals)), decimals };
}

/** How many seconds of machining play in one, so that the path takes about half a minute. */
export function usualSpeed(total_s, speeds) {
  const wanted = total_s / 30;
  return speeds.reduce((best, s) =>
    Math.abs(Math.log(s / wanted)) < Math.abs(Math.log(best / wanted)) ? s : best);
}
