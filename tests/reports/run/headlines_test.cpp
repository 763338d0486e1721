#include "reports/run/headlines.h"

#include "tests/reports/page/page_support.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;

namespace {

using simulator::FindingKind;
using Words = std::vector<std::string>;

/// A stage that passes in every respect.
StageResult good_stage() {
  StageResult stage = sample_result(Outcome::passed).stages[0];
  verifier::StageDeviation& d = *stage.ran->deviation;
  d.surface_area_mm2 = 100;
  d.proven_reach = {100, 0, 0};
  d.reachable_area_mm2 = 100, d.unreachable_area_mm2 = 0;
  d.missing_stock_mm = {0, 0};
  return stage;
}

}  // namespace

TEST_CASE("each kind of failure has a headline of its own", "[unit][headlines]") {
  CHECK(headlines(good_stage()).empty());
  const auto of = [](const auto& spoil) {
    StageResult stage = good_stage();
    spoil(stage, *stage.ran->deviation);
    return headlines(stage);
  };
  using Stage = StageResult;
  using D = verifier::StageDeviation;
  CHECK(of([](Stage&, D& d) { d.gouge_mm = {1, 1.1}; }) == Words{"gouged beyond the limit"});
  CHECK(of([](Stage&, D& d) { d.uncut_mm = {5, 6}; }) == Words{"material left beyond the limit"});
  CHECK(of([](Stage&, D& d) { d.missing_stock_mm = {1, 2}; }) == Words{"raw stock is missing"});
  CHECK(of([](Stage&, D& d) { d.coverage = 0.5; }) == Words{"coverage too small"});
  CHECK(of([](Stage& s, D& d) {
          s.limits.has_unreachable = true, s.limits.unreachable = 0.05;
          d.proven_reach = {90, 10, 0};
        }) == Words{"more out of reach than allowed"});
  CHECK(of([](Stage& s, D& d) {
          s.limits.has_unavoidable = true, s.limits.unavoidable_mm = 0.1;
          d.unavoidable_uncut_mm = {0.2, 0.3};
        }) == Words{"more must stay than allowed"});
  CHECK(of([](Stage&, D& d) {
          d.proven_reach = {0, 100, 0};
          d.reachable_area_mm2 = 0;
        }) == Words{"nothing is in reach of any cutter"});
  CHECK(of([](Stage& s, D& d) {
          d.gouge_mm = {0, s.limits.gouge_mm * 2};
        }) == Words{"undecided: gouge"});
  StageResult stage = good_stage();
  stage.ran.reset();
  CHECK(headlines(stage) == Words{"not run"});
}

TEST_CASE("a crashed holder is no gate figure: the process has headlines of its own",
          "[unit][headlines]") {
  const std::vector<std::pair<FindingKind, std::string>> kinds = {
      {FindingKind::rapid_through_stock, "rapid through standing material"},
      {FindingKind::shank_in_stock, "shank in the material"},
      {FindingKind::holder_in_stock, "holder in the material"},
      {FindingKind::fixture_touched, "fixture touched"},
      {FindingKind::spindle_stopped, "cut with the spindle at rest"}};
  for (const auto& [kind, words] : kinds) {
    RunResult result = sample_result(Outcome::failed);
    StageResult& stage = result.stages[1];
    stage = good_stage();
    stage.ran->process = {{kind, 5, 6, {1, 2, 3}, 0.5, "part", "other"}};
    stage.decision.verdict = verifier::Verdict::fail;
    CHECK(headlines(stage) == Words{words});
    ParsedPage page;
    parse_page(page_of(result), page);
    const std::string text = text_of(page.tree.find_node(
        [](const pugi::xml_node& n) { return std::string(n.name()) == "header"; }));
    INFO(text);
    CHECK(contains(text, stage.name + ": " + words));
    CHECK_FALSE(contains(text, "gate figure"));
  }
  StageResult stage = good_stage();
  stage.ran->process = {{FindingKind::near_miss, 5, 6, {1, 2, 3}, -0.5, "part", "other"}};
  CHECK(headlines(stage).empty());
}
