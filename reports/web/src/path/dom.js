/**
 * An element with its attributes and children; text stays text.
 * @param {string} tag
 * @param {object} attributes `true` stands without a value, `false`, `null` and `undefined` not at all
 * @param {...(Node|string)} children
 */
export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === false || value === null || value === undefined) continue;
    element.setAttribute(name, value === true ? '' : value);
  }
  element.append(...children);
  return element;
}

/** A list to choose from: `options` are {value, text, disabled?}. */
export function choice(options, attributes) {
  const items = options.map(({ value, text, disabled }) => make('option', { value, disabled }, text));
  return make('select', attributes, ...items);
}

/** A control with its words. */
export const labelled = (text, control) => make('label', {}, make('span', {}, text), control);
