#include "app/study/study_figures.h"

#include <algorithm>

#include "reports/record/run_record.h"
#include "tests/support/catch.h"

namespace limitgauge::app {
namespace {

using reports::record::RunRecord;
using reports::record::StageMeasures;
using reports::record::StageRecord;
using verifier::Verdict;

const FigureScope kStated = {{"rough", "finish"}, false}, kTolerant = {{"rough", "finish"}, true};

StageRecord stage(const std::string& name, double gouge_high, double uncut_high) {
  StageRecord record;
  record.name = name;
  record.verdict = Verdict::pass;
  record.limits = {true, true, false, 0.02, 0.04, 0};
  StageMeasures measures;
  measures.machining_time_s = 100;
  reports::record::DeviationMeasures& deviation = measures.deviation.emplace();
  deviation.gouge_mm = {gouge_high / 2, gouge_high};
  deviation.uncut_mm = {uncut_high / 2, uncut_high};
  deviation.coverage = 0.995;
  record.measures = measures;
  return record;
}

RunRecord run_of(std::vector<StageRecord> stages, Verdict verdict) {
  RunRecord run;
  run.verdict = verdict;
  run.stages = std::move(stages);
  return run;
}

std::optional<double> figure(const study::Row& row, const std::string& id,
                             const FigureScope& scope = kStated) {
  const std::vector<study::Figure> figures = study_figures(scope);
  const auto found = std::find_if(figures.begin(), figures.end(),
                                  [&](const study::Figure& f) { return f.id == id; });
  REQUIRE(found != figures.end());
  REQUIRE(row.figures.size() == figures.size());
  return row.figures[static_cast<std::size_t>(found - figures.begin())];
}

study::Row row_of(const RunRecord& run, const FigureScope& scope = kStated) {
  study::Row row;
  fill_row(row, run, scope);
  return row;
}

}  // namespace

TEST_CASE("a row has the figures of the whole run and of each stage", "[unit][study]") {
  const study::Row row =
      row_of(run_of({stage("rough", 0.01, 0.03), stage("finish", 0.005, 0.02)}, Verdict::pass));
  CHECK(row.status == study::Status::pass);
  CHECK(row.reason.empty());
  CHECK(row.figures[0] == 200);
  CHECK(*figure(row, "gate_excess") == Approx(-0.25));  // 0.03 of 0.04
  CHECK(figure(row, "rough.gouge_mm.high") == 0.01);
  CHECK(figure(row, "finish.uncut_mm.low") == 0.01);
  CHECK(figure(row, "finish.machining_time_s") == 100);
  const std::vector<study::Figure> figures = study_figures(kStated);
  for (const study::Figure& one : figures) {
    CHECK(one.id.find("seconds") == std::string::npos);
    CHECK(one.id.find("bytes") == std::string::npos);
  }
  const std::vector<std::string> ids = objective_ids(kStated);
  const auto has = [&](const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  CHECK(has("finish.uncut_mm.high"));
  CHECK(has("finish.cut_length_mm"));
  CHECK_FALSE(has("finish.coverage"));
  CHECK_FALSE(has("finish.mean_mm"));
  for (const std::string& id : ids) CHECK(figure(row, id));
}

namespace {

/// Its figures over tolerances stand above what is stated.
StageRecord tolerant(StageRecord record, double gouge_high, double uncut_high) {
  reports::record::RobustMeasures& robust = record.measures->deviation->robust.emplace();
  robust.gouge_mm = {gouge_high / 2, gouge_high};
  robust.uncut_mm = {uncut_high / 2, uncut_high};
  return record;
}

}  // namespace

TEST_CASE("where tolerances are stated, the figures over them decide", "[unit][study]") {
  const StageRecord within = tolerant(stage("finish", 0.005, 0.02), 0.01, 0.03);
  CHECK(gate_excess(run_of({within}, Verdict::pass)).value() == Approx(-0.25));  // 0.03 of 0.04
  StageRecord beyond = tolerant(stage("finish", 0.005, 0.02), 0.05, 0.06);
  beyond.verdict = Verdict::fail;
  CHECK(gate_excess(run_of({beyond}, Verdict::fail)).value() == Approx(1.5));  // 0.05 of 0.02
  CHECK(row_of(run_of({beyond}, Verdict::fail)).reason ==
        "finish: gouge over tolerances beyond its limit, uncut over tolerances not decided at this "
        "resolution");
}

TEST_CASE("figures over tolerances are there where a case may have some", "[unit][study]") {
  const auto find = [](const FigureScope& scope, const std::string& id) {
    const std::vector<study::Figure> all = study_figures(scope);
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const study::Figure& f) { return f.id == id; });
    return found == all.end() ? std::nullopt : std::optional(*found);
  };
  for (const char* id :
       {"finish.robust_gouge_mm.high", "finish.margin.low", "finish.margin.high"}) {
    CAPTURE(id);
    CHECK_FALSE(find(kStated, id));
    REQUIRE(find(kTolerant, id));
    CHECK(find(kTolerant, id)->optional);
  }
  CHECK(find(kTolerant, "finish.margin.low")->larger_is_better);
  CHECK_FALSE(find(kTolerant, "finish.robust_gouge_mm.high")->larger_is_better);
  CHECK_FALSE(find(kTolerant, "finish.gouge_mm.high")->optional);

  StageRecord finish = tolerant(stage("finish", 0.005, 0.02), 0.01, 0.03);
  finish.measures->deviation->robust->margin = verifier::ToleranceMargin{1.5, 1.6};
  const study::Row row =
      row_of(run_of({stage("rough", 0.01, 0.03), finish}, Verdict::pass), kTolerant);
  CHECK(figure(row, "finish.margin.low", kTolerant) == 1.5);
  CHECK(figure(row, "finish.robust_uncut_mm.high", kTolerant) == 0.03);
  CHECK_FALSE(figure(row, "rough.margin.low", kTolerant));

