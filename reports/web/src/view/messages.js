import { make } from '../base/dom.js';

export const MISSING = 'The 3D view needs WebGL 2, which this browser does not offer or has switched off. '
  + 'All figures, findings and maps stand in the page below.';
export const LOST = 'The graphics card has taken its memory back, and the 3D view with it. Load the page again to '
  + 'see it; all figures, findings and maps stand in the page below.';

/** A paragraph that stands where nothing can be drawn. */
export const sentence = (text) => make('p', { class: 'view-missing', text, data: { testid: 'view-missing' } });
