import { make, uniqueId } from '../../base/dom.js';
import { choice } from '../section/section_panel.js';

const UM = 1000;

/**
 * How deviations become colours and figures: sign, range, band.
 * @param {() => void} changed
 */
export function createColourPanel(changed) {
  const sign = choice('Positive is', 'view-sign', [['uncut', 'material left'], ['gouge', 'cut too deep']]);
  const range = choice('Colours reach to', 'view-range',
    [['gate', 'the gate limits and beyond'], ['measured', 'what was measured'], ['own', 'own figures']]);
  const gouge = figure('Cut too deep', 'view-own-gouge'), uncut = figure('Material left', 'view-own-uncut');
  const band = make('input', { type: 'checkbox', data: { testid: 'view-band' } });
  const own = make('div', { class: 'view-row', hidden: true }, [gouge.label, uncut.label]);
  const element = make('div', { class: 'view-row view-colours' }, [
    sign.label, range.label, own, make('label', { class: 'view-check' }, [band, 'in tolerance in one grey']),
  ]);
  const update = () => {
    own.hidden = range.select.value !== 'own';
    changed();
  };
  for (const input of [sign.select, range.select, band]) input.addEventListener('change', update);
  for (const { input } of [gouge, uncut]) input.addEventListener('input', update);
  return {
    element,
    sign: () => (sign.select.value === 'uncut' ? 1 : -1),
    band: () => band.checked,
    /** The reader's choice as scaleFor takes it; figures that make no sense fall back to `otherwise`. */
    choice(otherwise) {
      const own = (input, fallback) => (Number(input.value) > 0 ? Number(input.value) / UM : fallback);
      return {
        range: range.select.value,
        ownGouge_mm: own(gouge.input, otherwise.gouge.end_mm),
        ownUncut_mm: own(uncut.input, otherwise.uncut.end_mm),
      };
    },
    /** What the fields hold before the reader writes in them. */
    suggest({ gouge: g, uncut: u }) {
      gouge.input.placeholder = String(Number((g.end_mm * UM).toPrecision(6)));
      uncut.input.placeholder = String(Number((u.end_mm * UM).toPrecision(6)));
    },
  };
}

function figure(text, testid) {
  const id = uniqueId('figure');
  const input = make('input', { id, type: 'number', min: '0', step: 'any', data: { testid } });
  const name = make('span', { text: `${text}, µm` });
  return { input, label: make('label', { class: 'view-choice', for: id }, [name, input]) };
}
