/** The chosen stage, its surface and field. */
export function current({ report, state }) {
  const stage = report.stages[state.stage];
  return { stage, field: stage.field, surface: report.surfaces[stage.field.surface] };
}
