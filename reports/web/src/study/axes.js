/** A key with fewer settings has them for marks. */
const MOST_MARKS = 12;

/** The parts of a quantity's name, each on a line of its own where `between` is a line feed. */
export function titleParts(quantity, between = '\n') {
  const parts = quantity.kind === 'key' ? quantity.title.replace(/^stage\./, '').split('.')
    : quantity.title.split(': ');
  return parts.map((part) => shortened(part, 26)).join(between);
}

const shortened = (text, most) => (text.length > most ? `${text.slice(0, most - 1)}…` : text);

/** What every axis of a quantity has in common, for ECharts. */
export function quantityAxis(quantity) {
  if (quantity.categories)
    return { type: 'category', data: quantity.categories.map((text) => shortened(text, 18)) };
  const marks = quantity.settings?.length <= MOST_MARKS ? { customValues: quantity.settings } : {};
  return {
    type: 'value', scale: true, axisTick: marks,
    axisLabel: { formatter: (value) => quantity.mark(value), ...marks },
  };
}

/** Least and largest value of a quantity over all rows; null where there is none. */
export function extentOf(quantity, count) {
  let low = Infinity, high = -Infinity;
  for (let row = 0; row < count; ++row) {
    const value = quantity.value(row);
    if (value === null) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  return low <= high ? [low, high] : null;
}
