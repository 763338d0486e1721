import { segmentOfMove, duration } from '../path/timeline.js';

const RAW = { light: [176, 180, 186], dark: [120, 126, 134] };
const PLAIN = { light: [142, 160, 184], dark: [132, 152, 180] };
/** Okabe and Ito's, but for black: told apart with any colour vision. */
const TOOLS = [[86, 180, 233], [230, 159, 0], [0, 158, 115], [204, 121, 167], [0, 114, 178], [213, 94, 0],
  [240, 228, 66]];

export const toolColour = (stage) => TOOLS[stage % TOOLS.length];
export const rawColour = (dark) => RAW[dark ? 'dark' : 'light'];
export const plainColour = (dark) => PLAIN[dark ? 'dark' : 'light'];

/** When each triangle's surface was cut, s from the first stage's begin on; NaN on the raw stock. */
export function removalTimes(stock, stages) {
  const begin = [];
  let total = 0;
  for (const { path } of stages) {
    begin.push(total);
    if (path) total += duration(path);
  }
  return Float32Array.from(stock.maker, (maker, k) => {
    const path = maker > 0 && stages[maker - 1]?.path;
    const segment = path ? segmentOfMove(path, stock.move[k]) : -1;
    return segment < 0 ? NaN : begin[maker - 1] + path.end_s[segment];
  });
}

/**
 * What the stock may be coloured by: `values` one a triangle, NaN where there is none, on a scale from `low`
 * to `high`; `plain` and `tool` have no scale.
 */
export function stockChoices(stock, stages) {
  const lines = Float32Array.from(stock.line, (line) => (line > 0 ? line : NaN));
  return [
    { key: 'tool', label: 'Tool' },
    scaled({ key: 'line', label: 'Program line', unit: '', values: lines }),
    scaled({ key: 'time', label: 'Time of removal', unit: 's', values: removalTimes(stock, stages) }),
    { key: 'plain', label: 'Nothing' },
  ];
}

function scaled(choice) {
  let low = Infinity, high = -Infinity;
  for (const value of choice.values)
    if (!Number.isNaN(value)) [low, high] = [Math.min(low, value), Math.max(high, value)];
  return low > high ? { ...choice, reason: 'nothing was cut' } : { ...choice, low, high, clipped: false };
}
