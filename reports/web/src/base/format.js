/** Figures as the page shows them; the same rules as reports/text.h. */

const MICROMETRES_BELOW_MM = 0.1;

/** The unit for lengths shown beside each other: µm where all are below 0.1 mm. */
export function unitFor(largest_mm) {
  return Math.abs(largest_mm) < MICROMETRES_BELOW_MM
    ? { perMm: 1000, symbol: 'µm' }
    : { perMm: 1, symbol: 'mm' };
}

/** One unit for the figures of a scale: µm up to a millimetre, so that 50 and 100 µm stand side by side. */
export const scaleUnit = (largest_mm) => (largest_mm < 1 ? unitFor(0) : { perMm: 1, symbol: 'mm' });

/** `value` with `decimals` places, a true minus sign, and never "-0". */
export function fixed(value, decimals) {
  const text = value.toFixed(decimals);
  return (Number(text) === 0 ? text.replace('-', '') : text).replace('-', '−');
}

/** `value` with three significant digits; below 1e-4 with an exponent. */
export function threeDigits(value) {
  const size = Math.abs(value);
  if (size !== 0 && size < 1e-4) return value.toExponential(2).replaceAll('-', '−');
  if (size === 0) return '0';
  let decimals = 2 - Math.floor(Math.log10(size));
  // 9.996 has three digits as 10.0, not as 10.00.
  if (Number(size.toFixed(Math.max(0, decimals))) >= 10 ** (3 - decimals)) decimals -= 1;
  return fixed(value, Math.min(20, Math.max(0, decimals)));
}

/** A measured length with three significant digits and its unit: "0.445 µm", "1.25 mm". */
export function measuredLength(mm) {
  const unit = unitFor(mm);
  return `${threeDigits(mm * unit.perMm)} ${unit.symbol}`;
}

/** A stated length with all its digits: "10 µm", "0.2 mm". */
export function statedLength(mm) {
  if (mm === 0) return '0 mm';
  const unit = unitFor(mm);
  return `${Number((mm * unit.perMm).toPrecision(12))} ${unit.symbol}`.replace('-', '−');
}

/** The same with its sign always written and in one unit, for scales: "+20 µm", "−10 µm", "0". */
export function signedLength(mm, unit = unitFor(mm)) {
  if (mm === 0) return '0';
  const figure = String(Number((Math.abs(mm) * unit.perMm).toPrecision(12)));
  return `${mm > 0 ? '+' : '−'}${figure} ${unit.symbol}`;
}

const NOTHING_MM = 5e-7;

/** A deviation with its sign in the chosen convention: "−49.8 µm"; below a nanometre it is none. */
export function signedMeasured(mm) {
  if (Math.abs(mm) < NOTHING_MM) return '0 µm';
  return (mm > 0 ? '+' : '') + measuredLength(mm);
}

/** A coordinate in mm to a tenth of a micrometre less: three decimals. */
export const coordinate = (mm) => fixed(mm, 3);

/** A parameter of a patch. */
export const parameter = (value) => fixed(value, 3);

/** What a deviation means: the words of the report's legends. `tolerance_mm` is what counts as nothing. */
export function deviationWord(deviation_mm, limits) {
  const size = Math.abs(deviation_mm);
  const limit = deviation_mm < 0 ? limits?.gouge_mm : limits?.uncut_mm;
  const word = deviation_mm < 0 ? 'cut too deep' : 'material left';
  if (limit === undefined) return size === 0 ? 'on the surface' : word;
  return size <= limit ? 'in tolerance' : word;
}
