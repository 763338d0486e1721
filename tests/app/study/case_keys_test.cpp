#include "app/study/case_keys.h"

#include <fstream>
#include <set>

#include "app/toml/toml_text.h"
#include "model/base/error.h"
#include "model/base/text_file.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::app {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

constexpr const char* kJob = R"(name = "dome"
[surface]
cage = "cage.obj"
[stock]
shape = "box"
size = [26, 26, 9]
corner = [-13, -13, -4]
[simulation]
voxel = 0.5
[[tool]]
id = "flat6"
type = "flat"
diameter = 6
[[tool]]
id = "ball6"
type = "ball"
diameter = 6
[[stage]]
name = "rough"
tool = "flat6"
strategy = "contour"
step = 1.5
allowance = 0.3
tolerance = 0.1
feed = 1200
gate = { uncut = 0.2 }
[[stage]]
name = "semi"
tool = "ball6"
strategy = "zigzag"
step = 1
allowance = 0.5
tolerance = 0.1
feed = 1200
[[stage]]
name = "finish"
tool = "ball6"
strategy = "zigzag"
step = 1
tolerance = 0.1
feed = 1200
gate = { uncut = 0.2 }
)";

class JobFiles {
 public:
  explicit JobFiles(const std::string& text = kJob) {
    fs::copy_file(tests::fixtures() / "cages/quick-dome.obj", path("cage.obj"));
    write(path("job.toml"), text);
  }
  fs::path path(const std::string& name) const { return folder_.path() / name; }
  CaseKeys keys(const std::vector<std::string>& overrides = {}) {
    return maker_.keys(path("job.toml"), overrides);
  }
  /// How many of the first stages, counted by the prefixes, an override leaves as they were.
  std::size_t kept(const std::string& override) {
    const std::vector<std::string> before = keys().prefixes, after = keys({override}).prefixes;
    std::size_t same = 0;
    while (same < before.size() && before[same] == after[same]) ++same;
    for (std::size_t i = same; i < before.size(); ++i) CHECK(before[i] != after[i]);
    return same;
  }

 private:
  tests::TemporaryFolder folder_;
  CaseKeyMaker maker_;
};

}  // namespace

TEST_CASE("keys are sums, of each run of first stages its own", "[unit][study]") {
  JobFiles job;
  const CaseKeys keys = job.keys();
  REQUIRE(keys.prefixes.size() == 2);
  CHECK(keys.prefix == keys.prefixes[1]);
  std::set<std::string> all(keys.prefixes.begin(), keys.prefixes.end());
  all.insert(keys.result);
  CHECK(all.size() == 3);
  for (const std::string& key : all) {
    CHECK(key.size() == 64);
    CHECK(key.find_first_not_of("0123456789abcdef") == std::string::npos);
  }
  CHECK(case_keys(job.path("job.toml"), {}).result == keys.result);
  CHECK(case_keys(job.path("job.toml"), {}).prefix == keys.prefix);
}

TEST_CASE("a key tells every setting that its stages depend on", "[unit][study]") {
  JobFiles job;
  for (const char* all :
       {"surface.precision=0.02", "surface.transform={scale=1.1}", "stock.size=[26, 26, 10]",
        "simulation.voxel=0.6", "simulation.near_miss=1", "verification.resolution=0.01",
        "machine.clearance=4", "machine.rapid=4000", "machine.acceleration=500",
        "machine.travel={x=[-50,50]}", "post.decimals=3", "program_frame.offset=[0,0,1]",
        "name=other", "stage.rough.step=1.4", "stage.rough.gate={uncut=0.3}",
        "stage.rough.allowance=0.2", "stage.rough.floor=-1", "tool.flat6.diameter=5",
        "tool.flat6.flute_length=30", "tool.flat6.shank={diameter=6,length=30}",
        // The engine's model is made for the greatest offset of all stages.
        "stage.semi.allowance=0.6", "stage.semi.tolerance=0.2", "stage.finish.allowance=1",
        "simulation.voxel=auto",
        // What is recorded of a stage has its figures over them, and the margin where it is sought.
        "tolerances.tool.flat6.radius=0.01", "tolerances.zero=[0.01,0,0]",
        "tolerances={runout=0.01,margin=false}"}) {
    CAPTURE(all);
    CHECK(job.kept(all) == 0);
  }
  for (const char* second : {"stage.semi.step=0.9", "stage.semi.feed=1300",
                             "stage.semi.gate={gouge=0.1}", "tool.ball6.flute_length=30"}) {
    CAPTURE(second);
    CHECK(job.kept(second) == 1);
  }
  for (const char* last : {"stage.finish.step=0.9", "stage.finish.tolerance=0.05",
                           "stage.finish.allowance=0.1", "stage.finish.gate={uncut=0.1}",
                           "report.pictures=false", "published={source=\"a book\"}"}) {
    CAPTURE(last);
    CHECK(job.kept(last) == 2);
    CHECK(job.keys({last}).result != job.keys().result);
  }
}

