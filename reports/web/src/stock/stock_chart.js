import { fixed } from '../base/format.js';
import { profileAxes } from '../view/section/section.js';

const SVG = 'http://www.w3.org/2000/svg';
const USUAL_WIDTH = 1000, MOST_HEIGHT = 320, LEFT = 118, RIGHT = 18, TOP = 34, BOTTOM = 26;
const AXES = 'XYZ';

/** A drawing to scale of the stock cut by a plane, with the dimensions of what is drawn. */
export function createStockChart() {
  const svg = node('svg', { class: 'view-chart', role: 'img', 'data-testid': 'stock-section-chart' });
  return {
    element: svg,
    /** @param {object[]} pieces of cutCurve @returns {object|null} its extent, mm */
    show(pieces, axis) {
      svg.replaceChildren();
      svg.style.display = pieces.length > 0 ? '' : 'none';
      return pieces.length > 0 ? draw(svg, pieces, profileAxes(axis)) : null;
    },
  };
}

function node(tag, attributes, text) {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  if (text !== undefined) element.textContent = text;
  return element;
}

/** Least and greatest of the pieces' ends on one axis. */
export function extent(pieces, axis) {
  let low = Infinity, high = -Infinity;
  for (const { from, to } of pieces)
    for (const point of [from, to]) [low, high] = [Math.min(low, point[axis]), Math.max(high, point[axis])];
  return { low, high, size: high - low };
}

function draw(svg, pieces, [along, up]) {
  const across = extent(pieces, along), height = extent(pieces, up);
  const width = svg.clientWidth || USUAL_WIDTH;
  const scale = Math.min((width - LEFT - RIGHT) / (across.size || 1),
    (MOST_HEIGHT - TOP - BOTTOM) / (height.size || 1));
  const bottom = TOP + height.size * scale;
  svg.setAttribute('viewBox', `0 0 ${width} ${Math.ceil(bottom + BOTTOM)}`);
  svg.style.height = `${Math.ceil(bottom + BOTTOM)}px`;
  const x = (mm) => LEFT + (mm - across.low) * scale, y = (mm) => bottom - (mm - height.low) * scale;
  const path = pieces.map(({ from, to }) =>
    `M${x(from[along]).toFixed(1)} ${y(from[up]).toFixed(1)}L${x(to[along]).toFixed(1)} ${y(to[up]).toFixed(1)}`)
    .join('');
  svg.append(node('path', { d: path, class: 'outline' }));
  dimension(svg, [x(across.low), TOP - 14], [x(across.high), TOP - 14], `${fixed(across.size, 3)} mm`);
  dimension(svg, [LEFT - 14, y(height.low)], [LEFT - 14, y(height.high)], `${fixed(height.size, 3)} mm`);
  for (const [mm, anchor] of [[across.low, 'start'], [across.high, 'end']])
    svg.append(node('text', { x: x(mm), y: bottom + 18, 'text-anchor': anchor },
      `${AXES[along]} ${fixed(mm, 3)}`));
  const words = `Section: ${AXES[along]} from ${fixed(across.low, 3)} to ${fixed(across.high, 3)} mm, `
    + `${AXES[up]} from ${fixed(height.low, 3)} to ${fixed(height.high, 3)} mm`;
  svg.setAttribute('aria-label', words);
  return { along, up, across, height, words };
}

/** A dimension line with its figure. */
function dimension(svg, [x1, y1], [x2, y2], text) {
  svg.append(node('line', { x1, y1, x2, y2, class: 'zero' }));
  const upright = x1 === x2;
  for (const [x, y] of [[x1, y1], [x2, y2]])
    svg.append(node('line', upright ? { x1: x - 5, x2: x + 5, y1: y, y2: y, class: 'zero' }
      : { x1: x, x2: x, y1: y - 5, y2: y + 5, class: 'zero' }));
  svg.append(node('text', upright
    ? { x: x1 - 8, y: (y1 + y2) / 2 + 4, 'text-anchor': 'end' }
    : { x: (x1 + x2) / 2, y: y1 - 6, 'text-anchor': 'middle' }, text));
}
