/**
 * Colours of the 3D view, taken from the page's own (reports/html/report.css), which follow the reader's
 * choice of light or dark.
 * @returns {{dark: boolean, background: number[], ink: number[], soft: number[]}} from 0 to 1
 */
export function pageTheme(element) {
  const style = getComputedStyle(element);
  const variable = (name) => rgb(style.getPropertyValue(name).trim());
  const background = variable('--panel');
  return {
    dark: background[0] + background[1] + background[2] < 1.5,
    background, ink: variable('--ink'), soft: variable('--soft'),
  };
}

/** "#rgb" or "#rrggbb" as three numbers from 0 to 1. */
function rgb(text) {
  const digits = text.replace('#', '');
  const wide = digits.length === 3 ? [...digits].map((d) => d + d).join('') : digits;
  return [0, 2, 4].map((at) => parseInt(wide.slice(at, at + 2), 16) / 255);
}

/** Calls `changed` whenever light becomes dark or the other way round. */
export function onThemeChange(changed) {
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', changed);
}
