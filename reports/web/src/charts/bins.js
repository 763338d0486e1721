import { beginning, duration, segmentOfMove } from '../path/timeline.js';

const MOST_BINS = 600;

/**
 * A path's figures over machining time, in at most 600 bins of the same length.
 * rate_mean is what was removed in a bin by its length, rapids and all; feed_mean is the mean over the
 * time at feed. Where a bin holds no feed move its feeds are null; without removal rates those are.
 * @param {object} path as decodeReport gives it
 * @returns {{width_s, rate: {max, mean}[]|null, feed: ({max, mean}|null)[]}} mm3/min and mm/min
 */
export function processBins(path, most = MOST_BINS) {
  const total = duration(path), count = Math.min(most, path.end_s.length);
  if (count === 0 || !(total > 0)) return { width_s: 0, rate: null, feed: [] };
  const width = total / count;
  const [atFeed, feedSum, feedMax, rateSum, rateMax] =
    Array.from({ length: 5 }, () => new Float64Array(count));
  forEachShare(path, width, count, (bin, segment, seconds) => {
    const rate = path.rate_mm3_min ? path.rate_mm3_min[segment] : 0;
    rateSum[bin] += rate * seconds;
    rateMax[bin] = Math.max(rateMax[bin], rate);
    if (path.kind[segment] === 0) return;
    atFeed[bin] += seconds;
    feedSum[bin] += path.feed_mm_min[segment] * seconds;
    feedMax[bin] = Math.max(feedMax[bin], path.feed_mm_min[segment]);
  });
  const each = (figure) => Array.from({ length: count }, (_, i) => figure(i));
  return {
    width_s: width,
    rate: path.rate_mm3_min ? each((i) => ({ max: rateMax[i], mean: rateSum[i] / width })) : null,
    feed: each((i) => (atFeed[i] > 0 ? { max: feedMax[i], mean: feedSum[i] / atFeed[i] } : null)),
  };
}

/** Calls `add(bin, segment, seconds)` for each part of a segment that lies in one bin. */
function forEachShare(path, width, count, add) {
  for (let segment = 0; segment < path.end_s.length; ++segment) {
    const from = beginning(path, segment), to = path.end_s[segment];
    const first = Math.min(Math.floor(from / width), count - 1);
    const last = Math.min(Math.max(Math.ceil(to / width) - 1, first), count - 1);
    for (let bin = first; bin <= last; ++bin) {
      const upper = bin === count - 1 ? to : Math.min(to, (bin + 1) * width);
      const seconds = upper - Math.max(from, bin * width);
      if (seconds > 0) add(bin, segment, seconds);
    }
  }
}

/** Volume removed according to the bins, mm3. */
export function binnedVolume(bins) {
  return (bins.rate ?? []).reduce((sum, { mean }) => sum + (mean * bins.width_s) / 60, 0);
}

/**
 * When the moves of the process findings end, in the order of time.
 * @param {{id, kind, words, line, move}[]} findings
 * @returns {{id, kind, words, line, time_s}[]}
 */
export function findingTimes(path, findings) {
  return findings
    .map((finding) => ({ ...finding, segment: segmentOfMove(path, finding.move) }))
    .filter(({ segment }) => segment >= 0)
    .map(({ id, kind, words, line, segment }) => ({ id, kind, words, line, time_s: path.end_s[segment] }))
    .sort((a, b) => a.time_s - b.time_s);
}

/** A histogram's bins that hold anything: {low_mm, high_mm, area_mm2, side: 'gouge'|'inside'|'uncut'}. */
export function histogramBars({ edges_mm, area_mm2 }, limits) {
  return area_mm2
    .map((area, i) => ({ low_mm: edges_mm[i], high_mm: edges_mm[i + 1], area_mm2: area }))
    .filter((bar) => bar.area_mm2 > 0)
    .map((bar) => ({ ...bar, side: sideOf((bar.low_mm + bar.high_mm) / 2, limits) }));
}

/** As the static picture colours its bars. */
function sideOf(middle_mm, { gouge_mm, uncut_mm }) {
  if (gouge_mm !== undefined && middle_mm < -gouge_mm) return 'gouge';
  if (uncut_mm !== undefined && middle_mm > uncut_mm) return 'uncut';
  return 'inside';
}

/** Where a bin lies, in words; one that holds a limit is on neither side of it. */
export function placeWords({ low_mm, high_mm }, { gouge_mm, uncut_mm }) {
  if (gouge_mm !== undefined && low_mm < -gouge_mm)
    return high_mm <= -gouge_mm ? 'beyond the gouge limit' : 'across the gouge limit';
  if (uncut_mm !== undefined && high_mm > uncut_mm)
    return low_mm >= uncut_mm ? 'beyond the uncut limit' : 'across the uncut limit';
  if (gouge_mm === undefined && uncut_mm === undefined) return 'no limit stated';
  return 'within the limits';
}

/**
 * The histogram's axis in mm: what was measured, zero, and the limits that lie near it.
 * @returns {{low_mm, high_mm}}
 */
export function histogramAxis({ edges_mm }, { gouge_mm, uncut_mm }) {
  let low = Math.min(edges_mm[0], 0), high = Math.max(edges_mm[edges_mm.length - 1], 0);
  const reach = 1.6 * (high - low);
  if (gouge_mm !== undefined && gouge_mm <= reach) low = Math.min(low, -gouge_mm);
  if (uncut_mm !== undefined && uncut_mm <= reach) high = Math.max(high, uncut_mm);
  const margin = 0.03 * (high - low);
  return { low_mm: low - margin, high_mm: high + margin };
}

/** The lower end of a logarithmic axis of areas: the power of ten at or below the least one. */
export function leastDecade(bars) {
  return 10 ** Math.floor(Math.log10(Math.min(...bars.map(({ area_mm2 }) => area_mm2))));
}
