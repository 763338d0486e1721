import { make } from '../base/dom.js';
import { createLegend } from '../path/legend.js';
import { choice } from '../view/section/section_panel.js';
import { rawColour, toolColour } from './colours.js';

/** By what the stock is coloured, and what the colours mean. */
export function createStockColours(changed) {
  const pick = choice('Stock coloured by', 'stock-colour', []);
  const legend = createLegend();
  legend.setRapids(false);
  const tools = make('ul', { class: 'stock-tools', data: { testid: 'stock-tools' } });
  const element = make('div', { class: 'stock-colours' }, [pick.label, tools, legend.element]);
  pick.select.addEventListener('change', changed);
  return {
    element,
    chosen: (choices) => choices.find(({ key }) => key === pick.select.value) ?? choices[0],
    setChoices(choices) {
      const before = pick.select.value;
      pick.select.replaceChildren(...choices.map(({ key, label, reason }) => make('option', {
        value: key, disabled: Boolean(reason), text: reason ? `${label}: ${reason}` : label,
      })));
      if (choices.some(({ key, reason }) => key === before && !reason)) pick.select.value = before;
    },
    show(chosen, stages, dark) {
      tools.hidden = chosen.key !== 'tool';
      legend.element.hidden = !chosen.values;
      if (chosen.values) legend.update(chosen.key === 'time' ? { ...chosen, key: 'order' } : chosen);
      const entry = (colour, text) => make('li', {}, [chip(colour), text]);
      tools.replaceChildren(entry(rawColour(dark), 'raw stock'),
        ...stages.map(({ name, tool }, k) => entry(toolColour(k), name === tool ? name : `${name}: ${tool}`)));
    },
  };
}

function chip(colour) {
  const element = make('i', { 'aria-hidden': 'true' });
  element.style.background = `rgb(${colour.join(' ')})`;
  return element;
}
