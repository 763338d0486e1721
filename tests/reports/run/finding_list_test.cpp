#include "reports/run/finding_list.h"

#include <sstream>

#include "reports/run/process.h"
#include "reports/run/report.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;

namespace {

verifier::Finding at_depth(double depth_mm) {
  verifier::Finding f;
  f.depth_mm = depth_mm, f.line = 7, f.move = 3;
  return f;
}

/// A stage with gouges of these depths, certified within [low, low + width] of a limit of 1 mm.
RunResult gouged(const std::vector<double>& depths_mm, double low_mm, double width_mm) {
  RunResult result;
  StageResult& stage = result.stages.emplace_back();
  stage.name = "finish", stage.strategy = "zigzag";
  stage.limits.has_gouge = true, stage.limits.gouge_mm = 1;
  verifier::StageDeviation& d = stage.ran.emplace().deviation.emplace();
  d.gouge_mm = {low_mm, low_mm + width_mm};
  for (const double depth : depths_mm) d.gouges.push_back(at_depth(depth));
  return result;
}

std::vector<Significance> significances(const RunResult& result) {
  std::vector<Significance> out;
  for (const ListedFinding& f : list_findings(result, 0)) out.push_back(f.significance);
  return out;
}

std::string csv_of(const RunResult& result) {
  std::ostringstream out;
  write_findings_csv(result, out);
  return out.str();
}

}  // namespace

TEST_CASE("what a finding means follows the figure's standing", "[unit][findings]") {
  using enum Significance;
  CHECK(significances(gouged({1.5, 1.01, 1, 0.2}, 1.5, 0.1)) ==
        std::vector{fails, fails, within, within});
  // The limit lies in the certified interval: nothing is proven beyond it, whatever a depth's last
  // bit says.
  CHECK(significances(gouged({1 + 1e-12, 0.95, 0.85}, 1, 0.1)) ==
        std::vector{undecided, undecided, within});
  CHECK(significances(gouged({0.5}, 0.5, 0.1)) == std::vector{within});
  RunResult free = gouged({0.5}, 0.5, 0.1);
  free.stages[0].limits.has_gouge = false;
  CHECK(significances(free) == std::vector{informs});
}

TEST_CASE("findings are numbered as on the page, process findings worst first",
          "[unit][findings]") {
  const RunResult result = sample_result(Outcome::failed, 9);
  std::string ids;
  for (const ListedFinding& f : list_findings(result, 1)) ids += f.id + " ";
  CHECK(ids == "G1 U1 U2 U3 U4 P1 P2 P3 P4 P5 ");
  const ListedFinding worst = list_findings(result, 1)[5];
  CHECK(worst.kind == "holder_in_stock");
  CHECK(worst.line == 1513);
  const ListedFinding near = list_findings(result, 1).back();
  CHECK(near.kind == "near_miss");
  CHECK(near.significance == Significance::informs);
  CHECK(near.depth_mm == -0.75);
  CHECK(list_findings(result, 2).empty());
}

TEST_CASE("missing stock is a finding of its own, held against the gouge limit",
          "[unit][findings]") {
  RunResult result = gouged({}, 0, 0.1);
  verifier::StageDeviation& d = *result.stages[0].ran->deviation;
  d.missing_stock = {at_depth(1.5), at_depth(0.5)};
  for (verifier::Finding& f : d.missing_stock) f.line = 0;
  d.missing_stock_mm = {1.5, 1.6};
  const std::vector<ListedFinding> all = list_findings(result, 0);
  REQUIRE(all.size() == 2);
  CHECK(all[0].id == "M1");
  CHECK(all[0].kind == "missing_stock");
  CHECK(all[0].significance == Significance::fails);
  CHECK(all[0].line == 0);
  CHECK(all[1].significance == Significance::within);
  CHECK_THAT(csv_of(result), ContainsSubstring("\"missing_stock\",\"M1\",1.5"));
}

TEST_CASE("a program is the file stated, or the stage's own", "[unit][findings]") {
  StageResult stage;
  stage.name = "finish";
  CHECK(program_file(stage) == "finish/toolpath.ngc");
  stage.program = "../nc/part.ngc";
  CHECK(program_file(stage) == "../nc/part.ngc");
}

TEST_CASE("the table of findings has a row for each, and no formula", "[unit][findings]") {
  RunResult result = gouged({1.5, 1.25}, 1.5, 0.1);
  CHECK(csv_of(result) ==
        "stage,kind,id,depth_mm,area_mm2,x,y,z,patch,u,v,body,program,line,move,words\r\n"
        "\"finish\",\"gouge\",\"G1\",1.5,0,0,0,0,0,0,0,\"cutter\",\"finish/toolpath.ngc\",7,3,"
        "\"gouge by the cutter\"\r\n"
        "\"finish\",\"gouge\",\"G2\",1.25,0,0,0,0,0,0,0,\"cutter\",\"finish/toolpath.ngc\",7,3,"
        "\"gouge by the cutter\"\r\n");
  for (const char* hostile : {"=cmd|' /C calc'!A0", "+1", "-1", "@SUM(A1)", " \t=1", "＝1"}) {
    result.stages[0].name = hostile;
    INFO(hostile);
    CHECK_THAT(csv_of(result), ContainsSubstring("\n\"'" + std::string(hostile) + "\","));
  }
  result.stages[0].name = "a \"b\", c";
  CHECK_THAT(csv_of(result), ContainsSubstring("\n\"a \"\"b\"\", c\",\"gouge\""));
}

TEST_CASE("the table holds every finding", "[unit][findings]") {
  const std::string text = csv_of(gouged(std::vector<double>(1500, 2.0), 2, 0.1));
  CHECK(std::count(text.begin(), text.end(), '\n') == 1501);
}

TEST_CASE("a move that touches two clamps is one move with two faults", "[unit]") {
  using simulator::FindingKind;
  const auto touched = [](std::size_t move, const char* clamp) {
    return simulator::Finding{FindingKind::fixture_touched, move, 0, {}, 1, "shank", clamp};
  };
  const std::vector<simulator::Finding> all{touched(3, "a"), touched(3, "b"), touched(4, "b")};
  CHECK(moves_with(all, FindingKind::fixture_touched) == 2);
  CHECK(moves_with(all, FindingKind::near_miss) == 0);
  CHECK(faults(all) == 3);
}
