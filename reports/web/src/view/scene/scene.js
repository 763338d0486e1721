import '@kitware/vtk.js/Rendering/OpenGL/Profiles/Geometry';
import vtkOpenGLRenderWindow from '@kitware/vtk.js/Rendering/OpenGL/RenderWindow';
import vtkRenderWindow from '@kitware/vtk.js/Rendering/Core/RenderWindow';
import vtkRenderer from '@kitware/vtk.js/Rendering/Core/Renderer';
import {
  axes, corners, eyeDistance, fitted, HALF_ANGLE_DEG, lookingAt, project, ray, VIEWS,
} from './camera.js';
import { createFlight } from './flight.js';
import { onThemeChange, pageTheme } from '../theme.js';
import { add, length, pointAt, scaled, subtract } from '../../base/vector.js';

const REST_MS = 160;
const SLOW_FRAME_MS = 45;
const LARGEST_PIXEL_RATIO = 2;
const SMALLEST_PIXEL_RATIO = 0.5;

/**
 * A vtk.js window in `container` with a camera that turns about Z. Frames are drawn on demand: `render`
 * asks for one, and any number of askings before it is due make one. While the camera moves and frames
 * are slow, they have fewer pixels and `beforeFrame` is told; a moment after it rests the picture is whole
 * again.
 * @param {HTMLElement} container positioned, of a size
 * @param {object} report, decoded
 * @returns {object|null} null where the browser does not draw with WebGL 2
 */
export function createScene(container, report) {
  const { bounds_mm } = report;
  const outline = outlinePoints(report);
  let whole = outline;
  const window3d = createWindow(container);
  if (!window3d) return null;
  const { renderWindow, renderer, view, software } = window3d;
  const size_mm = length(subtract(bounds_mm[1], bounds_mm[0])) || 1;
  const reach_mm = reachOf(report, size_mm);
  const listeners = { before: [], frame: [], theme: [], lost: [] };
  let camera = null, moving = false, lost = false;
  let frame = 0, frames = 0, restTimer = 0, slow = software, share = 1;
  let theme = pageTheme(container);

  const size = () => ({ width: container.clientWidth || 1, height: container.clientHeight || 1 });
  const draw = () => {
    frame = 0;
    // The context may be gone some time before its event comes.
    if (lost || view.getContext()?.isContextLost()) return;
    const before = performance.now();
    resize(view, size(), moving ? share : 1);
    listeners.before.forEach((callback) => callback({ moving, slow }));
    place(renderer.getActiveCamera(), camera, { size_mm, bounds_mm, reach_mm });
    renderWindow.render();
    if (moving) {
      const took_ms = finish(view, before);
      // Once the whole is known to be slow it is not tried again in motion: that would flicker.
      slow ||= took_ms > SLOW_FRAME_MS;
      share = nextShare(share, took_ms);
      // Counted from the end of a frame: a slow one must not be taken for rest.
      clearTimeout(restTimer);
      restTimer = setTimeout(rest, REST_MS);
    }
    frames += 1;
    listeners.frame.forEach((callback) => callback({ moving }));
  };
  const render = () => { if (!lost) frame ||= requestAnimationFrame(draw); };
  const rest = () => {
    if (flight.flying()) return;
    moving = false;
    render();
  };
  const setCamera = (next, stillMoving = true) => {
    camera = next;
    moving = true;
    clearTimeout(restTimer);
    if (!stillMoving) moving = false;
    render();
  };
  const flight = createFlight(() => camera, setCamera);
  const applyTheme = () => {
    theme = pageTheme(container);
    renderer.setBackground(...theme.background);
    listeners.theme.forEach((callback) => callback(theme.dark));
    render();
  };

  camera = fitted(VIEWS.perspective, outline, size());
  applyTheme();
  onThemeChange(applyTheme);
  new ResizeObserver(render).observe(container);
  container.querySelector('canvas').addEventListener('webglcontextlost', () => {
    lost = true;
    flight.stop();
    listeners.lost.forEach((callback) => callback());
  });

  return {
    add: (actor) => { renderer.addActor(actor); render(); },
    remove: (actor) => { renderer.removeActor(actor); render(); },
    render, renderer, renderWindow, element: container, size, size_mm, bounds_mm,
    camera: () => camera,
    /** The camera of a hand, which ends any flight. */
    setCamera: (next) => { flight.stop(); setCamera(next); },
    /** Flies to a camera; resolves where it has landed or was taken over. */
    fly: (target) => flight.start(target),
    flyTo: ({ point_mm, normal, distance_mm }) =>
      flight.start(lookingAt(camera, point_mm, normal ?? [0, 0, 1], distance_mm / 2)),
    /** The whole part, from a named view or from where it is seen now. */
    home: (view) => flight.start(fitted(VIEWS[view] ?? camera, whole, size())),
    /** The same at once, as the page opens. */
    lookHome: (view = 'perspective') => setCamera(fitted(VIEWS[view], whole, size()), false),
    /** Places that "whole part" must show beside the part itself. */
    setInterest: (points_mm) => { whole = [...outline, ...points_mm]; },
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
    /** Called before a frame with {moving, slow}: slow says that drawing everything takes too long. */
    beforeFrame: (callback) => listeners.before.push(callback),
    onFrame: (callback) => listeners.frame.push(callback),
    onTheme: (callback) => listeners.theme.push(callback),
    onLost: (callback) => listeners.lost.push(callback),
    theme: () => theme,
    pixelRatio: () => view.getSize()[1] / size().height,
  };
}

