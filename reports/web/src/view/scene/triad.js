import { axes } from './camera.js';

const SVG = 'http://www.w3.org/2000/svg';
const ARM = 24, MIDDLE = 36;

/** The directions of X, Y and Z in a corner of the picture. */
export function createTriad(scene) {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('class', 'view-triad');
  svg.setAttribute('viewBox', `0 0 ${2 * MIDDLE} ${2 * MIDDLE}`);
  svg.setAttribute('aria-hidden', 'true');
  const arms = [...'XYZ'].map((name) => {
    const line = document.createElementNS(SVG, 'line'), text = document.createElementNS(SVG, 'text');
    text.textContent = name;
    svg.append(line, text);
    return { line, text };
  });
  scene.element.append(svg);
  scene.onFrame(() => {
    const { right, up, back } = axes(scene.camera());
    arms.forEach(({ line, text }, k) => {
      const [x, y] = [right[k], -up[k]];
      const ends = { x1: MIDDLE, y1: MIDDLE, x2: MIDDLE + ARM * x, y2: MIDDLE + ARM * y };
      for (const [name, value] of Object.entries(ends)) line.setAttribute(name, value.toFixed(2));
      text.setAttribute('x', (MIDDLE + (ARM + 7) * x).toFixed(2));
      text.setAttribute('y', (MIDDLE + (ARM + 7) * y).toFixed(2));
      // An axis that points at the reader or away has no direction in the picture.
      const shown = Math.abs(back[k]) < 0.98;
      line.style.display = text.style.display = shown ? '' : 'none';
    });
  });
}
