import '@kitware/vtk.js/Rendering/OpenGL/Profiles/Geometry';
import vtkOpenGLRenderWindow from '@kitware/vtk.js/Rendering/OpenGL/RenderWindow';
import vtkRenderWindow from '@kitware/vtk.js/Rendering/Core/RenderWindow';
import vtkRenderer from '@kitware/vtk.js/Rendering/Core/Renderer';
import { axes, eyeDistance, fitted, HALF_ANGLE_DEG, lookingAt, project, ray, VIEWS } from './camera.js';
import { createFlight } from './flight.js';
import { onThemeChange, pageTheme } from './theme.js';
import { add, length, scaled, subtract } from './vector.js';

const REST_MS = 160;
const SLOW_FRAME_MS = 45;
const LARGEST_PIXEL_RATIO = 2;
const SMALLEST_PIXEL_RATIO = 0.5;

/** Whether this browser draws with WebGL 2 at all. */
export function canDraw() {
  const context = document.createElement('canvas').getContext('webgl2');
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return Boolean(context);
}

/**
 * A vtk.js window in `container` with a camera that turns about Z. Frames are drawn on demand: `render`
 * asks for one, and any number of askings before it is due make one. While the camera moves and frames
 * are slow, they have fewer pixels; a moment after it rests the picture is whole again.
 * @param {HTMLElement} container positioned, of a size
 * @param {{bounds_mm: number[][]}} report
 */
export function createScene(container, { bounds_mm }) {
  const { renderWindow, renderer, view } = createWindow(container);
  const size_mm = length(subtract(bounds_mm[1], bounds_mm[0])) || 1;
  const listeners = { frame: [], theme: [], lost: [] };
  let camera = null, frame = 0, restTimer = 0, moving = false, slowness = 1, frames = 0;
  let theme = pageTheme(container);

  const size = () => ({ width: container.clientWidth || 1, height: container.clientHeight || 1 });
  const draw = () => {
    frame = 0;
    const before = performance.now();
    resize(view, size(), moving ? slowness : 1);
    place(renderer.getActiveCamera(), camera, size_mm, bounds_mm);
    renderWindow.render();
    if (moving) slowness = nextSlowness(slowness, finish(view, before));
    frames += 1;
    listeners.frame.forEach((callback) => callback({ moving }));
  };
  const render = () => (frame ||= requestAnimationFrame(draw));
  const rest = () => {
    moving = false;
    render();
  };
  const setCamera = (next, stillMoving = true) => {
    camera = next;
    moving = true;
    clearTimeout(restTimer);
    if (stillMoving) restTimer = setTimeout(rest, REST_MS);
    else moving = false;
    render();
  };
  const flight = createFlight(() => camera, setCamera);
  const applyTheme = () => {
    theme = pageTheme(container);
    renderer.setBackground(...theme.background);
    listeners.theme.forEach((callback) => callback(theme.dark));
    render();
  };

  camera = fitted(VIEWS.perspective, bounds_mm, size());
  applyTheme();
  onThemeChange(applyTheme);
  new ResizeObserver(render).observe(container);
  container.querySelector('canvas').addEventListener('webglcontextlost', () => listeners.lost.forEach((f) => f()));

  return {
    add: (actor) => { renderer.addActor(actor); render(); },
    remove: (actor) => { renderer.removeActor(actor); render(); },
    render, renderer, renderWindow, element: container, size, size_mm, bounds_mm,
    camera: () => camera,
    /** The camera of a hand, which ends any flight. */
    setCamera: (next) => { flight.stop(); setCamera(next); },
    /** Flies to a camera; resolves where it has landed or was taken over. */
    fly: (target) => flight.start(target),
    flyTo: ({ point_mm, normal = [0, 0, 1], distance_mm }) =>
      flight.start(lookingAt(camera, point_mm, normal, distance_mm / 2)),
    /** The whole part, from a named view or from where it is seen now. */
    home: (view) => flight.start(fitted(VIEWS[view] ?? camera, bounds_mm, size())),
    project: (point_mm) => project(camera, size(), point_mm),
    ray: (x, y) => ray(camera, size(), x, y, size_mm),
    viewDirection: () => scaled(axes(camera).back, -1),
    moving: () => moving || flight.flying(),
    frames: () => frames,
    /** Resolves when the camera rests and its last frame is drawn. */
    settled: () => new Promise((resolve) => {
      const look = () => (moving || frame || flight.flying() ? requestAnimationFrame(look) : resolve());
      look();
    }),
    onFrame: (callback) => listeners.frame.push(callback),
    onTheme: (callback) => listeners.theme.push(callback),
    onLost: (callback) => listeners.lost.push(callback),
    theme: () => theme,
    pixelRatio: () => view.getSize()[1] / size().height,
  };
}

function createWindow(container) {
  const renderWindow = vtkRenderWindow.newInstance();
  const renderer = vtkRenderer.newInstance();
  renderWindow.addRenderer(renderer);
  const view = vtkOpenGLRenderWindow.newInstance();
  renderWindow.addView(view);
  view.setContainer(container);
  const [canvas] = container.getElementsByTagName('canvas');
  Object.assign(canvas.style, { width: '100%', height: '100%', display: 'block' });
  return { renderWindow, renderer, view };
}

function resize(view, { width, height }, share) {
  const ratio = Math.min(window.devicePixelRatio || 1, LARGEST_PIXEL_RATIO) * share;
  const [w, h] = [width, height].map((pixels) => Math.max(1, Math.round(pixels * ratio)));
  const [now_w, now_h] = view.getSize();
  if (now_w !== w || now_h !== h) view.setSize(w, h);
}

/** Time of a frame with what the graphics card still had to do; a pixel read waits for it. */
function finish(view, begun) {
  view.getPixelData(0, 0, 0, 0);
  return performance.now() - begun;
}

function nextSlowness(share, took_ms) {
  if (took_ms > SLOW_FRAME_MS) return Math.max(SMALLEST_PIXEL_RATIO, share * 0.75);
  return took_ms < SLOW_FRAME_MS / 3 ? Math.min(1, share * 1.2) : share;
}

function place(vtkCamera, camera, size_mm, bounds_mm) {
  const { up, back } = axes(camera);
  const distance = eyeDistance(camera, size_mm);
  vtkCamera.setParallelProjection(!camera.perspective);
  vtkCamera.setViewAngle(2 * HALF_ANGLE_DEG);
  vtkCamera.setParallelScale(camera.scale);
  vtkCamera.setFocalPoint(...camera.focal);
  vtkCamera.setPosition(...add(camera.focal, scaled(back, distance)));
  vtkCamera.setViewUp(...up);
  // The part's size twice over: toolpaths start well above the part.
  const centre = scaled(add(...bounds_mm), 0.5);
  const reach = 2 * size_mm + length(subtract(camera.focal, centre));
  vtkCamera.setClippingRange(Math.max(distance - reach, 0.01 * distance), distance + reach);
}