const OUTLINE_POINTS = 4000;

/** Points that stand for the part where it is to fill the picture. */
function outlinePoints({ surfaces, bounds_mm }) {
  const positions = surfaces[0]?.positions;
  if (!positions) return corners(bounds_mm);
  const count = positions.length / 3, step = Math.max(1, Math.floor(count / OUTLINE_POINTS));
  return Array.from({ length: Math.ceil(count / step) }, (_, k) => pointAt(positions, k * step));
}

const middle = (bounds_mm) => scaled(add(...bounds_mm), 0.5);

/** How far about the part's middle all is drawn: its size twice over, for toolpaths, and every fixture. */
function reachOf({ bounds_mm, fixtures }, size_mm) {
  const centre = middle(bounds_mm);
  let reach_mm = 2 * size_mm;
  for (const { positions } of fixtures)
    for (let k = 0; k < positions.length / 3; ++k)
      reach_mm = Math.max(reach_mm, length(subtract(pointAt(positions, k), centre)));
  return reach_mm;
}

/** What vtk.js itself asks for. */
const CONTEXT = { depth: true, alpha: true, powerPreference: 'high-performance' };

/** Null where there is none; what blocks the asking for one, as extensions do, is as good as none. */
function contextOf(canvas) {
  try {
    return canvas.getContext('webgl2', CONTEXT);
  } catch {
    return null;
  }
}

function createWindow(container) {
  const renderWindow = vtkRenderWindow.newInstance();
  const renderer = vtkRenderer.newInstance();
  renderWindow.addRenderer(renderer);
  const view = vtkOpenGLRenderWindow.newInstance();
  renderWindow.addView(view);
  // Asked for here first, since vtk.js takes it for granted; a canvas has but one.
  const context = contextOf(view.getCanvas());
  if (!context) return null;
  view.setContainer(container);
  const [canvas] = container.getElementsByTagName('canvas');
  Object.assign(canvas.style, { width: '100%', height: '100%', display: 'block' });
  return { renderWindow, renderer, view, software: isSoftware(context) };
}

/** Whether the processor does the graphics card's work: then it is slow, known before the first frame. */
function isSoftware(context) {
  const info = context.getExtension('WEBGL_debug_renderer_info');
  const name = info ? context.getParameter(info.UNMASKED_RENDERER_WEBGL) : '';
  return /swiftshader|llvmpipe|software/i.test(name);
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

function nextShare(share, took_ms) {
  if (took_ms > SLOW_FRAME_MS) return Math.max(SMALLEST_PIXEL_RATIO, share * 0.75);
  return took_ms < SLOW_FRAME_MS / 3 ? Math.min(1, share * 1.2) : share;
}

function place(vtkCamera, camera, { size_mm, bounds_mm, reach_mm }) {
  const { up, back } = axes(camera);
  const distance = eyeDistance(camera, size_mm);
  vtkCamera.setParallelProjection(!camera.perspective);
  vtkCamera.setViewAngle(2 * HALF_ANGLE_DEG);
  vtkCamera.setParallelScale(camera.scale);
  vtkCamera.setFocalPoint(...camera.focal);
  vtkCamera.setPosition(...add(camera.focal, scaled(back, distance)));
  vtkCamera.setViewUp(...up);
  const reach = reach_mm + length(subtract(camera.focal, middle(bounds_mm)));
  vtkCamera.setClippingRange(Math.max(distance - reach, 0.01 * distance), distance + reach);
}
