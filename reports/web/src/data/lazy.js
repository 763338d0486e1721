/**
 * Properties that are worked out when they are first asked for, each once.
 * @template T
 * @param {T} target
 * @param {Object<string, function(): *>} makers by name of the property
 * @returns {T} `target`
 */
export function lazily(target, makers) {
  for (const [name, make] of Object.entries(makers))
    Object.defineProperty(target, name, {
      configurable: true,
      enumerable: true,
      get() {
        const value = make.call(target);
        Object.defineProperty(target, name, { value, enumerable: true });
        return value;
      },
    });
  return target;
}
