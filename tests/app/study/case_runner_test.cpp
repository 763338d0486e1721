#include "app/study/case_runner.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/job/job_reader.h"
#include "app/run/stage_prefix.h"
#include "app/study/case_keys.h"
#include "app/study/stage_prefix_cache.h"
#include "model/base/error.h"
#include "model/base/text_file.h"
#include "reports/run/report.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Overrides = std::vector<std::string>;

void write_job(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

/// A dome of 3 mm, coarse in everything, and stages to cut it with.
std::string job_of(const std::string& stages) {
  return R"(name = "dome"
[surface]
cage = ")" +
         tests::fixtures().string() + R"(/cages/quick-dome.obj"
precision = 0.05
transform = { scale = 0.15 }
[stock]
shape = "box"
size = [4.4, 4.4, 2]
corner = [-2.2, -2.2, -1]
[machine]
clearance = 2
[simulation]
voxel = 0.2
[verification]
resolution = 0.05
[[tool]]
id = "flat"
type = "flat"
diameter = 1.2
flute_length = 10
number = 1
[[tool]]
id = "ball"
type = "ball"
diameter = 1.2
flute_length = 10
number = 2
)" + stages;
}

constexpr const char* kRough = R"([[stage]]
name = "rough"
tool = "flat"
strategy = "contour"
step = 0.5
allowance = 0.2
tolerance = 0.05
feed = 1200
floor = -0.5
)";
constexpr const char* kFinish = R"([[stage]]
name = "finish"
tool = "ball"
strategy = "zigzag"
step = 0.6
allowance = 0.1
tolerance = 0.05
feed = 1200
)";
constexpr const char* kRest = R"([[stage]]
name = "rest"
tool = "ball"
strategy = "rest"
step = 0.4
allowance = 0
tolerance = 0.05
feed = 1200
[stage.gate]
uncut = 0.1
)";
/// Two stages share this program; where the second begins is where the first one ends. The first
/// goes lower over the top of the dome: a larger allowance makes that the deepest gouge.
constexpr const char* kPrograms = R"([[stage]]
name = "first"
tool = "flat"
program = "p.ngc"
program_tool = 1
[[stage]]
name = "second"
tool = "ball"
program = "p.ngc"
program_tool = 2
[[stage]]
name = "third"
tool = "ball"
strategy = "zigzag"
step = 0.6
allowance = 0
tolerance = 0.05
feed = 1200
)";
constexpr const char* kProgram = R"(G21 G90 G17
T1 M6
S1000 M3
G0 X-7 Y-7 Z10
G0 X-7 Y0
G1 Z0.9 F500
G1 X-0.2
G1 Z0.8
G1 X0.2
G1 Z0.9
G1 X7
G0 Z10
T2 M6
S1000 M3
G0 X-7 Y1.8
G1 Z0.4
G1 X7 Y1.8
G0 Z10
M2
)";

/// Leaves out what may differ from run to run, and what only files tell.
void strip(Json& node) {
  if (node.is_object())
    for (const char* key : {"seconds", "memory_bytes", "peak_memory_bytes", "created", "threads"})
      node.erase(key);
  if (node.contains("simulation")) node["simulation"].erase("surface");
  for (Json& child : node)
    if (child.is_structured()) strip(child);
}

std::string stripped(const std::string& text) {
  Json root = Json::parse(text);
  strip(root);
  root.erase("overrides");  // a study says its cases in its own way
  return root.dump(1);
}

/// A job in a folder of its own, with a store.
class Cases {
 public:
  explicit Cases(const std::string& job) {
    write_job(file(), job);
    write_job(folder_.path() / "p.ngc", kProgram);
  }
  fs::path file() const { return folder_.path() / "job.toml"; }
  fs::path store_folder() const { return folder_.path() / "store"; }
  const study::Store& store() const { return store_; }
  CaseRunner runner() const { return CaseRunner(store_, {}); }

