// The closed forms of tests/reports/sample_result.cpp, once more: what its page must say.

const length_mm = [80, 65], patches = [6, 5];

/** Height of the sample's shell over a place of the plane, mm. */
export const heightAt = (x, y) =>
  9 * Math.cos(x / 26) * Math.cos(y / 21) + 0.6 * Math.sin(x / 5) * Math.cos(y / 6);

/** What one stage's deviation is made of, mm. */
export const shapes = {
  rough: { scallop: 0.19, step: 9, at: [5, 5], gouge: 0.013, radius: 4 },
  failedSemiFinish: { scallop: 0.011, step: 0.25, at: [-12, 9], gouge: 0.0631, radius: 2.5 },
};

export function deviationAt(x, y, { scallop, step, at, gouge, radius }) {
  const cusp = Math.sin((Math.PI * y) / step) ** 2;
  const slope = 1 + 0.5 * Math.sin(x / 9) * Math.cos(y / 11);
  const r = Math.hypot(x - at[0], y - at[1]);
  return scallop * cusp * slope - gouge * Math.exp(-r * r / (radius * radius));
}

/** The point of a patch's parameters, mm. */
export function pointAt(patch, u, v) {
  const x = ((patch % patches[0] + u) / patches[0] - 0.5) * length_mm[0];
  const y = ((Math.floor(patch / patches[0]) + v) / patches[1] - 0.5) * length_mm[1];
  return [x, y, heightAt(x, y)];
}

/** The program line that the sample names for a patch. */
export const lineOf = (patch) => 100 + patch;

/**
 * The sample's path, rows over the shell: moves with end (mm), line and the time when they end (s).
 * @param step_mm path interval of the stage
 */
export function zigzag(step_mm) {
  const feed = 1200 / 60, rapid = 5000 / 60, moves = [], row = 8 * step_mm;
  let from = [-42, -34, 15], time_s = 0;
  const add = (to, speed) => {
    time_s += Math.hypot(...to.map((c, i) => c - from[i])) / speed;
    moves.push({ to, line: 10 + moves.length, end_s: time_s });
    from = to;
  };
  for (let k = 0; k * row <= length_mm[1]; ++k) {
    const y = -length_mm[1] / 2 + k * row, start = k % 2 === 0 ? -40 : 40;
    if (k === 0) add([start, y, 15], rapid);
    for (let i = 0; i <= 40; ++i) {
      const x = start * (1 - i / 20);
      add([x, y, heightAt(x, y)], feed);
    }
  }
  return moves;
}
