#include "reports/probe/probe_report.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "reports/probe/probe_words.h"
#include "tests/reports/sample_probe.h"
#include "tests/support/catch.h"

namespace limitgauge::reports::probe {
namespace {

using ProbeJson = nlohmann::json;

ProbeJson json_of(const ProbeResult& result) {
  std::ostringstream out;
  write_probe_json(result, out);
  return ProbeJson::parse(out.str());
}

std::string page_of(const ProbeResult& result) {
  std::ostringstream out;
  write_probe_html(result, out);
  return out.str();
}

std::vector<std::string> csv_lines(const ProbeResult& result) {
  std::ostringstream out;
  write_probe_csv(result, {1}, out);
  std::istringstream in(out.str());
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// A point whose residual lies in [low, high] µm, of an uncertainty in µm.
ProbedPoint point_of(double low, std::optional<double> high, double u) {
  ProbedPoint point;
  point.measured.u_mm = u / 1000;
  point.before.low_mm = low / 1000;
  if (high) point.before.high_mm = *high / 1000;
  return point;
}

TEST_CASE("a residual limit has the uncertainty on the safe side", "[unit][probe]") {
  using verifier::Verdict;
  constexpr double kLimit_mm = 0.01;
  CHECK(standing(point_of(7, 8, 0.9), kLimit_mm) == Verdict::pass);
  CHECK(standing(point_of(7, 8, 1.1), kLimit_mm) == Verdict::indeterminate);
  CHECK(standing(point_of(-8, -7, 0.9), kLimit_mm) == Verdict::pass);
  CHECK(standing(point_of(9, 11, 0), kLimit_mm) == Verdict::indeterminate);
  CHECK(standing(point_of(11, 12, 0.6), kLimit_mm) == Verdict::indeterminate);
  CHECK(standing(point_of(11, 12, 0.4), kLimit_mm) == Verdict::fail);
  CHECK(standing(point_of(-12, -11, 0.4), kLimit_mm) == Verdict::fail);
  CHECK(standing(point_of(-1, 30, 0), kLimit_mm) == Verdict::indeterminate);
  // Where nothing was proven to stand, the point may be as far off as it likes.
  CHECK(standing(point_of(1, {}, 0), kLimit_mm) == Verdict::indeterminate);
  CHECK(standing(point_of(11, {}, 0), kLimit_mm) == Verdict::fail);
  const ResidualGate gate =
      judged({point_of(0, 1, 0), point_of(1, {}, 0), point_of(20, 21, 0)}, kLimit_mm);
  CHECK(gate.verdict == Verdict::fail);
  CHECK(gate.beyond == 1);
  CHECK(gate.undecided == 1);
}

TEST_CASE("what is undetermined has no figure and says why", "[unit][probe]") {
  const ProbeResult floor = floor_probe(20);
  const ProbeJson shift = json_of(floor)["shift"];
  for (const int axis : {0, 1}) {
    CHECK_FALSE(shift["axes"][axis].contains("shift_mm"));
    CHECK_FALSE(shift["axes"][axis].contains("u_mm"));
    CHECK_THAT(shift["axes"][axis]["why"].get<std::string>(),
               ContainsSubstring("no point lies on a surface that faces"));
  }
  CHECK(shift["axes"][2]["shift_mm"].get<double>() == Approx(0.002).margin(2e-4));
  CHECK(shift["axes"][2]["u_mm"].get<double>() > 0);
  CHECK(shift.contains("scatter_mm"));
  const std::string table = probe_table(floor, false, 200);
  CHECK_THAT(table, ContainsSubstring("X undetermined, Y undetermined, Z 2.") &&
                        ContainsSubstring("X undetermined: no point lies on a surface that faces "
                                          "X\n"));
  CHECK_THAT(page_of(floor), ContainsSubstring("undetermined"));
}

TEST_CASE("a shift between axes is told where no axis has one", "[unit][probe]") {
  const ProbeResult slanted = slanted_probe(20);
  const std::string table = probe_table(slanted, false, 200);
  CHECK_THAT(table, ContainsSubstring("X undetermined, Y undetermined, Z undetermined") &&
                        ContainsSubstring("taken back: +10.") &&
                        ContainsSubstring(" µm along (0.600, 0.800, 0.000)") &&
                        ContainsSubstring("faces (0.800, -0.600, 0.000)"));
}

TEST_CASE("one point has no uncertainty unless it is stated", "[unit][probe]") {
  CHECK_THAT(probe_table(floor_probe(1), false, 200),
             ContainsSubstring("Z without uncertainty: no uncertainty is stated"));
  CHECK_THAT(probe_table(sample_probe(3), false, 200), ContainsSubstring("± 0.30 µm"));
}

TEST_CASE("probe.csv has every point, and its units in the header", "[unit][probe]") {
  const std::vector<std::string> lines = csv_lines(sample_probe(900));
  REQUIRE(lines.size() == 901);
  CHECK_THAT(lines[0], ContainsSubstring("x_mm,y_mm,z_mm,u_mm,residual_mm,residual_low_mm"));
  const auto cells = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  for (const std::string& line : lines)
    if (line.find("flat") == std::string::npos && line.find("ball") == std::string::npos)
      CHECK(cells(line) == cells(lines[0]));
  CHECK_THAT(lines[11], ContainsSubstring("\"raw stock\",,,,"));
  CHECK_THAT(csv_lines(floor_probe(2))[1], ContainsSubstring("2,0,0,-3,,0.00"));
}

TEST_CASE("page and probe.json list those that are farthest off", "[unit][probe]") {
  const ProbeResult result = sample_probe(900);
  const ProbeJson json = json_of(result);
  REQUIRE(json["worst"].size() == kMostListed);
  double last = 1;
  for (const ProbeJson& point : json["worst"]) {
    const double off = std::abs(point["shifted"]["value_mm"].get<double>());
    CHECK(off <= last);
    last = off;
  }
  CHECK(json["after"]["worst"] == json["worst"][0]);
  CHECK(json["points"] == 900);
  const std::string page = page_of(result);
  CHECK_THAT(page, ContainsSubstring("the first 200 of 900, all are in probe.csv") &&
                       ContainsSubstring("Each mark is the range of 3 points"));
  CHECK_THAT(page, !ContainsSubstring("<script") && !ContainsSubstring("://"));
}

TEST_CASE("texts of strangers stay texts", "[unit][probe]") {
  const ProbeResult result = hostile_probe();
  CHECK_THAT(page_of(result), !ContainsSubstring("<img src=x"));
  CHECK_THAT(page_of(result), ContainsSubstring("unknown]"));
  const ProbeJson json = json_of(result);
  CHECK(json["gate"]["verdict"] == "indeterminate");
  CHECK(json["gate"]["undecided"] == 1);
}

TEST_CASE("the schema of probe.json is a text of JSON", "[unit][probe]") {
  CHECK(ProbeJson::parse(probe_schema())["title"] == "limitgauge.probe/1");
}

}  // namespace
}  // namespace limitgauge::reports::probe
