#include "reports/record/record_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/base/text_file.h"
#include "reports/record/json_value.h"

namespace limitgauge::reports::record {
namespace {

using verifier::Interval;

void read_gate(const JsonValue& gate, verifier::GateLimits& out) {
  const auto limit = [&gate](const char* key, bool& has, double& value, bool is_share) {
    const std::optional<JsonValue> stated = gate.find(key);
    has = stated.has_value();
    if (stated) value = is_share ? stated->share() : stated->length();
  };
  limit("gouge_mm", out.has_gouge, out.gouge_mm, false);
  limit("uncut_mm", out.has_uncut, out.uncut_mm, false);
  limit("coverage", out.has_coverage, out.coverage, true);
  limit("unavoidable_mm", out.has_unavoidable, out.unavoidable_mm, false);
  out.unreachable_is_share = !gate.find("unreachable_mm2");
  limit(out.unreachable_is_share ? "unreachable" : "unreachable_mm2", out.has_unreachable,
        out.unreachable, out.unreachable_is_share);
}

void read_toolpath(const JsonValue& path, StageMeasures& out) {
  out.machining_time_s = path["machining_time_s"].length();
  out.cut_length_mm = path["cut_length_mm"].length();
  out.rapid_length_mm = path["rapid_length_mm"].length();
  out.moves = path["moves"].count();
}

void read_simulation(const JsonValue& simulation, StageMeasures& out) {
  out.voxel_mm = simulation["voxel_mm"].length();
  out.removed_volume_mm3 = simulation["removed_volume_mm3"].number();
  out.peak_memory_bytes = simulation["peak_memory_bytes"].count();
}

/// The ends of the histogram are those of the samples.
std::optional<verifier::Interval> read_sampled(const JsonValue& deviation) {
  const std::vector<JsonValue> edges = deviation["histogram"]["edges_mm"].items();
  if (edges.empty()) return std::nullopt;
  const verifier::Interval out{edges.front().number(), edges.back().number()};
  if (out.low > out.high) deviation["histogram"].refuse("falls", "edges that rise");
  return out;
}

void read_statistics(const JsonValue& deviation, DeviationMeasures& out) {
  out.coverage = deviation["coverage"].share();
  out.mean_mm = deviation["mean_mm"].number();
  out.rms_mm = deviation["rms_mm"].length();
  out.p01_mm = deviation["p01_mm"].number();
  out.p50_mm = deviation["p50_mm"].number();
  out.p99_mm = deviation["p99_mm"].number();
  out.sampled_mm = read_sampled(deviation);
  out.voxel_gouge_mm = deviation["voxel_gouge_mm"].length();
  out.voxel_uncut_mm = deviation["voxel_uncut_mm"].length();
  out.unreachable_area_mm2 = deviation["unreachable_area_mm2"].length();
  out.unavoidable_uncut_mm = deviation["unavoidable_uncut_mm"].length();
  const std::optional<JsonValue> certified = deviation.find("unavoidable_uncut_certified_mm");
  out.unavoidable_mm = certified ? certified->interval()
                                 : Interval{out.unavoidable_uncut_mm, out.unavoidable_uncut_mm};
}

/// What results of schema 1 did not know.
void read_reach(const JsonValue& deviation, const std::string& name, const LineTexts& texts,
                DeviationMeasures& out) {
  const JsonValue reach = deviation["reach"];
  out.reach = {reach["reachable_mm2"].length(), reach["unreachable_mm2"].length(),
               reach["undecided_mm2"].length()};
  if (const std::optional<JsonValue> area = deviation.find("reachable_area_mm2"))
    out.reachable_area_mm2 = area->length();
  out.missing_stock_mm = deviation["missing_stock_mm"].interval();
  out.missing_stock = read_places(deviation["missing_stocks"].items(), name, texts);
}

/// The schema lets a result leave these out; what it then stands for follows from the rest.
void read_certificate(const JsonValue& deviation, DeviationMeasures& out) {
  out.gouge_mm = deviation["gouge_mm"].interval();
  out.uncut_mm = deviation["uncut_mm"].interval();
  const auto or_else = [&deviation](const char* key, double other) {
    const std::optional<JsonValue> stated = deviation.find(key);
    return stated ? stated->length() : other;
  };
  const auto flag = [&deviation](const char* key) {
    const std::optional<JsonValue> stated = deviation.find(key);
    return !stated || stated->flag();
  };
  out.resolution_mm =
      or_else("resolution_mm", std::max(out.gouge_mm.width(), out.uncut_mm.width()));
  out.reached_resolution = flag("reached_resolution");
  out.findings_complete = flag("findings_complete");
  out.gouge_threshold_mm = or_else("gouge_threshold_mm", out.gouge_mm.low / 2);
  out.uncut_threshold_mm = or_else("uncut_threshold_mm", out.uncut_mm.low / 2);
}

DeviationMeasures read_deviation(const JsonValue& deviation, const std::string& name, int schema,
                                 const LineTexts& texts) {
  DeviationMeasures out;
  read_certificate(deviation, out);
  read_statistics(deviation, out);
  out.gouges = read_places(deviation["gouges"].items(), name, texts);
  out.uncuts = read_places(deviation["uncuts"].items(), name, texts);
  if (schema > 1) read_reach(deviation, name, texts, out);
  if (const std::optional<JsonValue> robust = deviation.find("robust"))
    out.robust = read_robust(*robust, name, texts);
  return out;
}

/// Against a design where the run has one.
StageMeasures read_measures(const JsonValue& stage, const std::string& name,
                            const StageContext& run) {
  StageMeasures out;
  read_toolpath(stage["toolpath"], out);
  const JsonValue simulation = stage["simulation"];
  read_simulation(simulation, out);
  // Of a stretch of a program that turns rotary axes, only the last that cuts is sure to have one.
  const bool is_measured = !stage.find("stretch") || stage.find("deviation");
  if (run.has_design && is_measured)
    out.deviation = read_deviation(stage["deviation"], name, run.schema, run.texts);
  out.process_findings = read_process(simulation, name, run);
  out.process = count_process(out.process_findings);
  out.seconds = stage["seconds"].length();
  return out;
}

void read_setup(const JsonValue& stage, bool has_design, StageRecord& out) {
  if (const std::optional<JsonValue> strategy = stage.find("strategy"))
    out.strategy = strategy->text();
  else if (const std::optional<JsonValue> program = stage.find("program"))
    out.program = program->text();
  else
    stage.refuse("has neither a \"strategy\" nor a \"program\"", "one of them");
  if (has_design) out.allowance_mm = stage["allowance_mm"].number();
  if (const std::optional<JsonValue> step = stage.find("step_mm")) out.step_mm = step->length();
  if (const std::optional<JsonValue> t = stage.find("tolerance_mm")) out.tolerance_mm = t->length();
  if (const std::optional<JsonValue> gate = stage.find("gate")) read_gate(*gate, out.limits);
}

}  // namespace

verifier::Verdict read_verdict(const JsonValue& value) {
  const std::string word = value.text();
  if (word == "pass") return verifier::Verdict::pass;
  if (word == "fail") return verifier::Verdict::fail;
  if (word == "indeterminate") return verifier::Verdict::indeterminate;
  if (word == "not_run") return verifier::Verdict::not_run;
  value.refuse("is no verdict", "pass, fail, indeterminate or not_run");
}

StageRecord read_stage(const JsonValue& stage, const StageContext& run) {
  StageRecord out;
  out.name = stage["name"].text();
  out.tool = stage["tool"].text();
  if (const std::optional<JsonValue> cutter = stage.find("cutter"))
    if (const std::optional<JsonValue> text = cutter->find("text")) out.cutter = text->text();
  read_setup(stage, run.has_design, out);
  out.verdict = read_verdict(stage["verdict"]);
  for (const JsonValue& reason : stage["reasons"].items()) out.reasons.push_back(reason.text());
  if (out.verdict != verifier::Verdict::not_run) out.measures = read_measures(stage, out.name, run);
  return out;
}

namespace {

constexpr const char* kSchema = "limitgauge.result/";

/// An axis without limits has none.
std::optional<model::Box3> read_travel(const JsonValue& travel) {
  if (travel.is_null()) return std::nullopt;
  model::Box3 out;
  const std::vector<JsonValue> ends = travel.items();
  if (ends.size() != 3) travel.refuse("has not three entries", "a range or null for each axis");
  for (int axis = 0; axis < 3; ++axis) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const verifier::Interval range =
        ends[axis].is_null() ? verifier::Interval{-kNone, kNone} : ends[axis].range();
    out.low[axis] = range.low, out.high[axis] = range.high;
  }
  return out;
}

CheckedFixture read_fixture(const JsonValue& f) {
  CheckedFixture out{f["name"].text(), f["file"].text(), f["translate_mm"].point(), {}, {}};
  if (const auto setup = f.find("setup")) out.setup = setup->text();
  if (const auto axis = f.find("axis")) out.axis = axis->text();
  return out;
}

RotaryAxis read_rotary_axis(const JsonValue& a) {
  RotaryAxis out;
  out.word = a["word"].text();
  const JsonValue carries = a["carries"];
  out.is_head = carries.text() == "tool";
  if (!out.is_head && carries.text() != "part")
    carries.refuse("is another one", "\"tool\" or \"part\"");
  out.direction = a["direction"].point();
  out.point_mm = a["point_mm"].point();
  const std::vector<JsonValue> ends = a["range_deg"].items();
  if (ends.size() != 2)
    a["range_deg"].refuse("has not two entries", "a number or null for each end");
  if (!ends[0].is_null()) out.low_deg = ends[0].number();
  if (!ends[1].is_null()) out.high_deg = ends[1].number();
  return out;
}

template <class Read>
auto read_all(const JsonValue& list, const Read& read) {
  std::vector<decltype(read(list))> out;
  for (const JsonValue& one : list.items()) out.push_back(read(one));
  return out;
}

ProcessLimits read_process_limits(const JsonValue& limits) {
  ProcessLimits out;
  out.contact_tolerance_mm = limits["contact_tolerance_mm"].length();
  out.near_miss_mm = limits["near_miss_mm"].length();
  out.travel_mm = read_travel(limits["travel_mm"]);
  if (const auto fixtures = limits.find("fixtures"))
    out.fixtures = read_all(*fixtures, read_fixture);
  if (const auto axes = limits.find("rotary_axes"))
    out.rotary_axes = read_all(*axes, read_rotary_axis);
  return out;
}

int read_schema(const JsonValue& root) {
  const std::string known = std::string(kSchema) + "1 or " + kSchema + "2";
  const std::optional<JsonValue> schema = root.find("schema");
  if (!schema) root.refuse("has no key \"schema\"", "a result of schema " + known);
  for (const int version : {1, 2})
    if (schema->text() == kSchema + std::to_string(version)) return version;
  schema->refuse("is another one", known);
}

/// A finding may name a line of an earlier stage's program: all are gathered first.
LineTexts line_texts(const std::vector<JsonValue>& stages) {
  LineTexts out;
  for (const JsonValue& stage : stages) {
    const std::string name = stage["name"].text();
    for (const JsonValue& entry : stage.items("program_lines")) {
      const std::uint64_t line = entry["line"].count(std::numeric_limits<std::uint32_t>::max());
      out[{name, static_cast<std::uint32_t>(line)}] = entry["text"].text();
    }
  }
  return out;
}

std::vector<InputRecord> read_inputs(const JsonValue& root) {
  std::vector<InputRecord> out;
  for (const JsonValue& input : root.items("inputs"))
    out.push_back({input["role"].text(), input["file"].text(), input["sha256"].text()});
  return out;
}

void read_surface(const JsonValue& surface, RunRecord& out) {
  const std::optional<JsonValue> mesh = surface.find("mesh");
  out.cage = (mesh ? *mesh : surface["cage"]).text();
  const std::vector<JsonValue> corners = surface["bbox_mm"].items();
  if (corners.size() != 2)
    surface["bbox_mm"].refuse("has not two corners", "lower and upper corner");
  const model::Box3 box{corners[0].point(), corners[1].point()};
  out.diagonal_mm = model::distance(box.low, box.high);
  if (const std::optional<JsonValue> area = surface.find("area_mm2"))
    out.design = {box, area->length()};
}

void read_asked(const JsonValue& root, RunRecord& out) {
  for (const JsonValue& override : root.items("overrides"))
    out.overrides.push_back(override.text());
  const auto json = [&root](const char* key) {
    const std::optional<JsonValue> part = root.find(key);
    return part ? part->json() : std::string();
  };
  out.stock = json("stock"), out.programs = json("programs"), out.setups = json("setups");
}

double stock_diagonal_mm(const JsonValue& stock) {
  if (const std::optional<JsonValue> size = stock.find("size_mm"))
    return model::length(size->point());
  return std::hypot(stock["diameter_mm"].length(), stock["height_mm"].length());
}

}  // namespace

