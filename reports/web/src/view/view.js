export async function startView(report, element) {}
