#include "reports/json/result_parts.h"

#include "reports/run/program_lines.h"
#include "reports/text/text.h"

namespace limitgauge::reports::json {
namespace {

/// Only the figures that the job limits.
Json gate_part(const verifier::GateLimits& l) {
  Json out = Json::object();
  if (l.has_gouge) out["gouge_mm"] = finite("gate.gouge_mm", l.gouge_mm);
  if (l.has_uncut) out["uncut_mm"] = finite("gate.uncut_mm", l.uncut_mm);
  if (l.has_coverage) out["coverage"] = finite("gate.coverage", l.coverage);
  if (l.has_unreachable)
    out[l.unreachable_is_share ? "unreachable" : "unreachable_mm2"] =
        finite("gate.unreachable", l.unreachable);
  if (l.has_unavoidable) out["unavoidable_mm"] = finite("gate.unavoidable_mm", l.unavoidable_mm);
  return out;
}

Json cutter_part(const model::Cutter& c) {
  return {{"type", model::name(c.type)},
          {"diameter_mm", finite("cutter.diameter_mm", c.diameter_mm)},
          {"corner_radius_mm", finite("cutter.corner_radius_mm", c.corner_radius_mm)},
          {"flute_length_mm", finite("cutter.flute_length_mm", c.flute_length_mm)},
          {"taper_angle_deg", finite("cutter.taper_angle_deg", c.taper_angle_deg)},
          {"tip_angle_deg", finite("cutter.tip_angle_deg", c.tip_angle_deg)},
          {"text", model::to_text(c)}};
}

/// The text of the lines `wanted` and of those that findings name, of whatever stage found them.
Json named_program_lines(const RunResult& result, std::size_t index,
                         std::vector<std::uint32_t> wanted) {
  Json out = Json::array();
  if (!result.stages[index].ran || !result.stages[index].ran->program_text) return out;
  for (std::size_t stage = index; stage < result.stages.size(); ++stage)
    for (const NamedLine& named : named_lines(result, stage, std::string::npos))
      if (named.stage == index) wanted.push_back(named.line);
  for (const ProgramLine& line : program_lines(*result.stages[index].ran->program_text, wanted, 0))
    out.push_back({{"line", line.line}, {"text", line.text}});
  return out;
}

/// As it was, but for lines that only later stages' findings name.
Json recorded_part(const RunResult& result, std::size_t index) {
  Json out = Json::parse(*result.stages[index].recorded);
  std::vector<std::uint32_t> wanted;
  for (const Json& line : out.at("program_lines"))
    wanted.push_back(line.at("line").get<std::uint32_t>());
  out["program_lines"] = named_program_lines(result, index, std::move(wanted));
  return out;
}

Json lean_part(const StageRun::Lean& lean) {
  return {{"from", lean.from_surface ? "surface" : "vertical"},
          {"lead_deg", finite("lean.lead_deg", lean.lead_deg)},
          {"tilt_deg", finite("lean.tilt_deg", lean.tilt_deg)}};
}

}  // namespace

Json stage_part(const RunResult& result, std::size_t index) {
  const StageResult& s = result.stages[index];
  if (s.recorded) return recorded_part(result, index);
  Json out = {{"name", clean_text(s.name)}, {"tool", clean_text(s.tool)}};
  if (!s.setup.name.empty()) out["setup"] = clean_text(s.setup.name);
  out["cutter"] = cutter_part(s.cutter);
  if (s.program.empty()) {
    out["strategy"] = clean_text(s.strategy);
  } else {
    out["program"] = clean_text(s.program);
    if (!s.program_part.empty()) out["program_part"] = clean_text(s.program_part);
    if (s.stretch)
      out["stretch"] = {{"stage", clean_text(s.stretch->stage)},
                        {"number", s.stretch->number},
                        {"count", s.stretch->count},
                        {"axes", s.stretch->axes}};
  }
  if (s.allowance_mm) {
    out["allowance_mm"] = finite("stage.allowance_mm", *s.allowance_mm);
    out["step_mm"] = finite("stage.step_mm", s.step_mm);
    out["tolerance_mm"] = finite("stage.tolerance_mm", s.tolerance_mm);
  }
  out["gate"] = gate_part(s.limits);
  out["verdict"] = verifier::name(s.verdict());
  out["reasons"] = texts(s.decision.reasons);
  if (s.ran) {
    out["toolpath"] = toolpath_part(*s.ran);
    if (s.ran->lean) out["toolpath"]["lean"] = lean_part(*s.ran->lean);
    out["program_lines"] = named_program_lines(result, index, {});
    out["simulation"] = simulation_part(*s.ran);
    if (s.ran->deviation) out["deviation"] = deviation_part(result, *s.ran->deviation, s.limits);
  }
  out["seconds"] = finite("stage.seconds", s.seconds);
  return out;
}

Json toolpath_part(const StageRun& r) {
  return {
      {"moves", r.path ? r.path->moves.size() : 0},
      {"planes", r.planes},
      {"sampling_interval", {{"min", r.sampling_interval_min}, {"max", r.sampling_interval_max}}},
      {"sampling_intervals", r.sampling_intervals},
      {"cut_length_mm", finite("toolpath.cut_length_mm", r.cut_length_mm)},
      {"rapid_length_mm", finite("toolpath.rapid_length_mm", r.rapid_length_mm)},
      {"machining_time_s", finite("toolpath.machining_time_s", r.machining_time_s)},
      {"chord_error_mm", finite("toolpath.chord_error_mm", r.path ? r.path->chord_error_mm : 0)},
      {"ignored_words", texts(r.ignored_words)},
      {"seconds", finite("toolpath.seconds", r.plan_seconds)},
      {"memory_bytes", r.path_memory_bytes}};
}

}  // namespace limitgauge::reports::json