RunRecord read_result_json(std::istream& in, const std::string& shown) {
  const nlohmann::json tree = parse_json(model::read_text(in, shown), shown);
  const JsonValue root(tree, shown);
  RunRecord out;
  out.schema = read_schema(root);
  out.job = root["job"].text();
  out.version = root["version"].text();
  out.created = root["created"].text();
  if (const std::optional<JsonValue> label = root.find("label")) out.label = label->text();
  out.threads = static_cast<unsigned>(root["threads"].count(std::numeric_limits<unsigned>::max()));
  if (out.threads == 0) root["threads"].refuse("is zero", "one or more");
  out.verdict = read_verdict(root["verdict"]);
  out.inputs = read_inputs(root);
  const std::optional<JsonValue> surface = root.find("surface");
  if (surface) read_surface(*surface, out);
  read_asked(root, out);
  const std::vector<JsonValue> stages = root["stages"].items();
  const LineTexts texts = line_texts(stages);
  const std::optional<JsonValue> limits = root.find("process_limits");
  for (const JsonValue& stage : stages)
    out.stages.push_back(
        read_stage(stage, {out.schema, surface.has_value(), limits.has_value(), texts}));
  if (const std::optional<JsonValue> tolerances = root.find("tolerances"))
    out.tolerances = read_tolerances(*tolerances);
  if (limits) out.process_limits = read_process_limits(*limits);
  if (!surface) out.diagonal_mm = stock_diagonal_mm(root["stock"]);
  return out;
}

}  // namespace limitgauge::reports::record
