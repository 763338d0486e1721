#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "reports/json/values.h"
#include "reports/probe/probe_report.h"
#include "reports/probe/probe_words.h"
#include "reports/text/embedded.h"

namespace limitgauge::reports::probe {
namespace {

using json::finite;
using json::Json;
using json::point;

Json input_json(const ProbeInput& input) {
  return {{"file", clean_text(input.file)}, {"sha256", input.sha256}};
}

Json stages_json(const ProbeResult& result) {
  Json out = Json::array();
  for (const CutBy& stage : result.stages)
    out.push_back({{"name", clean_text(stage.name)},
                   {"cutter", stage.cutter},
                   {"moves", stage.moves},
                   {"chord_error_mm", finite("chord_error_mm", stage.chord_error_mm)}});
  return out;
}

/// What there is none of has no key.
Json residual_json(const verifier::ProbeResidual& residual) {
  Json out = {{"value_mm", finite("value_mm", residual.gap.value_mm)},
              {"low_mm", finite("low_mm", residual.low_mm)}};
  if (residual.high_mm) out["high_mm"] = finite("high_mm", *residual.high_mm);
  return out;
}

Json point_json(const ProbeResult& result, const ProbedPoint& probed) {
  Json out = {{"file_line", probed.measured.line},
              {"at_mm", point("at_mm", probed.measured.at_mm)}};
  if (result.has_uncertainty) out["u_mm"] = finite("u_mm", probed.measured.u_mm);
  out["residual"] = residual_json(probed.before);
  out["shifted"] = residual_json(probed.after);
  if (!probed.nearest) {
    out["made_by"] = "raw stock";
    return out;
  }
  out["made_by"] = probed.nearest->is_rapid ? "rapid" : "feed";
  out["stage"] = clean_text(result.stages[probed.nearest->stage].name);
  if (probed.nearest->line > 0) out["program_line"] = probed.nearest->line;
  out["move"] = probed.nearest->move;
  return out;
}

Json axis_json(const verifier::ZeroShift& shift, int axis) {
  Json out = {{"axis", axis_name(axis, false)}, {"determined", shift.axes_mm[axis].has_value()}};
  if (shift.axes_mm[axis]) out["shift_mm"] = finite("shift_mm", *shift.axes_mm[axis]);
  if (shift.axes_u_mm[axis]) out["u_mm"] = finite("u_mm", *shift.axes_u_mm[axis]);
  const std::string why = why_undetermined(shift, axis) + why_no_uncertainty(shift, axis);
  if (!why.empty()) out["why"] = why;
  return out;
}

Json direction_json(const verifier::FitDirection& direction) {
  Json out = {{"along", point("along", direction.along)},
              {"leverage", finite("leverage", direction.leverage)},
              {"determined", direction.determined}};
  if (direction.determined) out["shift_mm"] = finite("shift_mm", direction.shift_mm);
  return out;
}

Json correlation_json(const verifier::ZeroShift& shift) {
  constexpr const char* kPairs[] = {"yz", "zx", "xy"};
  Json out = Json::object();
  for (int pair = 0; pair < 3; ++pair)
    if (shift.correlation[pair])
      out[kPairs[pair]] = finite("correlation", *shift.correlation[pair]);
  return out;
}

Json shift_json(const ProbeResult& result) {
  const verifier::ZeroShift& shift = result.shift;
  Json axes = Json::array(), directions = Json::array();
  for (int axis = 0; axis < 3; ++axis) axes.push_back(axis_json(shift, axis));
  for (const verifier::FitDirection& one : shift.directions)
    directions.push_back(direction_json(one));
  Json out = {{"axes", std::move(axes)},
              {"directions", std::move(directions)},
              {"correlation", correlation_json(shift)},
              {"taken_back_mm", point("taken_back_mm", shift.shift_mm)},
              {"degrees_of_freedom", shift.degrees_of_freedom}};
  if (shift.scatter_mm) out["scatter_mm"] = finite("scatter_mm", *shift.scatter_mm);
  if (const auto ratio = scatter_ratio(result)) out["scatter_ratio"] = finite("ratio", *ratio);
  out["steps"] = shift.steps;
  out["last_step_mm"] = finite("last_step_mm", shift.last_step_mm);
  out["settled"] = shift.settled;
  return out;
}

Json summary_json(const ProbeResult& result, Residuals which) {
  const bool before = which == Residuals::before;
  const double rms = before ? result.shift.rms_before_mm : result.shift.rms_after_mm;
  return {{"rms_mm", finite("rms_mm", rms)},
          {"worst", point_json(result, worst_point(result, which))}};
}

Json gate_json(const ResidualGate& gate) {
  return {{"residual_mm", finite("residual_mm", gate.limit_mm)},
          {"coverage_factor", kCoverageFactor},
          {"verdict", verifier::name(gate.verdict)},
          {"beyond", gate.beyond},
          {"undecided", gate.undecided}};
}

Json worst_json(const ProbeResult& result) {
  Json out = Json::array();
  for (const std::size_t i : worst_first(result, Residuals::after)) {
    if (out.size() == kMostListed) break;
    out.push_back(point_json(result, result.points[i]));
  }
  return out;
}

}  // namespace

void write_probe_json(const ProbeResult& result, std::ostream& out) {
  Json all = {{"schema", "limitgauge.probe/1"},
              {"version", result.version},
              {"job", clean_text(result.job)},
              {"result", input_json(result.result)},
              {"result_version", clean_text(result.result_version)},
              {"points_file", input_json(result.points_file)},
              {"stage", clean_text(result.stages.back().name)},
              {"stage_verdict", verifier::name(result.stage_verdict)},
              {"stages", stages_json(result)},
              {"points", result.points.size()},
              {"uncertainty_stated", result.has_uncertainty},
              {"shift", shift_json(result)},
              {"before", summary_json(result, Residuals::before)},
              {"after", summary_json(result, Residuals::after)}};
  if (result.gate) all["gate"] = gate_json(*result.gate);
  all["remarks"] = json::texts(result.remarks);
  all["worst"] = worst_json(result);
  out << all.dump(1) << '\n';
}

const std::string& probe_schema() {
  static const std::string text{embedded::probe_schema()};
  return text;
}

}  // namespace limitgauge::reports::probe