TEST_CASE("stages measured over other tolerances are not shared", "[unit][study]") {
  JobFiles job;
  const auto prefix = [&](const std::string& tolerances) {
    return job.keys({"tolerances=" + tolerances}).prefixes[0];
  };
  const std::set<std::string> different = {
      job.keys().prefixes[0], prefix("{runout=0.01}"), prefix("{runout=0.02}"),
      prefix("{runout=0.01,margin=true}"), prefix("{tool={flat6={radius=0.01}}}")};
  CHECK(different.size() == 5);
  CHECK(prefix("{runout=0.010}") == prefix("{runout=0.01}"));
}

TEST_CASE("tolerances of a tool count from the stage on that uses it", "[unit][study]") {
  JobFiles job("tolerances = { zero = [0.001, 0.001, 0.001], tool.ball6.radius = 0.01 }\n" +
               std::string(kJob));
  CHECK(job.kept("tolerances.tool.ball6.radius=0.02") == 1);
  CHECK(job.kept("tolerances.tool.flat6.radius=0.02") == 0);
  CHECK(job.kept("tolerances.zero=[0.001,0.001,0.002]") == 0);
  CHECK(job.keys({"tolerances.tool.ball6.radius=0.02"}).result != job.keys().result);
}

TEST_CASE("a voxel that follows the tightest gate depends on all stages", "[unit][study]") {
  std::string text = kJob;
  text.replace(text.find("voxel = 0.5"), 11, "voxel = \"auto\"");
  JobFiles job(text);
  CHECK(job.kept("stage.finish.gate={uncut=0.01}") == 0);
  CHECK(job.kept("stage.finish.gate={uncut=0.3}") == 2);
}

TEST_CASE("an override counts as what the file would say", "[unit][study]") {
  JobFiles job;
  const CaseKeys keys = job.keys();
  CHECK(job.keys({"stage.rough.step=1.50"}).result == keys.result);
  CHECK(job.keys({"stage.finish.step=3", "stage.finish.step=1"}).result == keys.result);
}

TEST_CASE("comments are part of the file that a result names, not of its stages", "[unit][study]") {
  JobFiles job;
  const CaseKeys before = job.keys();
  write(job.path("job.toml"), "# words\n" + std::string(kJob));
  const CaseKeys after = job.keys();
  CHECK(after.prefixes == before.prefixes);
  CHECK(after.result != before.result);
}

TEST_CASE("a file with another content makes other keys", "[unit][study]") {
  JobFiles job;
  const CaseKeys before = job.keys();
  std::string cage = model::read_text_file(job.path("cage.obj"));
  write(job.path("cage.obj"), cage + "# the same cage\n");
  const CaseKeys after = job.keys();
  CHECK(after.prefixes[0] != before.prefixes[0]);
  CHECK(after.result != before.result);
  write(job.path("cage.obj"), cage);
  CHECK(job.keys().result == before.result);
}

TEST_CASE("stages of one program depend on where the others begin", "[unit][study]") {
  std::string text = kJob;
  text.resize(text.find("[[stage]]"));
  for (const char* stage : {"first", "second", "third"})
    text += std::string("[[stage]]\nname = \"") + stage +
            "\"\ntool = \"ball6\"\nprogram = \"p.ngc\"\nprogram_comment = \"" + stage + "\"\n";
  JobFiles job(text);
  write(job.path("p.ngc"), "G0 X1 Y1 Z1\n");
  CHECK(job.kept("stage.third.program_comment=FOURTH") == 0);
  CHECK(job.kept("tool.flat6.diameter=5") == 0);
  // No stage is planned: there is no model.
  CHECK(job.kept("stage.second.allowance=1") == 0);
  const CaseKeys before = job.keys();
  write(job.path("p.ngc"), "G0 X2 Y1 Z1\n");
  CHECK(job.keys().prefixes[0] != before.prefixes[0]);
}

TEST_CASE("a case that cannot be read has no key", "[unit][study]") {
  JobFiles job;
  CHECK_THROWS_AS(job.keys({"stage.polish.step=1"}), model::InputError);
  CHECK_THROWS_AS(job.keys({"stage.finish.step=0"}), model::InputError);
  fs::remove(job.path("cage.obj"));
  CHECK_THROWS_AS(job.keys(), model::InputError);
}

TEST_CASE("the canonical text tells types and borders apart", "[unit][study]") {
  const auto of = [](const char* text) { return canonical(toml::parse(text)); };
  CHECK(of("b = 1\na = 2 # words") == of("a = 2\nb = 1"));
  CHECK(of("a.b = 1") == of("[a]\nb = 1"));
  const std::set<std::string> different = {of("a = 1"),
                                           of("a = 1.0"),
                                           of("a = \"1\""),
                                           of("a = true"),
                                           of("a = false"),
                                           of("a = [1]"),
                                           of("a = [[1]]"),
                                           of("a = [1, 1]"),
                                           of("a = {}"),
                                           of("a = \"\""),
                                           of("a = [\"1\"]"),
                                           of("a = 2020-01-01"),
                                           of("a = -0.0"),
                                           of("a = 0.0"),
                                           of("a = 2020-01-02"),
                                           of("a = []"),
                                           of("a = 12:00:00"),
                                           of("a = 0.1"),
                                           of("a = 0.10000001"),
                                           of("a = 2020-01-01T00:00:00Z"),
                                           of("a = [\"b\", \"c\"]"),
                                           of("a = [\"b\\\",\\\"c\"]")};
  CHECK(different.size() == 22);
}

}  // namespace limitgauge::app
