import { fixed, threeDigits, unitFor } from '../base/format.js';

/** Seconds as the page's tables say them: "0.8 s", "12.4 s", "3 min 05 s", "1 h 02 min". */
export function durationText(seconds) {
  if (seconds < 59.95) return `${fixed(seconds, seconds < 0.095 ? 2 : 1)} s`;
  const whole = Math.round(seconds), two = (n) => String(n).padStart(2, '0');
  if (whole < 3600) return `${Math.floor(whole / 60)} min ${two(whole % 60)} s`;
  return `${Math.floor(whole / 3600)} h ${two(Math.floor((whole % 3600) / 60))} min`;
}

/** For the marks of an axis: "45 s", "2:30", "1:02:00"; with `decimals` "2:30.5" below an hour. */
export function clockText(seconds, decimals = 0) {
  if (seconds < 60) return `${Number(seconds.toPrecision(3 + decimals))} s`;
  const whole = Math.round(seconds), two = (n) => String(n).padStart(2, '0');
  const rounded = decimals > 0 ? Number(seconds.toFixed(decimals)) : whole;
  const minutes = Math.floor(rounded / 60);
  if (minutes < 60 && decimals > 0)
    return `${minutes}:${(rounded - 60 * minutes).toFixed(decimals).padStart(3 + decimals, '0')}`;
  if (minutes < 60) return `${minutes}:${two(whole % 60)}`;
  return `${Math.floor(minutes / 60)}:${two(minutes % 60)}:${two(whole % 60)}`;
}

/** A share as a percentage that never rounds up to a whole it has not reached. */
export const percentText = (share) => `${fixed(Math.floor(share * 1e4 + 1e-6) / 100, 2)} %`;

const plainText = (value) =>
  (Number.isInteger(value) ? String(value).replace('-', '−') : threeDigits(value));

/**
 * How a figure's values are shown: in one unit all of them, so that they can be compared.
 * @param {{id: string, label: string, unit: string, values: (number|null)[]}} figure
 * @returns {{title, perUnit, cell, text, mark}} `cell` and `text` take what was measured (null: nothing),
 *   `cell` leaves out the unit that `title` holds; `mark` takes a value times `perUnit`
 */
export function shownFigure({ id, label, unit, values }) {
  const kind = { mm: 'length', s: 'duration' }[unit] ?? (/(^|\.)coverage$/.test(id) ? 'share' : 'plain');
  const length = kind === 'length' ? unitFor(largest(values)) : null;
  const perUnit = length?.perMm ?? 1;
  const symbol = length ? length.symbol : kind === 'plain' ? unit : '';
  const say = { length: threeDigits, duration: durationText, share: percentText, plain: plainText }[kind];
  const decimals = span(values) < 10 ? (span(values) < 1 ? 2 : 1) : 0;
  const cell = (value) => (value === null ? '–' : say(value * perUnit));
  return {
    title: symbol ? `${label}, ${symbol}` : label, perUnit, cell,
    text: (value) => (value !== null && symbol ? `${cell(value)} ${symbol}` : cell(value)),
    mark: {
      duration: (value) => clockText(value, decimals),
      share: (value) => `${Number((value * 100).toPrecision(4))} %`,
    }[kind] ?? ((value) => String(Number(value.toPrecision(4))).replace('-', '−')),
  };
}

/** By how much the largest value is above the least. */
function span(values) {
  const there = values.filter((value) => value !== null);
  return there.reduce((a, b) => Math.max(a, b), -Infinity) - there.reduce((a, b) => Math.min(a, b), Infinity);
}

const largest = (values) => values.reduce((most, value) => Math.max(most, Math.abs(value ?? 0)), 0);
