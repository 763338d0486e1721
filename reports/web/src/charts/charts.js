export function startCharts(report, root) {}
