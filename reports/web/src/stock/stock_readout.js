import { make } from '../base/dom.js';
import { coordinate } from '../base/format.js';
import { clockText, grouped } from '../base/figure_text.js';

/** What stands under the pointer and what made it; said aloud only where the keyboard moves the crosshair. */
export function createStockReadout() {
  const text = make('p', { class: 'view-idle' });
  const element = make('div', {
    class: 'view-readout', data: { testid: 'stock-readout' }, 'aria-live': 'off', 'aria-atomic': 'true',
  }, [text]);
  const idle = 'Point at the stock to read its coordinates and what cut it.';
  text.textContent = idle;
  return {
    element,
    show(reading, stages, spoken = false) {
      element.setAttribute('aria-live', spoken ? 'polite' : 'off');
      text.textContent = reading ? words(reading, stages) : idle;
      text.classList.toggle('view-idle', !reading);
      for (const key of ['line', 'maker'])
        if (reading) element.dataset[key] = String(reading[key]);
        else delete element.dataset[key];
    },
  };
}

function words({ point_mm, maker, line, time_s }, stages) {
  const [x, y, z] = point_mm.map(coordinate);
  const place = `X ${x}  Y ${y}  Z ${z} mm`;
  if (maker === null) return `${place} \u00b7 within the stock, on the section`;
  if (maker === 0) return `${place} \u00b7 raw stock`;
  const name = stages[maker - 1]?.name ?? '';
  const at = line > 0 ? `, line ${grouped(line)}` : '';
  return `${place} \u00b7 cut by ${name}${at}${Number.isNaN(time_s) ? '' : `, at ${clockText(time_s)}`}`;
}
