/**
 * The report's data as the page holds them (see ../../README.md), unpacked into typed arrays.
 * @param {Document} document
 */
export async function decodeReport(document) {
  return JSON.parse(document.getElementById('limitgauge-report').textContent);
}
