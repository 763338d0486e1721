import { make } from '../base/dom.js';

const VIEWS = [
  ['home', 'Whole part', undefined, 'The whole part from where it is seen now (Home)'],
  ['perspective', 'Perspective', 'perspective', 'The whole part in perspective'],
  ['top', 'Top', 'top', 'From above, along Z'],
  ['front', 'Front', 'front', 'From the front, along Y'],
  ['right', 'Right', 'right', 'From the right, along X'],
];

const BOTTOM = ['bottom', 'Bottom', 'bottom', 'From below, against Z'];

/**
 * Buttons that look at the part from a side, from below too where a tool comes from there, and switches of
 * what is drawn.
 */
export function createToolbar({ look, toggles, below = false }) {
  const buttons = (below ? [...VIEWS, BOTTOM] : VIEWS).map(([id, text, view, title]) => make('button', {
    type: 'button', title, data: { testid: `view-${id}` }, on: { click: () => look(view) },
  }, [text]));
  const checks = toggles.map(({ id, text, checked, change }) => {
    const box = make('input', {
      type: 'checkbox', data: { testid: id }, on: { change: () => change(box.checked) },
    });
    box.checked = checked;
    return make('label', { class: 'view-check' }, [box, text]);
  });
  return make('div', { class: 'view-bar' }, [
    make('div', { class: 'view-buttons', role: 'group', 'aria-label': 'Look from' }, buttons),
    make('div', { class: 'view-toggles' }, checks),
  ]);
}
