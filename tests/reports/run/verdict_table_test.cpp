#include <sstream>

#include "reports/run/report.h"
#include "reports/text/text.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("the table shows interval, relation and limit", "[unit][table]") {
  const auto lines = lines_of(verdict_table(sample_result(Outcome::failed), false));
  INFO(verdict_table(sample_result(Outcome::failed), false));
  REQUIRE(lines.size() >= 5);
  CHECK_THAT(lines[1], ContainsSubstring("rough") && ContainsSubstring("pass") &&
                           ContainsSubstring("≤ 1 mm"));
  CHECK_THAT(lines[2], ContainsSubstring("fail") && ContainsSubstring("> 50 µm"));
  CHECK_THAT(lines[3], ContainsSubstring("not run") && ContainsSubstring("–"));
  CHECK(lines.back() == "verdict: fail");
  CHECK_THAT(verdict_table(sample_result(Outcome::indeterminate), false),
             ContainsSubstring("? 10 µm"));
}

TEST_CASE("what is out of reach and what stock is missing stand below the table", "[unit][table]") {
  RunResult result = sample_result(Outcome::passed);
  for (StageResult& stage : result.stages) {
    stage.ran->deviation->unreachable_area_mm2 = 0;
    stage.ran->deviation->proven_reach = {1000, 0, 0};
  }
  CHECK_THAT(verdict_table(result, false),
             !ContainsSubstring("unreachable") && !ContainsSubstring("missing"));
  verifier::StageDeviation& d = *result.stages[1].ran->deviation;
  d.surface_area_mm2 = 300;
  d.proven_reach = {287.2, 12.3, 0.5};
  d.unavoidable_uncut_mm = {0.1, 0.25};
  d.missing_stock_mm = {0.5, 0.51};
  result.stages[1].decision.reasons = {"unreachable: 12.3 mm² said again"};
  for (const std::size_t width : {100, 80}) {
    const std::string text = verdict_table(result, false, width);
    INFO(text);
    CHECK_THAT(text, ContainsSubstring("\nsemi-finish: unreachable 12.3 to 12.8 mm² (4.10 to "
                                       "4.27 %),"));
    CHECK_THAT(text, ContainsSubstring("0.250 mm\n"));
    CHECK_THAT(text, ContainsSubstring("\nsemi-finish: missing stock [0.500, 0.510] mm"));
  }
  result.stages[1].decision.verdict = verifier::Verdict::fail;
  CHECK_THAT(verdict_table(result, false), !ContainsSubstring("said again"));
}

TEST_CASE("the table fits 100 columns and stays aligned", "[unit][table]") {
  RunResult result = sample_result(Outcome::failed);
  result.stages[0].name = std::string(70, 'n');
  result.stages[1].tool = "ein sehr länglicher Fräser ohne Ende";
  result.stages[1].decision.reasons.push_back(std::string(30, 'x') + " " + std::string(60, 'y') +
                                              " " + std::string(50, 'z'));
  const auto lines = lines_of(verdict_table(result, false));
  for (const std::string& line : lines) CHECK(code_points(line) <= 100);
  // The last column is flush right in the four rows of the table.
  for (int row = 1; row < 4; ++row) CHECK(code_points(lines[row]) == code_points(lines[0]));
}

TEST_CASE("on 80 columns the intervals have lines of their own", "[unit][table]") {
  RunResult result = sample_result(Outcome::failed);
  result.stages[0].name = std::string(70, 'n');
  result.stages[0].program = std::string(70, 'p');
  const std::string text = verdict_table(result, false, 80);
  INFO(text);
  const auto lines = lines_of(text);
  for (const std::string& line : lines) CHECK(code_points(line) <= 80);
  CHECK_THAT(lines[0], !ContainsSubstring("gouge"));
  CHECK_THAT(lines[1], ContainsSubstring("nnn…") && ContainsSubstring("pass"));
  CHECK(lines[2].starts_with("  gouge ["));
  CHECK_THAT(lines[2], ContainsSubstring("   uncut ["));
  CHECK(code_points(lines[1]) == code_points(lines[0]));
  CHECK(lines.back() == "verdict: fail");
}

TEST_CASE("colour changes nothing but the colour", "[unit][table]") {
  const RunResult result = sample_result(Outcome::failed);
  std::string coloured = verdict_table(result, true);
  CHECK_THAT(coloured, ContainsSubstring("\x1b[1;31mfail\x1b[0m"));
  for (std::size_t at; (at = coloured.find('\x1b')) != std::string::npos;)
    coloured.erase(at, coloured.find('m', at) - at + 1);
  CHECK(coloured == verdict_table(result, false));
}

TEST_CASE("the table shows the program's own line at the worst place of a failure",
          "[unit][table]") {
  RunResult result = sample_result(Outcome::failed);
  StageResult& stage = result.stages[1];
  REQUIRE(stage.verdict() == verifier::Verdict::fail);
  REQUIRE(!stage.ran->deviation->gouges.empty());
  stage.program = "jobs/part.ngc";
  stage.ran->program_text = std::make_shared<const std::string>("G21\nG1 X12 Y3 F600\nM2\n");
  verifier::Finding& worst = stage.ran->deviation->gouges.front();
  worst.stage = 1, worst.line = 2;
  const std::string text = verdict_table(result, false);
  INFO(text);
  CHECK_THAT(text, ContainsSubstring("\nsemi-finish: jobs/part.ngc:2: G1 X12 Y3 F600\n"));
  // Of stages that pass, none.
  stage.decision.verdict = verifier::Verdict::pass;
  CHECK_THAT(verdict_table(result, false), !ContainsSubstring("G1 X12"));
}

TEST_CASE("times go by their names, and a stage without moves is told", "[unit][table]") {
  RunResult result = sample_result(Outcome::passed);
  CHECK_THAT(verdict_table(result, false),
             ContainsSubstring("\nmachining time ") && ContainsSubstring(" (rough ") &&
                 ContainsSubstring("\ncomputing time ") && !ContainsSubstring("no moves"));
  result.stages[1].ran->cut_length_mm = 0;
  CHECK_THAT(verdict_table(result, false), ContainsSubstring("no moves that cut"));
  result.stages[1].strategy = "rest";
  CHECK_THAT(verdict_table(result, false), ContainsSubstring("no moves, since nothing that"));
}
