const CANNOT_REACH = 1, RAW_STOCK = 2, WORST_NEARBY = 4;

/**
 * What the report says about a place on the surface.
 *
 * Two meanings stand side by side. `deviation_mm`, `point_mm`, `u` and `v` are of the place itself,
 * interpolated over the triangle that is drawn, as the colours are. What cannot lie between two samples
 * (`line`, `stage`, `reachable`, `raw`) is of the nearest sample, `sample`, whose own deviation is
 * `sample_deviation_mm`: that one is a number of the measured field, unchanged.
 *
 * Where a field is too large to be shown whole, a sample may stand for the deepest place near it:
 * `worst_nearby`.
 *
 * @param {object} surface of the report, decoded
 * @param {object} field of a stage, decoded
 * @param {{point_mm, corners, weights}} hit of a picker
 */
export function readingAt(surface, field, { point_mm, corners, weights }) {
  const nearest = corners[weights.indexOf(Math.max(...weights))];
  const places = corners.map((corner) => surface.place(corner));
  const blend = (values) => values.reduce((sum, value, k) => sum + value * weights[k], 0);
  return {
    deviation_mm: blend(corners.map((corner) => field.deviation_mm[corner])),
    point_mm,
    patch: places[0].patch,
    u: blend(places.map((place) => place.u)),
    v: blend(places.map((place) => place.v)),
    ...ofSample(field, nearest),
  };
}

function ofSample(field, sample) {
  const flags = field.flags[sample];
  return {
    line: field.line[sample],
    stage: field.stage[sample],
    reachable: (flags & CANNOT_REACH) === 0,
    raw: (flags & RAW_STOCK) !== 0,
    worst_nearby: (flags & WORST_NEARBY) !== 0,
    sample,
    sample_deviation_mm: field.deviation_mm[sample],
  };
}
