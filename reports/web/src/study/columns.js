/** Of statuses, by what to look at first. */
const RANK = [0, 2, 1, 3, 4];

/** Columns of the table: what they are called, how rows are told apart by them, and what stands in them. */
export function tableColumns(study) {
  const quantity = (of) => ({
    id: of.id, title: of.title, isNumber: of.numeric, order: of.value,
    text: of.kind === 'key' ? of.text : of.cell,
  });
  return [
    { id: 'case', title: 'Case', isNumber: true, order: (row) => study.numbers[row] },
    { id: 'verdict', title: 'Verdict', order: verdictOrder(study) },
    ...study.keys.map(quantity), ...study.objectives.map((i) => quantity(study.figures[i])),
  ];
}

/** What to look at first: by verdict, then by the first objective. */
function verdictOrder(study) {
  const cost = study.figures[study.objectives[0]];
  const all = Array.from({ length: study.count }, (_, row) => row);
  const order = sortedRows(all, (row) => cost?.value(row) ?? null, false);
  const place = new Uint32Array(study.count);
  order.forEach((row, i) => (place[row] = i));
  return (row) => RANK[study.statuses[row]] * study.count + place[row];
}

/**
 * Rows by a column; what is missing comes last either way, and equal ones keep the order of cases.
 * @param {(row: number) => number|null} order
 */
export function sortedRows(rows, order, descending) {
  const sign = descending ? -1 : 1;
  return [...rows].sort((a, b) => {
    const x = order(a), y = order(b);
    if (x === null || y === null) return (x === null) - (y === null) || a - b;
    return sign * (x - y) || a - b;
  });
}