  /// What `limitgauge run` writes.
  std::string run(const Overrides& overrides = {}) const {
    const tests::TemporaryFolder out;
    Job job = read_job(file(), overrides);
    job.pictures = false;
    RunOptions options;
    options.created = "2026-01-01T00:00:00Z";
    write_report(run_job(job, load_inputs(job, {model::memory_limit_bytes()}), out.path(), options),
                 out.path(), options.threads);
    return model::read_text_file(out.path() / "result.json");
  }

 private:
  tests::TemporaryFolder folder_;
  study::Store store_{store_folder(), 1 << 30};
};

/// `overrides` make the case that goes on from the stages that the job as it stands left behind.
void check_reuse(const Cases& cases, const Overrides& overrides, std::size_t stages) {
  const std::string expected = stripped(cases.run(overrides));
  CaseRunner first = cases.runner();
  first.run(cases.file(), {});
  CHECK(first.last_reuse().stages == 0);
  CHECK(stripped(first.run(cases.file(), overrides)) == expected);
  CHECK(first.last_reuse().stages == stages);
  CHECK_FALSE(first.last_reuse().from_store);
  CaseRunner second = cases.runner();
  CHECK(stripped(second.run(cases.file(), overrides)) == expected);
  CHECK(second.last_reuse().stages == stages);
  CHECK(second.last_reuse().from_store);
}

}  // namespace

TEST_CASE("a case goes on from the stages that another one ran", "[slow][study]") {
  check_reuse(Cases(job_of(std::string(kRough) + kRest)), {"stage.rest.step=0.5"}, 1);
}

TEST_CASE("stages of programs are taken up with the lines that later findings name",
          "[unit][study][slow]") {
  const Cases cases(job_of(kPrograms));
  const Overrides thicker = {"stage.third.allowance=0.4"};
  check_reuse(cases, thicker, 2);
  const auto lines = [](const std::string& text) {
    return Json::parse(text)["stages"][0]["program_lines"].size();
  };
  CHECK(lines(cases.run(thicker)) > lines(cases.run()));
}

TEST_CASE("a case that shares nothing is run as a job is", "[unit][study]") {
  const Cases cases(job_of(kPrograms));
  CHECK(stripped(cases.runner().run(cases.file(), {})) == stripped(cases.run()));
}

TEST_CASE("a stage that does not pass ends every case that begins with it", "[unit][study]") {
  const Cases cases(job_of(std::string(kFinish) + "[stage.gate]\nuncut = 0.001\n" + kRest));
  REQUIRE(Json::parse(cases.run())["verdict"] == "fail");
  check_reuse(cases, {"stage.rest.step=0.5"}, 1);
}

TEST_CASE("a stage that differs is run again, and all that follow", "[slow][study]") {
  const Cases cases(job_of(kPrograms));
  CaseRunner runner = cases.runner();
  runner.run(cases.file(), {});
  const Overrides other = {"stage.second.allowance=0.1"};
  CHECK(stripped(runner.run(cases.file(), other)) == stripped(cases.run(other)));
  CHECK(runner.last_reuse().stages == 0);
}

TEST_CASE("stages that the store does not give back whole are run again", "[slow][study]") {
  const Cases cases(job_of(kPrograms));
  const std::string expected = stripped(cases.runner().run(cases.file(), {}));
  const std::vector<std::string> keys = case_keys(cases.file(), {}).prefixes;
  const fs::path entry = cases.store_folder() / "stages" / keys[1].substr(0, 2) /
                         keys[1].substr(2, 2) / keys[1].substr(4);
  std::string bytes = model::read_text_file(entry);
  bytes[bytes.size() / 2] ^= 1;
  write_job(entry, bytes);
  const std::string whole = cases.store().get("stages", keys[0]).value();
  cases.store().put("stages", keys[0], whole.substr(0, whole.size() / 2));
  CaseRunner runner = cases.runner();
  CHECK(stripped(runner.run(cases.file(), {})) == expected);
  CHECK(runner.last_reuse().stages == 0);
  // What was run in their place is there for the next one.
  CaseRunner next = cases.runner();
  next.run(cases.file(), {});
  CHECK(next.last_reuse().stages == 2);
}

