import { between } from './camera.js';

const FLIGHT_MS = 650;
const eased = (t) => (t < 0.5 ? 4 * t ** 3 : 1 - (2 - 2 * t) ** 3 / 2);

/**
 * Moves a camera over time; at once for readers who want reduced motion.
 * @param {() => object} current camera
 * @param {(camera: object, moving: boolean) => void} show
 */
export function createFlight(current, show) {
  let flight = null;
  const stop = () => {
    if (!flight) return;
    cancelAnimationFrame(flight.frame);
    flight.landed();
    flight = null;
  };
  const start = (target) => {
    stop();
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
      show(target, false);
      return Promise.resolve();
    }
    return new Promise((landed) => {
      const from = current();
      flight = { frame: 0, landed, begun: null };
      const step = (now) => {
        flight.begun ??= now;
        const t = Math.min(1, (now - flight.begun) / FLIGHT_MS);
        show(between(from, target, eased(t)), t < 1);
        if (t < 1) flight.frame = requestAnimationFrame(step);
        else stop();
      };
      flight.frame = requestAnimationFrame(step);
    });
  };
  return { start, stop, flying: () => flight !== null };
}
