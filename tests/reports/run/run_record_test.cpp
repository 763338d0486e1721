#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "model/base/error.h"
#include "reports/record/metrics.h"
#include "reports/record/record_reader.h"
#include "reports/run/report.h"
#include "tests/reports/hostile_result.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;
using namespace limitgauge::reports::record;
using RecordJson = nlohmann::json;

namespace {

std::string record_text_of(const RunResult& result) {
  std::ostringstream out;
  write_result_json(result, out);
  return out.str();
}

RunRecord read(const std::string& text) {
  std::istringstream in(text);
  return read_result_json(in, "r.json");
}

std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const model::InputError& error) {
    return error.what();
  }
  return "none";
}

/// What is said of the sample once `value` stands at `where`, a JSON pointer.
std::string error_with(const std::string& where, const RecordJson& value) {
  RecordJson json = RecordJson::parse(record_text_of(sample_result(Outcome::failed)));
  json[RecordJson::json_pointer(where)] = value;
  return error_of(json.dump());
}

}  // namespace

TEST_CASE("A result is read back as it was written", "[unit][record]") {
  const RunResult written = sample_result(Outcome::failed);
  const RunRecord run = read(record_text_of(written));
  CHECK(run.job == written.job);
  CHECK(run.threads == written.threads);
  CHECK(run.verdict == written.verdict);
  REQUIRE(run.stages.size() == written.stages.size());
  REQUIRE(run.inputs.size() == written.inputs.size());
  const StageRecord& stage = run.stages[1];
  const StageResult& from = written.stages[1];
  CHECK(stage.name == from.name);
  CHECK(stage.verdict == verifier::Verdict::fail);
  CHECK(stage.reasons == from.decision.reasons);
  CHECK(stage.limits.gouge_mm == from.limits.gouge_mm);
  CHECK_FALSE(run.stages[2].measures);
  REQUIRE(stage.measures);
  const verifier::StageDeviation& deviation = *from.ran->deviation;
  CHECK(stage.measures->deviation->uncut_mm.low == deviation.uncut_mm.low);
  CHECK(stage.measures->deviation->uncut_mm.high == deviation.uncut_mm.high);
  CHECK(stage.measures->deviation->rms_mm == deviation.rms_mm);
  CHECK(stage.measures->deviation->resolution_mm == deviation.resolution_mm);
  REQUIRE(stage.measures->deviation->gouges.size() == deviation.gouges.size());
  REQUIRE(!deviation.gouges.empty());
  const Place& place = stage.measures->deviation->gouges[0];
  CHECK(place.at_mm == deviation.gouges[0].place.point);
  CHECK(place.line == deviation.gouges[0].line);
  CHECK(place.stage == written.stages[deviation.gouges[0].stage].name);
  CHECK_FALSE(place.line_text.empty());
  CHECK(place.extent_mm > 0);
  std::size_t moves = 0;
  for (const ProcessCount& c : stage.measures->process) moves += c.count;
  CHECK(moves == from.ran->process.size());
}

TEST_CASE("Every metric finds its figure under its own name", "[unit][record]") {
  const std::string text = record_text_of(sample_result(Outcome::failed));
  const RunRecord run = read(text);
  const RecordJson stage = RecordJson::parse(text)["stages"][1];
  for (const Metric& metric : stage_metrics()) {
    INFO(metric.id);
    CHECK(find_metric(metric.id) == &metric);
    const std::optional<verifier::Interval> had = metric.of(*run.stages[1].measures);
    const std::string id(metric.id);
    if (!had) {  // The sample states no tolerances.
      CHECK((id.starts_with("robust_") || id == "margin"));
      continue;
    }
    const verifier::Interval& figure = *had;
    const RecordJson* found = stage.contains(id) ? &stage[id] : nullptr;
    for (const char* part : {"toolpath", "simulation", "deviation"})
      if (!found && stage[part].contains(id)) found = &stage[part][id];
    REQUIRE(found);
    if (found->is_object()) {
      CHECK(metric.source == Source::certified);
      CHECK(figure.low == (*found)["low"].get<double>());
      CHECK(figure.high == (*found)["high"].get<double>());
    } else {
      CHECK(figure.low == found->get<double>());
      CHECK(figure.high == figure.low);
    }
  }
  CHECK(find_metric("speed") == nullptr);
  CHECK(machining_time_s(run) ==
        run.stages[0].measures->machining_time_s + run.stages[1].measures->machining_time_s);
}

