const MOST_LINES = 24, MOST_SETTINGS = 30, BINS = 8;

/**
 * How a figure answers to a key: mean and range at each setting, and a line for each combination of the
 * other keys' settings where those are few enough to be told apart.
 * @param {object} study as decodeStudy gives it
 * @param {number[]} rows that count
 * @returns {{means: {at, mean, least, most, count}[], lines, points}} `lines` of [setting, value]; `points`
 *   ([setting, value, row]) where settings are drawn from a range: means are then of bins
 */
export function curvesOf(study, keyIndex, figure, rows) {
  const key = study.keys[keyIndex];
  const points = rows.map((row) => [key.value(row), figure.value(row), row])
    .filter(([, value]) => value !== null).sort((a, b) => a[0] - b[0]);
  const settings = new Set(points.map(([at]) => at)).size;
  const continuous = key.numeric && settings > MOST_SETTINGS;
  return {
    means: continuous ? meansOf(binned(points)) : meansOf(grouped(points, ([at]) => at)),
    lines: continuous ? [] : linesOf(study, keyIndex, points),
    points: continuous ? points : [],
  };
}

function grouped(points, groupOf) {
  const groups = new Map();
  for (const point of points) {
    const group = groupOf(point);
    if (!groups.has(group)) groups.set(group, []);
    groups.get(group).push(point);
  }
  return groups;
}

/** By as many parts of the range, of the same width. */
function binned(points) {
  const low = points[0][0], width = (points.at(-1)[0] - low) / BINS;
  return grouped(points, ([at]) => Math.min(BINS - 1, Math.floor((at - low) / width)));
}

function meansOf(groups) {
  const mean = (list, i) => list.reduce((sum, point) => sum + point[i], 0) / list.length;
  return [...groups.values()].map((list) => ({
    // A mean of equal settings need not be that setting to its last digit.
    at: list[0][0] === list.at(-1)[0] ? list[0][0] : mean(list, 0), mean: mean(list, 1), count: list.length,
    least: list.reduce((least, [, value]) => Math.min(least, value), Infinity),
    most: list.reduce((most, [, value]) => Math.max(most, value), -Infinity),
  }));
}

/** Of cases that differ in this key alone. */
function linesOf(study, keyIndex, points) {
  const others = study.keys.filter((_, i) => i !== keyIndex);
  const lines = grouped(points, ([, , row]) => others.map((key) => key.value(row)).join(' '));
  if (lines.size > MOST_LINES) return [];
  return [...lines.values()].filter((line) => line.length > 1).map((line) => line.map(([x, y]) => [x, y]));
}
