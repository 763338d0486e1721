import { figureText, limitText, momentText, seriesTitle } from './data.js';

const VERDICTS = {
  pass: '\u2713 passed', fail: '\u2715 failed', indeterminate: '? undecided', not_run: '\u2013 not run',
};
export const verdictText = (verdict) => VERDICTS[verdict] ?? verdict;

/** Lines that say all of a run that its charts show. */
export function runLines(job, run) {
  const names = [run.commit, run.label].filter((name) => name);
  return [
    `run ${run.id} \u00b7 ${verdictText(run.verdict)}`, ...names, momentText(run),
    ...job.series.map((series) => `${seriesTitle(series)}: ${valueText(series, series.values[run.index])}`),
  ];
}

/** "[9.8, 12.8] µm, limit 30 µm, worse" */
export function valueText(series, value) {
  if (!value) return figureText(series, value);
  return [
    figureText(series, value), ...(value.limit === undefined ? [] : [limitText(series, value.limit)]),
    ...(value.trend ? [value.trend] : []),
  ].join(', ');
}
