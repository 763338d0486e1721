import { colour, css, position, ticks_mm } from './colour_scale.js';
import { make } from '../../base/dom.js';
import { scaleUnit, signedLength } from '../../base/format.js';

const STEPS = 400;

/** The colour scale with its words and figures, and a mark for the deviation under the pointer. */
export function createLegend() {
  const canvas = make('canvas', { width: STEPS, height: 1, class: 'view-ramp', 'aria-hidden': 'true' });
  const mark = make('i', { class: 'view-ramp-mark', hidden: true });
  const ticks = make('div', { class: 'view-ticks' });
  const words = make('div', { class: 'view-words' });
  const unreachable = make('p', { class: 'view-hatched' }, [
    make('span', { class: 'view-hatch', 'aria-hidden': 'true' }),
    'hatched: the cutter cannot reach, not gated',
  ]);
  const element = make('div', { class: 'view-legend', data: { testid: 'view-legend' } }, [
    words, make('div', { class: 'view-ramp-box' }, [canvas, mark]), ticks, unreachable,
  ]);
  let scale = null;
  return {
    element,
    show(next, { band, sign, hasUnreachable }) {
      scale = next;
      paint(canvas, scale, band);
      words.replaceChildren(...wordsOf(scale));
      ticks.replaceChildren(...ticksOf(scale, sign));
      unreachable.hidden = !hasUnreachable;
    },
    point(deviation_mm) {
      mark.hidden = deviation_mm === null;
      if (deviation_mm !== null) mark.style.left = `${percent(position(scale, deviation_mm))}%`;
    },
  };
}

const percent = (place) => 50 + 50 * place;

function paint(canvas, scale, band) {
  const context = canvas.getContext('2d');
  for (let k = 0; k < STEPS; ++k) {
    const place = (2 * (k + 0.5)) / STEPS - 1;
    context.fillStyle = css(colour(scale, deviationAt(scale, place), band));
    context.fillRect(k, 0, 1, 1);
  }
}

/** The inverse of `position`. */
function deviationAt(scale, place) {
  const side = place < 0 ? scale.gouge : scale.uncut;
  const t = Math.abs(place);
  const size = t <= 0.5 ? 2 * t * side.limit_mm : side.limit_mm + (2 * t - 1) * (side.end_mm - side.limit_mm);
  return place < 0 ? -size : size;
}

/** Without limits nothing is "in tolerance": then the sides alone have words. */
function wordsOf({ gouge, uncut }) {
  const limited = gouge.hasLimit || uncut.hasLimit;
  return [
    make('span', { class: 'deep' }, [make('b', { text: 'cut too deep' }), ' (gouge)']),
    make('span', { text: limited ? 'in tolerance' : 'on the surface' }),
    make('span', { class: 'left' }, [make('b', { text: 'material left' }), ' (uncut)']),
  ];
}

function ticksOf(scale, sign) {
  const sides = [scale.gouge, scale.gouge, null, scale.uncut, scale.uncut];
  const unit = scaleUnit(Math.max(scale.gouge.end_mm, scale.uncut.end_mm));
  return ticks_mm(scale).map((mm, k) => {
    const isLimit = (k === 1 || k === 3) && sides[k].hasLimit;
    const tick = make('span', { class: isLimit ? 'limit' : '' }, [signedLength(sign * mm, unit)]);
    tick.style.left = `${percent(position(scale, mm))}%`;
    if (isLimit) tick.append(make('small', { text: 'limit' }));
    return tick;
  });
}
