import { threeDigits } from './format.js';

/** 98325 as "98 325", with narrow no-break spaces from five digits on. */
export function grouped(count) {
  const digits = String(Math.abs(count));
  const spaced = digits.length < 5 ? digits : digits.replace(/(?=(\d{3})+$)(?!^)/g, '\u202f');
  return (count < 0 ? '\u2212' : '') + spaced;
}

/** Machining time as "12.4 s", "3 min 05.2 s", "1 h 02 min 07 s"; no decimals from an hour on. */
export function clockText(seconds, decimals = 1) {
  const places = seconds >= 3600 ? 0 : Math.min(decimals, 2);
  const unit = 10 ** places;
  const ticks = Math.round(seconds * unit);
  const rest = (ticks % (60 * unit)) / unit, minutes = Math.floor(ticks / (60 * unit));
  if (minutes === 0) return `${rest.toFixed(places)} s`;
  const two = rest.toFixed(places).padStart(places > 0 ? 3 + places : 2, '0');
  if (minutes < 60) return `${minutes} min ${two} s`;
  return `${Math.floor(minutes / 60)} h ${String(minutes % 60).padStart(2, '0')} min ${two} s`;
}

/** A round time: "0", "30 s", "2 min", "1 h 30 min". */
export function clockMark(seconds) {
  if (seconds === 0) return '0';
  const whole = Math.round(seconds * 10) / 10;
  const parts = [[Math.floor(whole / 3600), 'h'], [Math.floor((whole % 3600) / 60), 'min'],
    [Math.round((whole % 60) * 10) / 10, 's']];
  return parts.filter(([count]) => count > 0).map(([count, unit]) => `${count} ${unit}`).join(' ');
}

/** Three significant digits, or all before the point, these set apart. */
export function figure(value) {
  return Math.abs(value) >= 9999.5 ? grouped(Math.round(value)) : threeDigits(value);
}

export const feedText = (mm_min) => `${figure(mm_min)} mm/min`;
export const rateText = (mm3_min) => `${figure(mm3_min)} mm\u00b3/min`;
