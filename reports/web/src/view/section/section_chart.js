import { colour, css } from '../colour/colour_scale.js';
import { fixed, scaleUnit, signedLength } from '../../base/format.js';
import { profileAxes } from './section.js';

const SVG = 'http://www.w3.org/2000/svg';
const USUAL_WIDTH = 1000, HEIGHT = 190, TOP = 12, BOTTOM = 24, LEFT = 78, RIGHT = 12;
const AXES = 'XYZ';

/** A drawing of the deviation along a section, coloured as the map, with the gate limits as lines. */
export function createSectionChart() {
  const svg = element('svg', {
    class: 'view-chart', role: 'img', 'data-testid': 'view-section-chart',
  });
  return {
    element: svg,
    /** @param {{axis, bounds_mm, scale, sign, band}} look */
    show(pieces, look) {
      svg.replaceChildren();
      svg.style.display = pieces.length > 0 ? '' : 'none';
      // As many units as pixels: text keeps its size on narrow pages.
      const width = svg.clientWidth || USUAL_WIDTH;
      svg.setAttribute('viewBox', `0 0 ${width} ${HEIGHT}`);
      if (pieces.length > 0) draw(svg, pieces, { ...look, width });
      svg.setAttribute('aria-label', 'Deviation along the section');
    },
  };
}

function element(tag, attributes, text) {
  const node = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  if (text !== undefined) node.textContent = text;
  return node;
}

function draw(svg, pieces, look) {
  const [along] = profileAxes(look.axis);
  const { scale, bounds_mm } = look;
  const [low, high] = [bounds_mm[0][along], bounds_mm[1][along]];
  const x = (mm) => LEFT + ((mm - low) / (high - low || 1)) * (look.width - LEFT - RIGHT);
  const { uncut, gouge } = reach(pieces, scale);
  const top = look.sign > 0 ? uncut : gouge;
  const perMm = (HEIGHT - TOP - BOTTOM) / (uncut + gouge);
  const y = (deviation_mm) => TOP + (top - deviation_mm * look.sign) * perMm;
  svg.append(gradient(look, y));
  const zero = y(0);
  const path = pieces.map(({ from, to, deviation_mm: [a, b] }) => {
    const [p, q] = [x(from[along]).toFixed(1), x(to[along]).toFixed(1)];
    return `M${p} ${zero}V${y(a).toFixed(2)}L${q} ${y(b).toFixed(2)}V${zero}Z`;
  }).join('');
  svg.append(element('path', { d: path, class: 'profile', fill: 'url(#view-profile-colours)' }));
  const outline = pieces.map(({ from, to, deviation_mm: [a, b] }) => {
    const [p, q] = [x(from[along]).toFixed(1), x(to[along]).toFixed(1)];
    return `M${p} ${y(a).toFixed(2)}L${q} ${y(b).toFixed(2)}`;
  }).join('');
  svg.append(element('path', { d: outline, class: 'outline' }));
  drawRules(svg, look, y, scaleUnit(Math.max(scale.uncut.end_mm, scale.gouge.end_mm)));
  for (const [mm, anchor] of [[low, 'start'], [(low + high) / 2, 'middle'], [high, 'end']])
    svg.append(element('text', { x: x(mm), y: HEIGHT - 6, 'text-anchor': anchor },
      `${AXES[along]} ${fixed(mm, 1)}`));
}

/** How far the drawing reaches on each side: over the limit and what the section holds, with room. */
function reach(pieces, scale) {
  let uncut = 0, gouge = 0;
  for (const { deviation_mm } of pieces)
    for (const mm of deviation_mm) [uncut, gouge] = [Math.max(uncut, mm), Math.max(gouge, -mm)];
  const side = ({ limit_mm, end_mm, hasLimit }, largest) =>
    1.12 * Math.max(largest, hasLimit ? limit_mm : 0.1 * end_mm);
  return { uncut: side(scale.uncut, uncut), gouge: side(scale.gouge, gouge) };
}

/** Zero and the limits as lines; a figure that would lie on zero's is left out. */
function drawRules(svg, { scale, sign, width }, y, unit) {
  rule(svg, width, y(0), 'zero', '0');
  for (const [side, way] of [[scale.uncut, 1], [scale.gouge, -1]]) {
    if (!side.hasLimit) continue;
    const at = y(way * side.limit_mm);
    const figure = signedLength(sign * way * side.limit_mm, unit);
    rule(svg, width, at, 'limit', Math.abs(at - y(0)) > 15 ? figure : '');
  }
}

function rule(svg, width, y, name, text) {
  svg.append(element('line', { x1: LEFT, x2: width - RIGHT, y1: y, y2: y, class: name }));
  svg.append(element('text', { x: LEFT - 8, y: y + 4, 'text-anchor': 'end' }, text));
}

/** Colours by height: the same scale as the map's, with its jumps. */
function gradient({ scale, band }, y) {
  const ends = [y(scale.uncut.end_mm), y(-scale.gouge.end_mm)];
  const node = element('linearGradient', {
    id: 'view-profile-colours', gradientUnits: 'userSpaceOnUse', x1: 0, x2: 0, y1: ends[0], y2: ends[1],
  });
  const places = [];
  for (const [side, way] of [[scale.uncut, 1], [scale.gouge, -1]]) {
    const { limit_mm, end_mm } = side;
    const bends = [0, limit_mm / 2, limit_mm, limit_mm * (1 + 1e-6), (limit_mm + end_mm) / 2, end_mm];
    places.push(...bends.map((mm) => way * mm));
  }
  places.sort((a, b) => b - a);
  for (const mm of places)
    node.append(element('stop', {
      offset: (y(mm) - ends[0]) / (ends[1] - ends[0]), 'stop-color': css(colour(scale, mm, band)),
    }));
  return node;
}