  const std::vector<std::string> ids = objective_ids(kTolerant);
  const auto has = [&](const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  CHECK(has("finish.margin.low"));
  CHECK(has("finish.robust_uncut_mm.high"));
  CHECK_FALSE(has("finish.margin.high"));
  Job job;
  job.stages.resize(1);
  CHECK_FALSE(figure_scope(job, std::vector<std::string>{"stage.a.step"}).over_tolerances);
  CHECK(figure_scope(job, std::vector<std::string>{"tolerances.runout"}).over_tolerances);
  job.tolerances.emplace();
  CHECK(figure_scope(job, {}).over_tolerances);
}

TEST_CASE("a stage that was not run has no figures", "[unit][study]") {
  StageRecord failed = stage("rough", 0.05, 0.03);
  failed.verdict = Verdict::fail;
  StageRecord skipped = stage("finish", 0, 0);
  skipped.verdict = Verdict::not_run;
  skipped.measures.reset();
  const study::Row row = row_of(run_of({failed, skipped}, Verdict::fail));
  CHECK(row.status == study::Status::fail);
  CHECK(row.reason == "rough: gouge beyond its limit");
  CHECK_FALSE(row.figures[0]);
  CHECK_FALSE(figure(row, "finish.uncut_mm.high"));
  CHECK(*figure(row, "gate_excess") == Approx(1.5));
}

TEST_CASE("the excess is above zero where a gate does not pass", "[unit][study]") {
  const auto excess = [](StageRecord one, Verdict verdict) {
    one.verdict = verdict;
    return gate_excess(run_of({one}, verdict)).value();
  };
  CHECK(excess(stage("a", 0.02, 0.01), Verdict::pass) == 0);
  CHECK(excess(stage("a", 0.03, 0.01), Verdict::indeterminate) == Approx(0.5));

  StageRecord covered = stage("a", 0.001, 0.001);
  covered.limits.has_coverage = true;
  covered.limits.coverage = 0.99;
  CHECK(excess(covered, Verdict::pass) == Approx(-0.5));  // half of what may be left
  covered.limits.coverage = 0.9975;
  CHECK(excess(covered, Verdict::fail) == Approx(1));
  covered.limits.coverage = 1;
  CHECK(excess(covered, Verdict::fail) == Approx(5));

  StageRecord hit = stage("a", 0.001, 0.001);
  hit.measures->process = {{"rapid_collision", 3}, {"holder_collision", 1}};
  CHECK(excess(hit, Verdict::fail) == 4);
  hit.measures->process.clear();
  hit.measures->deviation->voxel_uncut_mm = 0.1;  // both instruments measure runs: it gates nothing
  CHECK(excess(hit, Verdict::fail) == 1);

  StageRecord bare = stage("a", 0.001, 0.001);
  bare.measures->deviation->missing_stock_mm = {0.05, 0.06};
  CHECK(excess(bare, Verdict::fail) == Approx(2));  // 0.06 of 0.02
  StageRecord far = stage("a", 0.001, 0.001);
  far.measures->deviation->reach = {90, 8, 2};
  far.limits.has_unreachable = true, far.limits.unreachable = 0.05;
  CHECK(excess(far, Verdict::fail) == Approx(1));
  far.limits.unreachable_is_share = false, far.limits.unreachable = 8;
  CHECK(excess(far, Verdict::indeterminate) == Approx(0.25));
  far.limits.unreachable = 0;
  CHECK(excess(far, Verdict::fail) == Approx(1000));
  far.limits.has_unreachable = false, far.limits.has_unavoidable = true;
  far.limits.unavoidable_mm = 0.1, far.measures->deviation->unavoidable_mm = {0.1, 0.3};
  CHECK(excess(far, Verdict::indeterminate) == Approx(2));

  StageRecord open = stage("a", 0.001, 0.001);
  open.limits = {};
  CHECK_FALSE(gate_excess(run_of({open}, Verdict::pass)));
}

TEST_CASE("reasons name what does not pass, and group", "[unit][study]") {
  const auto reason = [](StageRecord one, Verdict verdict) {
    one.verdict = verdict;
    return row_of(run_of({one}, verdict)).reason;
  };
  CHECK(reason(stage("a", 0.03, 0.05), Verdict::indeterminate) ==
        "a: gouge not decided at this resolution, uncut not decided at this resolution");
  CHECK(reason(stage("a", 0.05, 0.09), Verdict::fail) ==
        "a: gouge beyond its limit, uncut beyond its limit");
  StageRecord hit = stage("a", 0.001, 0.001);
  hit.measures->process = {{"rapid_collision", 3}};
  CHECK(reason(hit, Verdict::fail) == "a: rapid collision");
  hit.measures->process.clear();
  hit.reasons = {"gouge: within", "something else"};
  CHECK(reason(hit, Verdict::fail) == "a: something else");
  hit.measures->deviation->missing_stock_mm = {0.05, 0.06};
  hit.measures->deviation->reach = {0, 8, 2};
  hit.limits.has_unreachable = hit.limits.has_unavoidable = true;
  hit.limits.unreachable = 0.9, hit.measures->deviation->unavoidable_mm = {1, 2};
  CHECK(reason(hit, Verdict::fail) ==
        "a: missing stock beyond its limit, nothing in reach, unreachable area not decided at this "
        "resolution, unavoidable uncut beyond its limit");
}

}  // namespace limitgauge::app
