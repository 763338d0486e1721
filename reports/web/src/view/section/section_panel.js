import { make, uniqueId } from '../../base/dom.js';
import { fixed } from '../../base/format.js';
import { createSectionChart } from './section_chart.js';

const STEPS = 400;

/**
 * Controls of the section plane.
 * @param {number[][]} bounds_mm of the part
 * @param {() => number[]|undefined} interest a point that a new section should pass
 * @param {() => void} changed
 * @param {{element: Element}} [chart] drawn below the controls
 */
export function createSectionPanel(bounds_mm, interest, changed, chart = createSectionChart()) {
  const axis = choice('Section', 'view-section',
    [['none', 'none'], ['0', 'square to X'], ['1', 'square to Y'], ['2', 'square to Z']]);
  const offset = make('input', {
    type: 'range', min: 0, max: STEPS, step: 1, value: STEPS / 2, 'aria-label': 'Place of the section',
    data: { testid: 'view-section-offset' },
  });
  const figure = make('output', { class: 'view-offset' });
  const flip = make('input', { type: 'checkbox', data: { testid: 'view-section-flip' } });
  const note = make('p', { class: 'view-note' });
  const rest = make('div', { class: 'view-section-rest', hidden: true }, [
    make('label', { class: 'view-slide' }, [offset, figure]),
    make('label', { class: 'view-check' }, [flip, 'show the other half']),
  ]);
  const drawing = make('div', { hidden: true }, [chart.element, note]);
  const element = make('div', { class: 'view-section' }, [
    make('div', { class: 'view-row' }, [axis.label, rest]), drawing,
  ]);

  const section = () => {
    if (axis.select.value === 'none') return null;
    const k = Number(axis.select.value);
    const [low, high] = [bounds_mm[0][k], bounds_mm[1][k]];
    return { axis: k, offset_mm: low + ((high - low) * Number(offset.value)) / STEPS, flip: flip.checked };
  };
  const announce = () => {
    const now = section();
    rest.hidden = drawing.hidden = !now;
    if (now) {
      figure.textContent = `${'XYZ'[now.axis]} ${fixed(now.offset_mm, 2)} mm`;
      offset.setAttribute('aria-valuetext', figure.textContent);
    }
    changed();
  };
  const through = (point_mm) => {
    const now = section();
    if (!now || !point_mm) return announce();
    const [low, high] = [bounds_mm[0][now.axis], bounds_mm[1][now.axis]];
    const share = (point_mm[now.axis] - low) / (high - low || 1);
    // A place beside the part has no section through it.
    if (share > 0 && share < 1) offset.value = Math.round(share * STEPS);
    return announce();
  };
  axis.select.addEventListener('change', () => {
    offset.value = STEPS / 2;
    through(interest());
  });
  offset.addEventListener('input', announce);
  flip.addEventListener('change', announce);
  return {
    element, section, chart,
    setNote: (text) => { note.textContent = text; },
    /** Puts the plane as near to a point as its steps go. */
    through: (point_mm) => { if (section()) through(point_mm); },
  };
}

/** A labelled select. */
export function choice(text, testid, options) {
  const id = uniqueId('choice');
  const select = make('select', { id, data: { testid } },
    options.map(([value, name]) => make('option', { value, text: name })));
  const label = make('label', { class: 'view-choice', for: id }, [make('span', { text }), select]);
  return { select, label };
}
