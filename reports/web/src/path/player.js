/**
 * Runs machining time on against the wall clock.
 * @param {(seconds: number) => boolean} advance is given how many seconds of machining passed and says
 *   whether to go on
 */
export function createPlayer(advance, { requestFrame, cancelFrame } = browserFrames()) {
  let frame = null, last = null, speed = 1;
  const step = (now_ms) => {
    const seconds = last === null ? 0 : (now_ms - last) / 1000;
    last = now_ms;
    frame = advance(seconds * speed) ? requestFrame(step) : null;
  };
  return {
    playing: () => frame !== null,
    speed: () => speed,
    setSpeed: (factor) => (speed = factor),
    start() {
      last = null;
      frame ??= requestFrame(step);
    },
    stop() {
      if (frame !== null) cancelFrame(frame);
      frame = null;
    },
  };
}

function browserFrames() {
  return {
    requestFrame: (callback) => globalThis.requestAnimationFrame(callback),
    cancelFrame: (frame) => globalThis.cancelAnimationFrame(frame),
  };
}
