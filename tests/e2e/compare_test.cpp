#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

/// The quick dome's finish alone, in one stage.
std::string dome_job(const std::string& way) {
  return R"(name = "dome"
[surface]
cage = ")" +
         fixture("cages/quick-dome.obj") + R"("
[stock]
shape = "box"
size = [26, 26, 9]
corner = [-13, -13, -4]
[machine]
rapid = 5000
clearance = 2
[[tool]]
id = "ball"
type = "ball"
diameter = 6
flute_length = 20
[[stage]]
name = "finish"
tool = "ball"
allowance = 0
)" + way +
         R"(
[stage.gate]
gouge = 0.03
uncut = 0.03
coverage = 0.99
[simulation]
voxel = 0.5
)";
}

const std::string kZigzag = R"(strategy = "zigzag"
step = 0.3
tolerance = 0.01
feed = 1500
plunge_feed = 400
link_feed = 1500
angle = 90
pattern = "zigzag"
boundary_pass = false)";

double word(const std::string& line, char letter, double otherwise) {
  const std::size_t at = line.find(letter);
  return at == std::string::npos ? otherwise : std::stod(line.substr(at + 1));
}

struct Sunk {
  std::string program;
  std::set<int> lines;
};

/// The row along Y that lies nearest to `x_mm`, 5 µm deeper. Words are modal: each line of the row
/// says its height, and the line after it takes up the old one.
Sunk sink_row(const std::string& program, double x_mm) {
  std::istringstream in(program);
  std::vector<std::string> lines;
  std::vector<double> x, z;
  double at_x = 1e9, at_z = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.find('(') == std::string::npos && !line.starts_with('T')) {
      at_x = word(line, 'X', at_x);
      at_z = word(line, 'Z', at_z);
    }
    lines.push_back(line);
    x.push_back(at_x);
    z.push_back(at_z);
  }
  const auto is_cut = [&](std::size_t i) { return lines[i].starts_with('Y'); };
  double row = 1e9;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (is_cut(i) && std::abs(x[i] - x_mm) < std::abs(row - x_mm)) row = x[i];
  Sunk out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::string line = lines[i].substr(0, lines[i].find(" Z"));
    const bool sinks = is_cut(i) && x[i] == row;
    const bool follows = !sinks && i > 0 && out.lines.count(static_cast<int>(i)) > 0;
    if (sinks) {
      line += " Z" + std::to_string(z[i] - 0.005);
      out.lines.insert(static_cast<int>(i) + 1);
    } else if (follows && lines[i].find('Z') == std::string::npos) {
      line = lines[i] + " Z" + std::to_string(z[i]);
    } else {
      line = lines[i];
    }
    out.program += line + '\n';
  }
  return out;
}

Outcome run(const Scratch& scratch, const std::string& way, const std::string& out,
            std::vector<std::string> more = {}) {
  write_text(scratch / "job.toml", dome_job(way));
  std::vector<std::string> arguments = {"run", "job.toml", "-o", out, "--quiet", "--no-pictures"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return limitgauge(scratch, arguments);
}

json figure(const json& comparison, const std::string& metric) {
  for (const json& f : comparison["stages"][0]["figures"])
    if (f["metric"] == metric) return f;
  return {};
}

json comparison_in(const fs::path& folder) {
  return json::parse(read_text(folder / "compare.json"));
}

}  // namespace

TEST_CASE("what got worse turns compare red, and its lines are named", "[e2e][compare]") {
  const Scratch scratch;
  REQUIRE(run(scratch, kZigzag, "base").exit_code == 0);
  const auto compare = [&](const std::string& base, const std::string& now,
                           const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"compare", base, now, "-o", "c-" + base + now};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = limitgauge(scratch, arguments);
    UNSCOPED_INFO(outcome.out << outcome.errors);
    return outcome;
  };

  // The same job with other threads is the same.
  REQUIRE(run(scratch, kZigzag, "threads", {"--threads", "1"}).exit_code == 0);
  const Outcome same = compare("base", "threads");
  CHECK(same.exit_code == 0);
  CHECK_THAT(same.out, ContainsSubstring("comparison: same"));
  CHECK(comparison_in(scratch / "c-basethreads")["worse"] == 0);
  CHECK(comparison_in(scratch / "c-basethreads")["better"] == 0);

  // A step-over of 20 % more is worse, and turned round better.
  REQUIRE(run(scratch, kZigzag, "step", {"--set", "stage.finish.step=0.36"}).exit_code == 0);
  CHECK(compare("base", "step").exit_code == 1);
  const json step = comparison_in(scratch / "c-basestep");
  CHECK(figure(step, "uncut_mm")["judgement"] == "worse");
  CHECK(figure(step, "uncut_mm")["deepest"]["line"] > 0);
  CHECK(step["stages"][0]["name"] == "finish");
  CHECK_THAT(read_text(scratch / "c-basestep/compare.md"), ContainsSubstring("| finish | uncut |"));
  CHECK_THAT(read_text(scratch / "c-basestep/junit.xml"),
             ContainsSubstring("<failure message=\"uncut"));
  CHECK_THAT(read_text(scratch / "c-basethreads/junit.xml"), !ContainsSubstring("<failure"));
  const Outcome back = compare("step", "base");
  CHECK(back.exit_code == 0);
  CHECK_THAT(back.out, ContainsSubstring("comparison: better"));
  CHECK(compare("step", "base", {"--time-limit", "10", "--force"}).exit_code == 1);

  // A row that is sunk by 5 µm is worse, and is named.
  const Sunk sunk = sink_row(read_text(scratch / "base/finish/toolpath.ngc"), 1.0);
  REQUIRE(sunk.lines.size() > 20);
  write_text(scratch / "sunk.ngc", sunk.program);
  REQUIRE(run(scratch, "program = \"sunk.ngc\"", "sunk").exit_code == 0);
  const Outcome red = compare("base", "sunk");
  CHECK(red.exit_code == 1);
  const json gouge = figure(comparison_in(scratch / "c-basesunk"), "gouge_mm");
  REQUIRE(gouge["judgement"] == "worse");
  const int line = gouge["deepest"]["line"];
  CHECK(sunk.lines.count(line) == 1);
  CHECK_THAT(red.out, ContainsSubstring("line " + std::to_string(line) + ": Y"));
  CHECK(compare("sunk", "base").exit_code == 0);
}

