/** How each status looks, in the order in which the page's data count them: never by colour alone. */
export const LOOKS = [
  { word: 'passed', sign: '✓', css: 'pass', colour: 'passed', symbol: 'circle', dash: 'solid' },
  {
    word: 'failed', sign: '✕', css: 'fail', colour: 'uncut', dash: [7, 4],
    symbol: 'path://M0,2L2,0L5,3L8,0L10,2L7,5L10,8L8,10L5,7L2,10L0,8L3,5Z',
  },
  { word: 'undecided', sign: '?', css: 'open', colour: 'open', symbol: 'triangle', dash: [2, 3] },
  { word: 'error', sign: '!', css: 'none', colour: 'none', symbol: 'rect', dash: [1, 4] },
  { word: 'lost', sign: '–', css: 'none', colour: 'none', symbol: 'rect', dash: [1, 4] },
];
