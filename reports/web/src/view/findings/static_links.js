import { make } from '../../base/dom.js';

/**
 * Puts a button into the page's own tables beside each finding: it shows the finding in 3D. The page marks
 * them with data-finding="STAGE:ID", STAGE from 0.
 */
export function linkStaticFindings(root, show) {
  for (const marked of root.querySelectorAll('[data-finding]')) {
    const [stage, id] = marked.dataset.finding.split(':');
    const button = make('button', {
      type: 'button', class: 'view-show', data: { testid: 'show-finding', live: '' }, text: 'show in 3D',
      'aria-label': `Show ${id} in 3D`, on: { click: () => show(Number(stage), id) },
    });
    const cell = marked.matches('tr') ? marked.cells[0] : marked;
    if (marked.matches('a')) marked.after(' ', button);
    else (cell.querySelector(':scope > div') ?? cell).append(' ', button);
  }
}
