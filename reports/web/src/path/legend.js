import { make } from '../base/dom.js';
import { legendTicks, shareOf } from './values.js';
import { viridisGradient } from './viridis.js';
import { clockText, figure, grouped } from '../base/figure_text.js';

/** What the colours of the path mean, in figures with their unit. */
export function createLegend() {
  const title = make('p', { class: 'path-legend-title' });
  const bar = make('div', { class: 'path-legend-bar' });
  bar.style.backgroundImage = viridisGradient();
  const ticks = make('div', { class: 'path-legend-ticks' });
  const dash = make('span', { class: 'path-dash' });
  const rapid = make('p', { class: 'path-legend-rapid' }, [dash, 'dashed: rapid']);
  const element = make('div', { class: 'path-legend', data: { testid: 'path-legend' } },
    [title, bar, ticks, rapid]);
  return {
    element,
    update(chosen) {
      title.textContent = chosen.key === 'order' || !chosen.unit ? chosen.label : `${chosen.label} in ${chosen.unit}`;
      // Times are long words.
      const values = legendTicks(chosen, chosen.key === 'order' ? 3 : 5);
      ticks.replaceChildren(...values.map((value, i) => tick(chosen, value, i === values.length - 1)));
    },
    setRapids: (shown) => (rapid.hidden = !shown),
  };
}

function textOf(chosen, value) {
  if (chosen.key === 'order') return clockText(value, chosen.high < 60 ? 1 : 0);
  return chosen.key === 'line' ? grouped(Math.round(value)) : figure(value);
}

function tick(chosen, value, last) {
  const text = textOf(chosen, value);
  const element = make('span', { text: last && chosen.clipped ? `\u2265 ${text}` : text });
  const share = shareOf(chosen, value);
  element.style.left = `${100 * share}%`;
  element.style.transform = `translateX(${-100 * share}%)`;
  return element;
}