TEST_CASE("compare refuses a result of one schema against one of another, and says why",
          "[e2e][compare]") {
  const Scratch scratch;
  json result = json::parse(read_text(fixture("baselines/ball.json")));
  result["schema"] = "limitgauge.result/1";
  write_text(scratch / "one.json", result.dump());
  result["schema"] = "limitgauge.result/2";
  for (json& stage : result["stages"]) {
    if (!stage.contains("deviation")) continue;
    stage["deviation"]["reach"] = {
        {"reachable_mm2", 1}, {"unreachable_mm2", 0}, {"undecided_mm2", 0}};
    stage["deviation"]["missing_stock_mm"] = {{"low", 0}, {"high", 0}};
    stage["deviation"]["missing_stocks"] = json::array();
  }
  write_text(scratch / "two.json", result.dump());
  const Outcome mixed = limitgauge(scratch, {"compare", "one.json", "two.json", "-o", "out"});
  CHECK(mixed.exit_code == 3);
  CHECK_THAT(mixed.errors, ContainsSubstring("gouge and uncut do not mean the same in both"));
  CHECK_THAT(mixed.errors, ContainsSubstring("make the baseline again"));
  CHECK(scratch.entries() == std::vector<std::string>{"one.json", "two.json"});
  for (const char* alike : {"one.json", "two.json"})
    CHECK(limitgauge(scratch, {"compare", alike, alike}).exit_code == 0);
}

TEST_CASE("compare refuses what it cannot compare and keeps to its folder", "[e2e][compare]") {
  const Scratch scratch;
  const std::string base = fixture("baselines/ball.json");
  const auto compare = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "compare");
    return limitgauge(scratch, arguments);
  };
  CHECK(compare({base, "nowhere"}).exit_code == 3);
  CHECK(compare({base, scratch.path().string()}).exit_code == 3);
  write_text(scratch / "broken.json", "{\n\"schema\": 1,}");
  const Outcome broken = compare({base, "broken.json"});
  CHECK(broken.exit_code == 3);
  CHECK_THAT(broken.errors, ContainsSubstring("broken.json:2:13: error: broken JSON"));
  const Outcome typo = compare({base, base, "--ignore", "uncut"});
  CHECK(typo.exit_code == 3);
  CHECK_THAT(typo.errors, ContainsSubstring("uncut_mm"));
  // Nothing would be judged, and that would be green.
  const Outcome both = compare({base, base, "--metric", "uncut_mm", "--ignore", "uncut_mm"});
  CHECK(both.exit_code == 3);
  CHECK_THAT(both.errors, ContainsSubstring("contradict each other"));
  const Outcome time = compare({base, base, "--metric", "machining_time_s"});
  CHECK(time.exit_code == 3);
  CHECK_THAT(time.errors, ContainsSubstring("--time-limit"));
  CHECK(compare({base, base, "--metric", "machining_time_s", "--time-limit", "1"}).exit_code == 0);
  const Outcome parts = compare({base, fixture("baselines/foreign.json")});
  CHECK(parts.exit_code == 1);
  CHECK_THAT(parts.out, ContainsSubstring("these are results of two jobs: quick-dome and plate"));

  REQUIRE(compare({base, base, "-o", "out"}).exit_code == 0);
  CHECK(scratch.entries() == std::vector<std::string>{"broken.json", "out"});
  CHECK(compare({base, base, "-o", "out"}).exit_code == 3);
  CHECK(compare({base, base, "-o", "out", "--force"}).exit_code == 0);
  fs::create_directories(scratch / "mine");
  write_text(scratch / "mine/notes.txt", "mine");
  CHECK(compare({base, base, "-o", "mine", "--force"}).exit_code == 3);
  CHECK(read_text(scratch / "mine/notes.txt") == "mine");
}

}  // namespace limitgauge::e2e
