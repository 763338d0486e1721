import { panned, turned, zoomed } from './camera.js';

const TURN_KEY_DEG = 10;
const PAN_KEY_SHARE = 0.08;
const ZOOM_KEY = 1.25;
const TAP_PIXELS = 6;

/**
 * Moves the camera by mouse, touch, pen and keyboard.
 *
 * The page must stay scrollable across the view: the wheel zooms only where the view has the focus or Ctrl
 * is held, and one finger scrolls up and down until the view was tapped.
 * @param {object} scene
 * @param {{tap(x, y, touch), hover(x, y), leave(), keyed(), wheelIgnored()}} on pixels from the view's corner
 */
export function attachHand(scene, on) {
  const { element } = scene;
  const pointers = new Map();
  let travelled = 0;

  const at = (event) => {
    const box = element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const change = (make) => scene.setCamera(make(scene.camera(), scene.size()));

  element.addEventListener('pointerdown', (event) => {
    if (event.target.closest('button')) return;
    element.focus({ preventScroll: true });
    element.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, at(event));
    if (pointers.size === 1) travelled = 0;
  });
  element.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId), now = at(event);
    if (!before) {
      if (event.pointerType !== 'touch') on.hover(now.x, now.y);
      return;
    }
    travelled += Math.hypot(now.x - before.x, now.y - before.y);
    // Held still, or nearly: a tap, not a turn.
    if (travelled > TAP_PIXELS) drag(event, before, now);
    pointers.set(event.pointerId, now);
  });
  const drag = (event, before, now) => {
    const [dx, dy] = [now.x - before.x, now.y - before.y];
    if (pointers.size === 2) return pinch(event.pointerId, before, now);
    const pan = event.shiftKey || event.ctrlKey || (event.buttons & 6) !== 0;
    change((camera, size) => (pan ? panned : turned)(camera, size, dx, dy));
  };
  const pinch = (id, before, now) => {
    const [other] = [...pointers].filter(([key]) => key !== id).map(([, place]) => place);
    const gap = (place) => Math.max(8, Math.hypot(place.x - other.x, place.y - other.y));
    const middle = { x: (now.x + other.x) / 2, y: (now.y + other.y) / 2 };
    change((camera, size) =>
      panned(zoomed(camera, size, gap(now) / gap(before), middle.x, middle.y, scene.size_mm), size,
        (now.x - before.x) / 2, (now.y - before.y) / 2));
  };
  const lift = (event) => {
    if (!pointers.delete(event.pointerId)) return;
    if (event.type === 'pointerup' && travelled <= TAP_PIXELS && pointers.size === 0) {
      const { x, y } = at(event);
      on.tap(x, y, event.pointerType === 'touch');
    }
  };
  element.addEventListener('pointerup', lift);
  element.addEventListener('pointercancel', lift);
  element.addEventListener('pointerleave', () => on.leave());
  element.addEventListener('contextmenu', (event) => event.preventDefault());

  element.addEventListener('wheel', (event) => {
    if (!event.ctrlKey && !element.contains(document.activeElement)) return on.wheelIgnored();
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 30 : 1;
    const factor = Math.exp(-Math.max(-120, Math.min(120, event.deltaY * lines)) * 0.0025);
    const { x, y } = at(event);
    change((camera, size) => zoomed(camera, size, factor, x, y, scene.size_mm));
  }, { passive: false });

  element.addEventListener('keydown', (event) => {
    const next = keyed(event, scene);
    if (!next) return;
    event.preventDefault();
    if (next === 'home') scene.home();
    else scene.setCamera(next);
    on.keyed();
  });
}

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** The camera after a key; undefined for keys that are not the view's. */
function keyed(event, scene) {
  if (event.altKey || event.ctrlKey || event.metaKey) return undefined;
  const camera = scene.camera(), size = scene.size();
  if (event.key === 'Home') return 'home';
  const zoom = { '+': ZOOM_KEY, '=': ZOOM_KEY, '-': 1 / ZOOM_KEY }[event.key];
  if (zoom) return zoomed(camera, size, zoom, size.width / 2, size.height / 2, scene.size_mm);
  const arrow = ARROWS[event.key];
  if (!arrow) return undefined;
  const [x, y] = arrow;
  const step = PAN_KEY_SHARE * size.height;
  if (event.shiftKey) return panned(camera, size, -x * step, -y * step);
  const perDegree = size.height / 180;
  return turned(camera, size, x * TURN_KEY_DEG * perDegree, y * TURN_KEY_DEG * perDegree);
}
