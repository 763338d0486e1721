import { make } from '../base/dom.js';
import { coordinate, deviationWord, parameter, signedMeasured } from '../base/format.js';

const FIGURES = {
  'x-mm': ({ point_mm }) => point_mm[0],
  'y-mm': ({ point_mm }) => point_mm[1],
  'z-mm': ({ point_mm }) => point_mm[2],
  'deviation-mm': ({ deviation_mm }) => deviation_mm,
  'sample-deviation-mm': ({ sample_deviation_mm }) => sample_deviation_mm,
  ...Object.fromEntries(['patch', 'u', 'v', 'line', 'stage', 'reachable', 'raw', 'sample']
    .map((name) => [name, (reading) => reading[name]])),
};

/**
 * What is under the pointer, in words; the same as full-precision numbers in data attributes. It speaks to
 * screen readers only where the keyboard moves the crosshair: a moving mouse would never let them finish.
 */
export function createReadout() {
  const chip = make('i', { class: 'view-chip', 'aria-hidden': 'true' });
  const deviation = make('strong');
  const word = make('span', { class: 'view-word' });
  const place = make('span'), patch = make('span'), line = make('span');
  const idle = make('p', { class: 'view-idle', text: 'Point at the part to read the deviation there.' });
  const figures = make('p', { hidden: true }, [
    make('span', { class: 'view-deviation' }, [chip, deviation, ' ', word]), place, patch, line,
  ]);
  const element = make('div', {
    class: 'view-readout', data: { testid: 'view-readout' }, 'aria-live': 'off', 'aria-atomic': 'true',
  }, [idle, figures]);
  return {
    element,
    /** @param {boolean} spoken whether a screen reader should say it */
    show(reading, { sign, limits, colour, stages, triangles }, spoken) {
      element.setAttribute('aria-live', spoken ? 'polite' : 'off');
      setAttributes(element, reading);
      idle.hidden = reading !== null;
      figures.hidden = reading === null;
      if (!reading) return;
      chip.style.background = colour;
      deviation.textContent = signedMeasured(sign * reading.deviation_mm);
      word.textContent = wordOf(reading, limits);
      const [x, y, z] = reading.point_mm.map(coordinate);
      place.textContent = `X ${x}  Y ${y}  Z ${z} mm`;
      patch.textContent = patchText(reading, triangles);
      line.textContent = lineOf(reading, stages);
    },
  };
}

/** Of a mesh the triangle, of which three patches make up one. */
function patchText({ patch, u, v }, triangles) {
  if (triangles) return `triangle ${triangles[Math.floor(patch / 3)]}`;
  return `patch ${patch}, u ${parameter(u)}, v ${parameter(v)}`;
}

function wordOf(reading, limits) {
  const word = deviationWord(reading.deviation_mm, limits);
  if (!reading.reachable) return `${word}; the cutter cannot reach here`;
  return reading.worst_nearby ? `${word} (the worst nearby)` : word;
}

/** The program line of the nearest pass, or that none came near. */
function lineOf(reading, stages) {
  if (reading.raw) return 'nearest: the raw stock, no pass';
  const name = stages[reading.stage]?.name;
  return `nearest pass: line ${reading.line}${name ? ` of ${name}` : ''}`;
}

function setAttributes(element, reading) {
  for (const [name, figure] of Object.entries(FIGURES))
    if (reading) element.setAttribute(`data-${name}`, String(figure(reading)));
    else element.removeAttribute(`data-${name}`);
}