TEST_CASE("no part of stages in the store is taken for the whole", "[unit][study]") {
  const Cases cases(job_of(kPrograms));
  cases.runner().run(cases.file(), {});
  const std::string whole = cases.store().get("stages", case_keys(cases.file(), {}).prefix).value();
  const std::optional<StagePrefix> read = read_stage_prefix(whole);
  REQUIRE(read);
  CHECK(to_text(*read) == whole);
  for (std::size_t length = 0; length < whole.size(); length += 1 + whole.size() / 500)
    CHECK_FALSE(read_stage_prefix(whole.substr(0, length)));
  CHECK_FALSE(read_stage_prefix(whole + " "));
}

TEST_CASE("a case that is stopped leaves nothing behind", "[unit][study]") {
  const Cases cases(job_of(kPrograms));
  std::atomic<bool> stop = false;
  RunOptions options;
  options.stop = &stop;
  options.watch.phase = [&](const Phase& phase) {
    if (phase.what == "first: measuring") stop = true;
  };
  CaseRunner runner(cases.store(), options);
  CHECK_THROWS_AS(runner.run(cases.file(), {}), model::Interrupted);
  CHECK_FALSE(fs::exists(cases.store_folder()));
  stop = false;
  CHECK_THROWS_AS(runner.run(cases.file(), {}), model::Interrupted);
  CHECK(runner.last_reuse().stages == 0);
}

TEST_CASE("a job that cannot be run is an error of the case", "[unit][study]") {
  const Cases cases(job_of(kPrograms));
  CaseRunner runner = cases.runner();
  CHECK_THROWS_AS(runner.run(cases.file(), Overrides{"stage.third.step=-1"}), model::InputError);
  CHECK_THROWS_AS(runner.run(cases.file(), Overrides{"stage.polish.step=1"}), model::InputError);
  CHECK_FALSE(fs::exists(cases.store_folder()));
}

TEST_CASE("of stages in memory those last used are kept", "[unit][study]") {
  const auto prefix = [](std::size_t bytes) {
    auto made = std::make_shared<StagePrefix>();
    made->stages.push_back({std::make_shared<const std::string>(bytes, 'a'),
                            std::make_shared<const model::Toolpath>(),
                            std::make_shared<const std::string>(), 1, 1, verifier::Verdict::pass});
    return made;
  };
  StagePrefixCache prefixes(250);
  prefixes.put("a", prefix(100));
  prefixes.put("b", prefix(100));
  CHECK(prefixes.find("a"));
  prefixes.put("c", prefix(100));
  CHECK(prefixes.find("a"));
  CHECK_FALSE(prefixes.find("b"));
  CHECK(prefixes.find("c"));
  for (const char* key : {"e", "f", "g"}) prefixes.put(key, prefix(1));
  CHECK_FALSE(prefixes.find("a"));
  CHECK_FALSE(prefixes.find("c"));
  CHECK(prefixes.find("e"));
  prefixes.put("d", prefix(1000));
  CHECK(prefixes.find("d"));
  CHECK_FALSE(prefixes.find("e"));
}

TEST_CASE("the forecast of a case grows with its stock's level set and the model",
          "[unit][study]") {
  const Cases cases(job_of(kPrograms));
  CaseForecast known;
  const auto forecast = [&](const std::string& override) {
    return static_cast<double>(known.bytes(cases.file(), Overrides{override}));
  };
  const double coarse = forecast("simulation.voxel=0.1"), fine = forecast("simulation.voxel=0.025");
  CHECK(coarse > 30e6);
  CHECK(coarse < 120e6);
  // Sixteen times the surface in voxels, and what the tables of a tree take in any case.
  CHECK(fine - coarse > 5e6);
  CHECK(forecast("surface.precision=0.0005") > forecast("surface.precision=0.05"));
  // What is known of one case is not said of another.
  CHECK(forecast("simulation.voxel=0.1") == coarse);
}

}  // namespace limitgauge::app