TEST_CASE("Broken JSON is refused where it breaks", "[unit][record]") {
  CHECK(error_of("") ==
        "r.json:1:1: error: broken JSON: nothing is there; expected result.json as limitgauge "
        "writes it");
  CHECK(error_of("{\n \"a\": NaN}").starts_with("r.json:2:7: error: broken JSON: "));
  CHECK(error_of("{\n\n  \"a\": 1e999}").starts_with("r.json:3:12: error: broken JSON: number"));
  CHECK(error_of("{\"a\": \"\xff\"}").starts_with("r.json:1:8: error: broken JSON: "));
  const std::string whole = record_text_of(sample_result(Outcome::passed));
  for (std::size_t length = 0; length + 2 < whole.size(); length += whole.size() / 40) {
    INFO(length);
    CHECK(error_of(whole.substr(0, length)).find(": error: broken JSON: ") != std::string::npos);
  }
}

TEST_CASE("Deep nesting is refused, however it is closed", "[unit][record]") {
  const std::string said = "r.json: error: nested more than 64 levels deep";
  CHECK(error_of(std::string(3'000'000, '[')).starts_with(said));
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
  CHECK(error_of(objects).starts_with(said));
}

TEST_CASE("A key that is missing or wrong is named with its path", "[unit][record]") {
  CHECK(error_of("[]") == "r.json: error: the whole is a list; expected an object");
  CHECK(error_of("{}").find("the whole has no key \"schema\"") != std::string::npos);
  CHECK(error_with("/schema", "limitgauge.result/3") ==
        "r.json: error: schema is another one; expected limitgauge.result/1 or "
        "limitgauge.result/2");
  CHECK(error_with("/verdict", "maybe") ==
        "r.json: error: verdict is no verdict; expected pass, fail, indeterminate or not_run");
  CHECK(error_with("/threads", 0) == "r.json: error: threads is zero; expected one or more");
  CHECK(error_with("/threads", 1.5).starts_with("r.json: error: threads is no count"));
  CHECK(error_with("/stages/1/deviation/uncut_mm/low", "0.1") ==
        "r.json: error: stages[1].deviation.uncut_mm.low is a text; expected a number");
  CHECK(error_with("/stages/1/deviation/uncut_mm/low", nullptr).find("low is null") !=
        std::string::npos);
  CHECK(error_with("/stages/1/deviation/uncut_mm/low", 9e9) ==
        "r.json: error: stages[1].deviation.uncut_mm has its low above its high; expected an "
        "interval");
  CHECK(error_with("/stages/1/deviation/coverage", 1.01) ==
        "r.json: error: stages[1].deviation.coverage is no share; expected a number from 0 to 1");
  CHECK(error_with("/stages/1/deviation/rms_mm", -1) ==
        "r.json: error: stages[1].deviation.rms_mm is below zero; expected zero or more");
  CHECK(error_with("/stages/1/deviation/gouges/0/line", 5e9).find("gouges[0].line is no count") !=
        std::string::npos);
  CHECK(error_with("/stages/0/toolpath", RecordJson::object())
            .find("stages[0].toolpath has no key \"machining_time_s\"") != std::string::npos);
}

TEST_CASE("Every key that is needed is missed when it is gone", "[property][record]") {
  const RecordJson whole = RecordJson::parse(record_text_of(sample_result(Outcome::failed)));
  // What the schema requires and compare, history and study have no use for.
  const std::vector<std::string> unused = {"patches",
                                           "faces",
                                           "boundary_edges",
                                           "planes",
                                           "depth",
                                           "extraordinary_vertices",
                                           "seconds",
                                           "memory_bytes",
                                           "sampling_interval",

                                           "rapid_collisions",
                                           "holder_collisions"};
  const RecordJson schema = RecordJson::parse(result_schema());
  const std::pair<const char*, RecordJson> parts[] = {
      {"", schema["required"]},
      {"/surface", schema["$defs"]["surface"]["required"]},
      {"/stages/1", schema["$defs"]["stage"]["required"]},
      {"/stages/1/toolpath", schema["$defs"]["toolpath"]["required"]},
      {"/stages/1/simulation", schema["$defs"]["simulation"]["required"]},
      {"/stages/1/deviation", schema["$defs"]["deviation"]["required"]},
      {"/stages/1/deviation/gouges/0", schema["$defs"]["finding"]["required"]}};
  for (const auto& [where, required] : parts) {
    REQUIRE(required.size() > 2);
    for (const std::string key : required) {
      RecordJson without = whole;
      REQUIRE(without[RecordJson::json_pointer(where)].erase(key) == 1);
      const std::string said = error_of(without.dump());
      const bool is_unused = std::count(unused.begin(), unused.end(), key) > 0 || key == "move";
      INFO(where << "/" << key << ": " << said);
      if (said == "none")
        CHECK(is_unused);
      else
        CHECK(said.find('"' + key + '"') != std::string::npos);
    }
  }
}

