/**
 * The rows that no other one beats: of rows that cost more only those that are better than all before.
 * @param {number[]} rows
 * @param {(row: number) => number|null} x what is paid, as it is to be small
 * @param {(row: number) => number|null} y what is bought, as it is to be small
 * @returns {number[]} by rising x
 */
export function paretoFront(rows, x, y) {
  const order = rows.filter((row) => x(row) !== null && y(row) !== null)
    .sort((a, b) => x(a) - x(b) || y(a) - y(b) || a - b);
  const front = [];
  let best = Infinity;
  for (const row of order) {
    if (!(y(row) < best)) continue;
    best = y(row);
    front.push(row);
  }
  return front;
}
