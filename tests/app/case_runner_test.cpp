#include "app/case_runner.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/case_keys.h"
#include "app/job_reader.h"
#include "app/stage_prefix_text.h"
#include "engine/model/error.h"
#include "engine/model/text_file.h"
#include "reports/report.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Overrides = std::vector<std::string>;

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

/// A dome of 5 mm, coarse in everything, and stages to cut it with.
std::string job_of(const std::string& stages) {
  return R"(name = "dome"
[surface]
cage = ")" LIMITGAUGE_FIXTURES R"(/cages/quick-dome.obj"
precision = 0.05
transform = { scale = 0.25 }
[stock]
shape = "box"
size = [7, 7, 3]
corner = [-3.5, -3.5, -1.5]
[machine]
clearance = 2
[simulation]
voxel = 0.25
[verification]
resolution = 0.05
[[tool]]
id = "flat"
type = "flat"
diameter = 2
flute_length = 10
number = 1
[[tool]]
id = "ball"
type = "ball"
diameter = 2
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
/// has a pass that only a larger allowance makes a gouge.
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
step = 0.8
allowance = 0
tolerance = 0.05
feed = 1200
)";
constexpr const char* kProgram = R"(G21 G90 G17
T1 M6
S1000 M3
G0 X-7 Y-7 Z10
G0 X-7 Y0
G1 Z1.2 F500
G1 X7 Y0
G0 Z10
T2 M6
G0 X-7 Y3
G1 Z0.5
G1 X7 Y3
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
  return root.dump(1);
}

/// A job in a folder of its own, with a store.
class Cases {
 public:
  explicit Cases(const std::string& job) {
    write(file(), job);
    write(folder_.path() / "p.ngc", kProgram);
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
    write_report(run_job(job, load_inputs(job), out.path(), options), out.path());
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
  CHECK(stripped(first.run(cases.file(), {})) == stripped(cases.run()));
  CHECK(first.last_reuse().stages == 0);
  CHECK(stripped(first.run(cases.file(), overrides)) == expected);
  CHECK(first.last_reuse().stages == stages);
  CHECK_FALSE(first.last_reuse().from_store);
  CaseRunner second = cases.runner();
  CHECK(stripped(second.run(cases.file(), overrides)) == expected);
  CHECK(second.last_reuse().stages == stages);
  CHECK(second.last_reuse().from_store);
  CHECK(stripped(second.run(cases.file(), overrides)) == expected);
  CHECK_FALSE(second.last_reuse().from_store);
}

}  // namespace

TEST_CASE("a case goes on from the stages that another one ran", "[unit][study]") {
  const Cases cases(job_of(std::string(kRough) + kFinish + kRest));
  check_reuse(cases, {"stage.rest.step=0.5"}, 2);
}

TEST_CASE("a stage that differs is run again, and all that follow", "[unit][study]") {
  const Cases cases(job_of(std::string(kRough) + kFinish + kRest));
  CaseRunner runner = cases.runner();
  runner.run(cases.file(), {});
  const Overrides finer = {"stage.finish.step=0.7"};
  CHECK(stripped(runner.run(cases.file(), finer)) == stripped(cases.run(finer)));
  CHECK(runner.last_reuse().stages == 1);
}

TEST_CASE("stages of programs are taken up with the lines that later findings name",
          "[unit][study]") {
  const Cases cases(job_of(kPrograms));
  const Overrides thicker = {"stage.third.allowance=0.4"};
  check_reuse(cases, thicker, 2);
  const auto lines = [](const std::string& text) {
    return Json::parse(text)["stages"][0]["program_lines"];
  };
  CHECK(lines(cases.run(thicker)).size() > lines(cases.run()).size());
}

TEST_CASE("a stage that does not pass ends every case that begins with it", "[unit][study]") {
  const Cases cases(
      job_of(std::string(kRough) + "[stage.gate]\nuncut = 0.001\n" + kFinish + kRest));
  REQUIRE(Json::parse(cases.run())["verdict"] == "fail");
  check_reuse(cases, {"stage.rest.step=0.5"}, 1);
}

TEST_CASE("stages that the store does not give back whole are run again", "[unit][study]") {
  const Cases cases(job_of(std::string(kRough) + kFinish));
  const Overrides overrides = {"stage.finish.step=0.7"};
  const std::string expected = stripped(cases.run(overrides));
  cases.runner().run(cases.file(), {});
  const std::string key = case_keys(cases.file(), overrides).prefix;
  const std::string whole = cases.store().get("stages", key).value();
  REQUIRE(read_stage_prefix(whole));
  SECTION("its file has another byte") {
    const fs::path entry =
        cases.store_folder() / "stages" / key.substr(0, 2) / key.substr(2, 2) / key.substr(4);
    std::string bytes = model::read_text_file(entry);
    bytes[bytes.size() / 2] ^= 1;
    write(entry, bytes);
  }
  SECTION("it is cut short") {
    cases.store().put("stages", key, whole.substr(0, whole.size() / 2));
  }
  SECTION("it is something else") {
    cases.store().put("stages", key, "limitgauge stages 1\n");
  }
  CaseRunner runner = cases.runner();
  CHECK(stripped(runner.run(cases.file(), overrides)) == expected);
  CHECK(runner.last_reuse().stages == 0);
  // What was run in its place is there for the next one.
  CaseRunner next = cases.runner();
  next.run(cases.file(), overrides);
  CHECK(next.last_reuse().stages == 1);
}

TEST_CASE("no part of stages in the store is taken for the whole", "[unit][study]") {
  const Cases cases(job_of(std::string(kRough) + kFinish));
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
  const Cases cases(job_of(std::string(kRough) + kFinish));
  std::atomic<bool> stop = false;
  RunOptions options;
  options.stop = &stop;
  options.watch.phase = [&](const Phase& phase) {
    if (phase.what == "rough: measuring") stop = true;
  };
  CaseRunner runner(cases.store(), options);
  CHECK_THROWS_AS(runner.run(cases.file(), {}), model::Interrupted);
  CHECK_FALSE(fs::exists(cases.store_folder()));
  stop = false;
  CHECK_THROWS_AS(runner.run(cases.file(), {}), model::Interrupted);
  CHECK(runner.last_reuse().stages == 0);
}

TEST_CASE("a job that cannot be run is an error of the case", "[unit][study]") {
  const Cases cases(job_of(std::string(kRough) + kFinish));
  CaseRunner runner = cases.runner();
  CHECK_THROWS_AS(runner.run(cases.file(), Overrides{"stage.finish.step=-1"}), model::InputError);
  CHECK_THROWS_AS(runner.run(cases.file(), Overrides{"stage.polish.step=1"}), model::InputError);
  CHECK_FALSE(fs::exists(cases.store_folder()));
}

TEST_CASE("only the stages in memory that are within the bound are kept", "[unit][study]") {
  const Cases cases(job_of(std::string(kRough) + kFinish + kRest));
  CaseRunner runner(cases.store(), {}, 1);
  runner.run(cases.file(), {});
  // The last ones put in are there; those before them come from the store.
  runner.run(cases.file(), Overrides{"stage.rest.step=0.5"});
  CHECK(runner.last_reuse().stages == 2);
  CHECK_FALSE(runner.last_reuse().from_store);
  runner.run(cases.file(), Overrides{"stage.finish.step=0.7"});
  CHECK(runner.last_reuse().stages == 1);
  CHECK(runner.last_reuse().from_store);
}

}  // namespace limitgauge::app
