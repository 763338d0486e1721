#include "tests/reports/compare/compare_support.h"

#include <stdexcept>

#include "reports/compare/run_comparison.h"

namespace limitgauge::reports::compare {

record::RunRecord sample_run() {
  record::StageMeasures m;
  m.machining_time_s = 100;
  record::DeviationMeasures& d = m.deviation.emplace();
  d.gouge_mm = {0, 0.001};
  d.uncut_mm = {0.005, 0.006};
  d.resolution_mm = 0.001;
  d.gouge_threshold_mm = d.uncut_threshold_mm = 0.01;
  d.coverage = 0.999;
  d.rms_mm = 0.003;
  d.p01_mm = 0.001;
  d.p99_mm = 0.004;
  d.sampled_mm = verifier::Interval{0.0005, 0.005};
  m.voxel_mm = 0.1;
  record::StageRecord stage;
  stage.name = "finish";
  stage.tool = "ball3";
  stage.strategy = "zigzag";
  stage.allowance_mm = 0;
  stage.limits = {true, true, true, 0.01, 0.01, 0.99};
  stage.verdict = verifier::Verdict::pass;
  stage.measures = m;
  record::RunRecord run;
  run.job = "part";
  run.version = "1";
  run.verdict = verifier::Verdict::pass;
  run.inputs = {{"job", "part.toml", "aa"}, {"cage", "part.obj", "bb"}};
  run.cage = "part.obj";
  run.diagonal_mm = 100;
  run.stages = {stage};
  return run;
}

const FigureChange& figure(const Comparison& comparison, const std::string& id) {
  for (const FigureChange& change : comparison.stages.at(0).figures)
    if (change.metric->id == id) return change;
  throw std::out_of_range(id);
}

Judgement judgement_of(const std::string& id, const record::RunRecord& base,
                       const record::RunRecord& now) {
  return figure(compare_runs(base, now, {}), id).judgement;
}

record::Place place_at(double x_mm, double depth_mm, std::uint32_t line) {
  record::Place place;
  place.at_mm = {x_mm, 0, 0};
  place.depth_mm = depth_mm;
  place.stage = "finish";
  place.line = line;
  place.line_text = "X" + std::to_string(static_cast<int>(x_mm));
  return place;
}

}  // namespace limitgauge::reports::compare
