/**
 * What the reader has chosen: ranges of quantities, verdicts, one case; every chart and the table follow.
 * @param {object} study as decodeStudy gives it
 */
export function createBoard(study) {
  const state = { ranges: new Map(), statuses: new Set([0, 1, 2, 3, 4]), chosen: null };
  const followers = { filter: [], choice: [] };
  let rows = filteredRows(study, state);
  const tell = (what) => followers[what].forEach((follow) => follow());
  const filtered = (from) => {
    rows = filteredRows(study, state);
    followers.filter.forEach((follow) => follow(from));
  };
  return {
    study,
    rows: () => rows,
    chosen: () => state.chosen,
    ranges: () => state.ranges,
    shows: (status) => state.statuses.has(status),
    isFiltered: () => state.ranges.size > 0 || state.statuses.size < 5,
    /** Intervals [low, high] of a quantity, any of which a case may lie in; none lifts the filter. */
    setRanges(id, intervals, from) {
      if (intervals.length > 0) state.ranges.set(id, intervals);
      else if (!state.ranges.delete(id)) return;
      filtered(from);
    },
    setStatus(status, shown) {
      if (shown) state.statuses.add(status);
      else state.statuses.delete(status);
      filtered();
    },
    clear() {
      state.ranges.clear();
      state.statuses = new Set([0, 1, 2, 3, 4]);
      filtered();
    },
    choose(row) {
      state.chosen = row;
      tell('choice');
    },
    /** `follow(from)` is called after each change of the filter; `from` is who made it. */
    onFilter: (follow) => followers.filter.push(follow),
    onChoice: (follow) => followers.choice.push(follow),
  };
}

/** The rows that lie in a range of each quantity that has ranges, with one of the statuses. */
export function filteredRows(study, { ranges, statuses }) {
  const tests = study.quantities.filter(({ id }) => ranges.has(id))
    .map(({ id, value }) => ({ value, intervals: ranges.get(id) }));
  const rows = [];
  for (let row = 0; row < study.count; ++row)
    if (statuses.has(study.statuses[row]) && tests.every((test) => isWithin(test, row))) rows.push(row);
  return rows;
}

function isWithin({ value, intervals }, row) {
  const at = value(row);
  return at !== null && intervals.some(([low, high]) => at >= low && at <= high);
}
