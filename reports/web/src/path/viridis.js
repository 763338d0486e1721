/** Matplotlib's viridis: even in lightness from dark to bright, readable with any colour vision. */
const STOPS = [
  [68, 1, 84], [72, 36, 117], [65, 68, 135], [53, 95, 141], [42, 120, 142], [33, 145, 140],
  [34, 168, 132], [68, 191, 112], [122, 209, 81], [189, 223, 38], [253, 231, 37],
];

/**
 * The colour of `share` of the scale, 0 (dark) to 1 (bright); what lies outside is held at its end.
 * @param {number} share
 * @returns {[number, number, number]} red, green, blue from 0 to 255
 */
export function viridis(share) {
  const at = Math.min(Math.max(share, 0), 1) * (STOPS.length - 1);
  const low = Math.min(Math.floor(at), STOPS.length - 2);
  return STOPS[low].map((c, i) => Math.round(c + (at - low) * (STOPS[low + 1][i] - c)));
}

/** The whole scale as a CSS gradient from left to right. */
export function viridisGradient() {
  const stops = STOPS.map((c, i) => `rgb(${c.join(' ')}) ${(100 * i) / (STOPS.length - 1)}%`);
  return `linear-gradient(to right, ${stops.join(', ')})`;
}
