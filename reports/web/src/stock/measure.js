import { make } from '../base/dom.js';
import { coordinate, fixed, measuredLength } from '../base/format.js';
import { grouped } from '../base/figure_text.js';
import { length, subtract } from '../base/vector.js';

const SVG = 'http://www.w3.org/2000/svg';

/**
 * The distance between two points of the stock. Points are taken by clicking, or with the keyboard: Enter in
 * the picture, or the buttons, take what the middle of the picture shows.
 * @param {(middle: true) => number[]|null} pickMiddle the point in the middle of the picture, mm
 */
export function createMeasure(pickMiddle) {
  const points = { A: null, B: null };
  let scene = null, next = 'A', stock = null;
  const on = make('input', { type: 'checkbox', data: { testid: 'measure-on' } });
  const result = make('dl', { class: 'measure-result', 'aria-live': 'polite', data: { testid: 'measure-result' } });
  const error = make('p', { class: 'path-soft', data: { testid: 'measure-error' } });
  const taken = make('p', { class: 'path-soft', 'aria-live': 'polite' });
  const layer = overlay();
  const button = (name) => make('button', {
    type: 'button', data: { testid: `measure-${name}` }, text: `${name} in the middle of the picture`,
    on: { click: () => take(pickMiddle(), name) },
  });
  const clear = make('button', {
    type: 'button', text: 'Clear', data: { testid: 'measure-clear' }, on: { click: () => reset() },
  });
  const element = make('section', { class: 'measure', 'aria-label': 'Distance between two points' }, [
    make('div', { class: 'view-row' }, [
      make('label', { class: 'view-check' }, [on, 'Measure: a click takes a point']), button('A'), button('B'), clear,
    ]),
    taken, result, error,
  ]);

  const take = (point_mm, name = next) => {
    if (!point_mm) {
      taken.textContent = 'There is no stock at that place.';
      return;
    }
    if (name === 'A' && next === 'A') points.B = null;
    points[name] = [...point_mm];
    next = name === 'A' ? 'B' : 'A';
    show();
  };
  const reset = () => {
    points.A = points.B = null;
    next = 'A';
    show();
  };
  const show = () => {
    taken.textContent = points.A || points.B ? '' : 'No point is taken yet.';
    result.replaceChildren(...figures(points).map(([name, text]) =>
      make('div', {}, [make('dt', { text: name }), make('dd', { text, data: { figure: name } })])));
    error.textContent = stock ? errorWords(stock) : '';
    scene?.render();
  };
  const place = () => layer.place(points, scene);
  return {
    element, on: () => on.checked, take, reset,
    attach(to) {
      scene = to;
      scene.element.append(layer.element);
      scene.onFrame(place);
      show();
    },
    setStock(of) {
      stock = of;
      reset();
    },
    state: () => ({ ...points, distance_mm: points.A && points.B ? length(subtract(points.B, points.A)) : null }),
  };
}

function figures({ A, B }) {
  const list = [];
  for (const [name, point] of Object.entries({ A, B }))
    if (point) list.push([name, `X ${coordinate(point[0])}  Y ${coordinate(point[1])}  Z ${coordinate(point[2])} mm`]);
  if (!A || !B) return list;
  const way = subtract(B, A);
  list.push(['Distance', `${fixed(length(way), 3)} mm`]);
  ['dx', 'dy', 'dz'].forEach((name, axis) => list.push([name, `${fixed(way[axis], 3)} mm`]));
  return list;
}

/** How far a picked point may be from the stock: what was found where it was looked for. */
export function errorWords({ within_mm, checked, triangles, surface_triangles }) {
  const drawn = triangles < surface_triangles
    ? `${grouped(triangles)} triangles stand for the ${grouped(surface_triangles)} of the stock\u2019s surface. ` : '';
  return `Picking error: ${drawn}None of ${grouped(checked)} places checked on the picture\u2019s triangles lies `
    + `further than ${measuredLength(within_mm)} from the simulated stock; each point may be off by as much.`;
}

/** The two points and the way between them, over the picture. */
function overlay() {
  const line = document.createElementNS(SVG, 'line');
  const svg = document.createElementNS(SVG, 'svg');
  svg.append(line);
  const marks = Object.fromEntries(['A', 'B'].map((name) => [name, make('span', { class: 'measure-mark', text: name })]));
  const element = make('div', { class: 'measure-layer', 'aria-hidden': 'true' }, [svg, marks.A, marks.B]);
  return {
    element,
    place(points, scene) {
      const at = Object.fromEntries(Object.entries(points).map(([name, point]) => [name, point && scene.project(point)]));
      for (const [name, mark] of Object.entries(marks)) {
        mark.hidden = !at[name];
        if (at[name]) mark.style.transform = `translate(${at[name].x.toFixed(1)}px, ${at[name].y.toFixed(1)}px)`;
      }
      svg.style.display = at.A && at.B ? '' : 'none';
      if (!at.A || !at.B) return;
      for (const [key, value] of Object.entries({ x1: at.A.x, y1: at.A.y, x2: at.B.x, y2: at.B.y }))
        line.setAttribute(key, value.toFixed(1));
    },
  };
}
