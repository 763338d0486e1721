import { make } from '../base/dom.js';
import { coordinate, fixed } from '../base/format.js';
import { createLegend } from './legend.js';
import { clockMark, clockText, feedText, grouped, rateText } from '../base/figure_text.js';
import { leanDegrees } from './pose.js';

export const SPEEDS = [1, 5, 20, 60, 200, 600, 2000];
const WINDOWS_S = [0, 1, 5, 20, 60, 300, 1200];

/**
 * The controls of the toolpath. `on` is told what the reader did: colour(key), rapids(bool), veil(bool),
 * time(s), window(s), speed(factor), play(), step(direction).
 */
export function createPanel(on, veilWords = 'Map shows through') {
  const parts = controls();
  const legend = createLegend();
  const transport = [parts.back, parts.play, parts.forward, parts.slider, labelled('Speed', parts.speed)];
  const body = make('div', {}, [
    make('div', { class: 'path-row' }, [
      labelled('Path coloured by', parts.colour), labelled('Show', parts.window),
      labelled('Rapids', parts.rapids), labelled(veilWords, parts.veil),
    ]),
    parts.reason, legend.element,
    make('div', { class: 'path-row path-transport' }, transport),
    parts.readout, parts.exact,
  ]);
  const element = make('section', {
    class: 'path-panel', data: { testid: 'path-panel' }, 'aria-label': 'Toolpath', hidden: true,
  }, [parts.none, body]);
  listen(parts, on);
  return { element, ...updates(parts, legend, body) };
}

function controls() {
  const id = (name) => ({ data: { testid: `path-${name}` } });
  const button = (name, text, label) =>
    make('button', { type: 'button', ...id(name), 'aria-label': label, title: label, text });
  const choice = (name, values, textOf, more) => make('select', { ...id(name), ...more },
    values.map((value) => make('option', { value, text: textOf(value) })));
  return {
    none: make('p', {
      class: 'path-soft', ...id('none'), text: 'No path of this stage stands in the report.',
    }),
    colour: make('select', id('colour')),
    reason: make('p', { class: 'path-soft', ...id('reason') }),
    window: choice('window', WINDOWS_S, windowText),
    rapids: make('input', { type: 'checkbox', checked: true, ...id('rapids') }),
    veil: make('input', { type: 'checkbox', ...id('veil') }),
    back: button('back', '\u25c2|', 'To the end of the move before'),
    play: button('play', 'Play', 'Play the path'),
    forward: button('forward', '|\u25b8', 'To the end of the next move'),
    slider: make('input', { type: 'range', min: 0, ...id('time'), 'aria-label': 'Machining time' }),
    speed: choice('speed', SPEEDS, (s) => `\u00d7 ${grouped(s)}`,
      { title: 'Seconds of machining in one second' }),
    readout: make('dl', { class: 'path-readout', ...id('readout') }),
    exact: make('p', { class: 'path-soft', ...id('exact') }),
  };
}

/** A control with its words. */
const labelled = (text, control) => make('label', {}, [make('span', { text }), control]);

const windowText = (seconds) =>
  (seconds === 0 ? 'all up to this time' : `only the last ${clockMark(seconds)}`);

function listen(parts, on) {
  parts.rapids.addEventListener('change', () => on.rapids(parts.rapids.checked));
  parts.veil.addEventListener('change', () => on.veil(parts.veil.checked));
  parts.colour.addEventListener('change', () => on.colour(parts.colour.value));
  parts.window.addEventListener('change', () => on.window(Number(parts.window.value)));
  parts.speed.addEventListener('change', () => on.speed(Number(parts.speed.value)));
  parts.slider.addEventListener('input', () => on.time(Number(parts.slider.value)));
  parts.play.addEventListener('click', () => on.play());
  parts.back.addEventListener('click', () => on.step(-1));
  parts.forward.addEventListener('click', () => on.step(1));
}

function updates(parts, legend, body) {
  return {
    setAvailable(available) {
      parts.none.hidden = available;
      body.hidden = !available;
    },
    setChoices(choices) {
      parts.colour.replaceChildren(...choices.map(({ key, label, reason }) =>
        make('option', {
          value: key, disabled: Boolean(reason), text: reason ? `${label}: not available` : label,
        })));
      parts.reason.textContent = choices.filter(({ reason }) => reason)
        .map(({ label, reason }) => `${label}: not available, ${reason}.`).join(' ');
      parts.reason.hidden = parts.reason.textContent === '';
    },
    setColour(chosen) {
      parts.colour.value = chosen.key;
      legend.update(chosen);
    },
    setRapids: (shown) => legend.setRapids(shown),
    setScale({ max_s, step_s }) {
      parts.slider.max = max_s;
      parts.slider.step = step_s;
    },
    setWindow: (seconds) => (parts.window.value = seconds),
    setExact: (text) => (parts.exact.textContent = text),
    setSpeed: (factor) => (parts.speed.value = factor),
    setPlaying(playing) {
      parts.play.textContent = playing ? 'Pause' : 'Play';
      parts.play.setAttribute('aria-label', playing ? 'Pause the path' : 'Play the path');
      parts.play.title = parts.play.getAttribute('aria-label');
    },
    setTime: (now, total_s, decimals, text) => showTime(parts, now, total_s, decimals, text),
  };
}

/** What the machine does now, as figures; the slider says it to those who do not see it. */
function showTime(parts, now, total_s, decimals, text) {
  parts.slider.value = now.time_s;
  const time = `${clockText(now.time_s, decimals)} of ${clockText(total_s, decimals)}`;
  parts.slider.setAttribute('aria-valuetext', `${time}, program line ${now.line}`);
  const figures = [
    ['Time', time],
    ['Program line', now.line > 0 ? grouped(now.line) : 'none'],
    ['Feed', now.kind === 'rapid' ? 'rapid' : feedText(now.feed_mm_min)],
    ['Removal rate', now.rate_mm3_min === null ? 'not measured' : rateText(now.rate_mm3_min)],
    ['Tool tip (X, Y, Z)', `${now.point_mm.map(coordinate).join(', ')} mm`],
  ];
  if (now.axis)
    figures.push(['Tool axis (I, J, K)', now.axis.map((c) => fixed(c, 4)).join(', ')],
      ['Lean from +Z', `${fixed(leanDegrees(now.axis), 2)}°`]);
  const items = figures.map(([name, value]) =>
    make('div', {}, [make('dt', { text: name }), make('dd', { data: { figure: name }, text: value })]));
  if (text)
    items.push(make('div', { class: 'path-text' },
      [make('dt', { text: 'Program' }), make('dd', {}, [make('code', { text })])]));
  parts.readout.replaceChildren(...items);
}