TEST_CASE("Keys of later versions are left alone, those of earlier ones filled in",
          "[unit][record]") {
  RecordJson json = RecordJson::parse(record_text_of(sample_result(Outcome::failed)));
  json["later"] = {{"a", RecordJson::array({1, nullptr})}};
  RecordJson& deviation = json["stages"][1]["deviation"];
  deviation["uncut_mm"] = {{"low", 0.25}, {"high", 0.75}};
  deviation["gouge_mm"] = {{"low", 0.5}, {"high", 0.5}};
  for (const char* key : {"resolution_mm", "reached_resolution", "findings_complete",
                          "gouge_threshold_mm", "uncut_threshold_mm"})
    deviation.erase(key);
  json["stages"][1]["simulation"].erase("findings");
  // A result that says what its process was checked by gathers its findings, too.
  CHECK(error_of(json.dump()).find("has no key \"findings\"") != std::string::npos);
  json.erase("process_limits");
  json["stages"][1]["simulation"]["holder_collisions"] = {
      {{"line", 7}, {"x", 0}, {"y", 0}, {"z", 1}, {"depth_mm", 0.5}, {"part", "shank"}}};
  const StageMeasures stage = *read(json.dump()).stages[1].measures;
  const DeviationMeasures measures = stage.deviation.value();
  CHECK(measures.resolution_mm == 0.5);
  CHECK(measures.gouge_threshold_mm == 0.25);
  CHECK(measures.reached_resolution);
  CHECK(measures.findings_complete);
  REQUIRE_FALSE(stage.process_findings.empty());
  CHECK(stage.process_findings.back().kind == "shank_in_stock");
  CHECK(stage.process_findings.back().line == 7U);
}

TEST_CASE("What schema 1 did not know is not asked of its results", "[unit][record]") {
  const std::string whole = record_text_of(sample_result(Outcome::failed));
  CHECK(read(whole).schema == 2);
  RecordJson json = RecordJson::parse(whole);
  json["schema"] = "limitgauge.result/1";
  for (RecordJson& stage : json["stages"])
    for (const char* key : {"reach", "missing_stock_mm", "missing_stocks"})
      if (stage.contains("deviation")) stage["deviation"].erase(key);
  const RunRecord run = read(json.dump());
  CHECK(run.schema == 1);
  CHECK(run.stages[1].measures->deviation->missing_stock.empty());
  json["schema"] = "limitgauge.result/2";
  CHECK(error_of(json.dump()).find("has no key \"reach\"") != std::string::npos);
}

TEST_CASE("Reach, missing stock and their gates are read back", "[unit][record]") {
  RunResult written = sample_result(Outcome::failed);
  verifier::StageDeviation& d = *written.stages[1].ran->deviation;
  d.proven_reach = {90, 8, 2};
  d.missing_stock_mm = {0.25, 0.5};
  d.missing_stock = {d.gouges.front()};
  verifier::GateLimits& limits = written.stages[1].limits;
  limits.has_unreachable = limits.has_unavoidable = true;
  limits.unreachable = 0.05, limits.unavoidable_mm = 0.3;
  written.stages[0].limits.has_unreachable = true;
  written.stages[0].limits.unreachable_is_share = false;
  written.stages[0].limits.unreachable = 12.5;
  const RunRecord run = read(record_text_of(written));
  const DeviationMeasures& measures = *run.stages[1].measures->deviation;
  CHECK(measures.reach.reachable_mm2 == 90);
  CHECK(measures.reach.unreachable_mm2 == 8);
  CHECK(measures.reach.undecided_mm2 == 2);
  CHECK(measures.missing_stock_mm.low == 0.25);
  CHECK(measures.missing_stock_mm.high == 0.5);
  REQUIRE(measures.missing_stock.size() == 1);
  CHECK(measures.missing_stock[0].depth_mm == d.gouges.front().depth_mm);
  CHECK(measures.unavoidable_mm.low == d.unavoidable_uncut_mm.low);
  CHECK(measures.unavoidable_mm.high == d.unavoidable_uncut_mm.high);
  const verifier::GateLimits& share = run.stages[1].limits;
  CHECK(share.has_unreachable);
  CHECK(share.unreachable_is_share);
  CHECK(share.unreachable == 0.05);
  CHECK(share.has_unavoidable);
  CHECK(share.unavoidable_mm == 0.3);
  const verifier::GateLimits& area = run.stages[0].limits;
  CHECK(area.has_unreachable);
  CHECK_FALSE(area.unreachable_is_share);
  CHECK(area.unreachable == 12.5);
  CHECK_FALSE(area.has_unavoidable);
}

TEST_CASE("Texts of strangers come through as they are", "[unit][record]") {
  const RunResult hostile = hostile_result();
  const RunRecord run = read(record_text_of(hostile));
  CHECK(run.job.find('<') != std::string::npos);
}
