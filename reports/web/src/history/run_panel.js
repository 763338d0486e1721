import { make } from '../base/dom.js';
import { momentText, seriesTitle } from './data.js';
import { valueText, verdictText } from './run_text.js';

/**
 * What is known of the pinned run, said aloud when another is pinned.
 * @param {object} job as decodeHistory gives it
 * @param {(run: object|null) => void} pin
 * @returns {{element: HTMLElement, show(run: object|null): void}}
 */
export function createRunPanel(job, pin) {
  const element = make('div', {
    class: 'history-run', role: 'status', 'aria-label': `Pinned run of ${job.job}`,
    data: { testid: 'history-run' },
  });
  const show = (run) => element.replaceChildren(...(run ? contents(job, run, pin) : [hint()]));
  show(null);
  return { element, show };
}

const hint = () => make('p', { class: 'note', text: 'A click on the charts pins a run and says all of it.' });

function contents(job, run, pin) {
  const line = (name, value) => make('div', {}, [make('dt', { text: name }), make('dd', { text: value })]);
  const named = [['Commit', run.commit], ['Label', run.label]].filter(([, value]) => value);
  const link = make('a', { href: `#run-${run.id}`, text: `Run ${run.id}` });
  return [
    make('p', { class: 'history-run-head' }, [
      make('strong', {}, [link]), ` ${verdictText(run.verdict)}`,
      make('button', { type: 'button', text: 'Unpin', on: { click: () => pin(null) } }),
    ]),
    make('dl', {}, [
      line('Time', momentText(run)), ...named.map(([name, value]) => line(name, value)),
      line('Limitgauge', run.version),
      ...run.stages.map(({ name, verdict }) => line(`Stage ${name}`, verdictText(verdict))),
      ...job.series.map((series) => line(seriesTitle(series), valueText(series, series.values[run.index]))),
    ]),
  ];
}
