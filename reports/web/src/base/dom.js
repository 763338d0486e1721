/**
 * An element. Text only ever becomes text: names, comments and program lines may hold markup.
 * @param {string} tag
 * @param {object} [properties] `class`, `text`, `data` (object), `on` (event handlers), else attributes;
 *   false and undefined leave an attribute out, true sets it empty
 * @param {(Node|string)[]} [children]
 */
export function make(tag, properties = {}, children = []) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name === 'text') element.textContent = value;
    else if (name === 'on') listen(element, value);
    else if (name === 'data') Object.assign(element.dataset, value);
    else if (value === true) element.setAttribute(name, '');
    else if (value !== false && value !== undefined) element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

function listen(element, handlers) {
  for (const [event, handler] of Object.entries(handlers)) element.addEventListener(event, handler);
}

/** An id that no other element of the page has. */
export const uniqueId = (() => {
  let last = 0;
  return (name) => `view-${name}-${(last += 1)}`;
})();

/** Calls through at most once a frame, with the newest arguments. */
export function onceAFrame(action) {
  let waiting = null;
  return (...values) => {
    if (!waiting) requestAnimationFrame(() => {
      const latest = waiting;
      waiting = null;
      action(...latest);
    });
    waiting = values;
  };
}
