import { make } from '../base/dom.js';

const WORDS = { pass: 'passed', fail: 'failed', indeterminate: 'undecided', not_run: 'not run' };
const CLASSES = { pass: 'pass', fail: 'fail', indeterminate: 'open' };

/** Tabs for the stages, left and right arrow move between them. */
export function createStageTabs(stages, panelId, choose) {
  const tabs = stages.map((stage, index) => make('button', {
    type: 'button', role: 'tab', data: { stage: index }, 'aria-controls': panelId, disabled: !stage.field && !stage.stock,
    on: { click: () => choose(index) },
  }, [
    make('span', { text: stage.name }),
    make('span', {
      class: `badge ${CLASSES[stage.verdict] ?? ''}`, text: WORDS[stage.verdict] ?? stage.verdict,
    }),
  ]));
  const element = make('div', {
    class: 'view-tabs', role: 'tablist', 'aria-label': 'Stage', data: { testid: 'view-stages' },
    on: { keydown: (event) => step(event, tabs) },
  }, tabs);
  return {
    element,
    show: (index) => tabs.forEach((tab, k) => {
      tab.setAttribute('aria-selected', String(k === index));
      tab.tabIndex = k === index ? 0 : -1;
    }),
  };
}

function step(event, tabs) {
  const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if (!way) return;
  event.preventDefault();
  const open = tabs.filter((tab) => !tab.disabled);
  const next = open[(open.indexOf(document.activeElement) + way + open.length) % open.length];
  next.focus();
  next.click();
}
