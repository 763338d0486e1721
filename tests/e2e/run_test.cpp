#include <nlohmann/json.hpp>

#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

const std::string kDome = fixture("jobs/quick-dome.toml");

json result_in(const fs::path& folder) {
  return json::parse(read_text(folder / "result.json"));
}

/// Removes what may differ between two runs of the same job: clocks and what the machine gave.
void remove_measurements_of_the_run(json& value) {
  if (value.is_array()) {
    for (json& entry : value) remove_measurements_of_the_run(entry);
  }
  if (!value.is_object()) return;
  for (const char* key : {"created", "threads", "seconds", "peak_memory_bytes"}) value.erase(key);
  for (auto& [key, entry] : value.items()) remove_measurements_of_the_run(entry);
}

TEST_CASE("the quick job passes and leaves the files of the contract", "[e2e][run]") {
  const Scratch scratch;
  const Outcome outcome = limitgauge(scratch, {"run", kDome});
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.errors.empty());
  const fs::path folder = scratch / "limitgauge-out/quick-dome";
  CHECK_THAT(outcome.out, ContainsSubstring("rough") && ContainsSubstring("finish") &&
                              ContainsSubstring((folder / "report.html").string()));
  for (const char* file : {"report.html", "result.json", "junit.xml", "findings.sarif",
                           "findings.csv", "stages.vtm"}) {
    CHECK(fs::file_size(folder / file) > 70);
  }
  // A stage's folder of that name could not be made, after all the work.
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const std::string file = entry.path().filename();
    CHECK_THAT(limitgauge(scratch, {"plan", kDome, "--set", "stage.rough.name=" + file}).errors,
               ContainsSubstring("\"" + file + "\" is a file of the results"));
  }
  for (const char* stage : {"rough", "finish"}) {
    for (const char* file : {"toolpath.ngc", "toolpath.vtp", "stock.vdb", "stock.vtp",
                             "deviation.vtp", "deviation.png", "perspective.png", "stock.png"}) {
      CAPTURE(stage, file);
      CHECK(fs::file_size(folder / stage / file) > 100);
    }
  }
  CHECK(scratch.entries() == std::vector<std::string>{"limitgauge-out"});
}

TEST_CASE("the figures of the quick job are those of a sound path", "[e2e][run]") {
  const Scratch scratch;
  REQUIRE(limitgauge(scratch, {"run", kDome, "-o", "out", "--quiet", "--no-pictures"}).exit_code ==
          0);
  const json result = result_in(scratch / "out");
  CHECK(result["schema"] == "limitgauge.result/2");
  CHECK(result["verdict"] == "pass");
  CHECK(result["surface"]["patches"] == 12);
  for (const json& stage : result["stages"]) {
    CHECK(stage["verdict"] == "pass");
    CHECK(stage["simulation"]["removed_volume_mm3"] > 0);
    CHECK(stage["simulation"]["rapid_collisions"].empty());
    CHECK(stage["simulation"]["holder_collisions"].empty());
    const json& gouge = stage["deviation"]["gouge_mm"];
    CHECK(gouge["low"] >= 0);
    CHECK(gouge["low"] <= gouge["high"]);
  }
  const json& finish = result["stages"][1]["deviation"];
  CHECK(finish["coverage"] >= 0.99);
  // The dome's slope stays below 32 degrees: step 0.3 along x is at most 0.3 / cos 32 = 0.354 on
  // the surface, a scallop of 0.354^2 / (8 R) = 5.2 um at R3 less the dome's curvature; with the
  // path's tolerance of 10 um a sound finish leaves less than 16 um, and it leaves something.
  CHECK(finish["uncut_mm"]["high"] < 0.016);
  CHECK(finish["uncut_mm"]["high"] > 0.001);
}

TEST_CASE("the number of threads changes no figure", "[e2e][run]") {
  const Scratch scratch;
  std::vector<std::string> results;
  for (const char* threads : {"1", "2"}) {
    REQUIRE(
        limitgauge(scratch, {"run", kDome, "-o", threads, "--threads", threads, "--no-pictures"})
            .exit_code == 0);
    json result = result_in(scratch / threads);
    CHECK(result["threads"] == std::stoi(threads));
    remove_measurements_of_the_run(result);
    results.push_back(result.dump());
  }
  CHECK(results[0] == results[1]);
  for (const char* file :
       {"rough/toolpath.ngc", "finish/toolpath.ngc", "rough/toolpath.vtp", "finish/deviation.vtp",
        "finish/stock.vtp", "stages.vtm", "findings.sarif", "findings.csv"}) {
    CAPTURE(file);
    CHECK(read_text(scratch / "1" / file) == read_text(scratch / "2" / file));
  }
}

TEST_CASE("a stage that fails its gate stops the job with a report", "[e2e][run]") {
  const Scratch scratch;
  const Outcome outcome = limitgauge(
      scratch, {"run", kDome, "-o", "out", "--no-pictures", "--set", "stage.rough.gate.uncut=0.01",
                "--set", "verification.resolution=0.005"});
  CHECK(outcome.exit_code == 1);
  const json result = result_in(scratch / "out");
  CHECK(result["verdict"] == "fail");
  CHECK(result["stages"][0]["verdict"] == "fail");
  CHECK_FALSE(result["stages"][0]["reasons"].empty());
  CHECK(result["stages"][1]["verdict"] == "not_run");
  CHECK(fs::exists(scratch / "out/report.html"));
  CHECK(fs::exists(scratch / "out/junit.xml"));
  CHECK_FALSE(fs::exists(scratch / "out/finish"));
}

TEST_CASE("with --json the bytes of result.json and nothing else are printed", "[e2e][run]") {
  const Scratch scratch;
  const Outcome run =
      limitgauge(scratch, run_coarse_job("out", {"--json", "--history", "runs.sqlite"}));
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out == read_text(scratch / "out/result.json"));
  const Outcome compared = limitgauge(scratch, {"compare", "out", "out", "--json", "-o", "same"});
  CHECK(compared.exit_code == 0);
  CHECK(compared.out == read_text(scratch / "same/compare.json"));
  // Bad input prints none.
  const Outcome refused = limitgauge(scratch, {"run", "none.toml", "--json"});
  CHECK(refused.exit_code == 3);
  CHECK(refused.out.empty());
}

TEST_CASE("a finished folder is overwritten only with --force", "[e2e][run]") {
  const Scratch scratch;
  REQUIRE(limitgauge(scratch, {"plan", kDome, "-o", "out"}).exit_code == 0);
  const Outcome refused = limitgauge(scratch, {"run", kDome, "-o", "out"});
  CHECK(refused.exit_code == 3);
  CHECK_THAT(refused.errors, ContainsSubstring("--force"));
  CHECK_FALSE(fs::exists(scratch / "out/result.json"));
  CHECK(limitgauge(scratch, run_coarse_job("out", {"--force"})).exit_code == 0);
  CHECK(result_in(scratch / "out")["verdict"] == "pass");
  CHECK(scratch.entries() == std::vector<std::string>{"out"});
  // Not what is the user's.
  write_text(scratch / "out/notes.txt", "mine");
  const Outcome kept = limitgauge(scratch, {"run", kDome, "-o", "out", "--force"});
  CHECK(kept.exit_code == 3);
  CHECK_THAT(kept.errors, ContainsSubstring("out/notes.txt: error: "));
  CHECK(read_text(scratch / "out/notes.txt") == "mine");
}

TEST_CASE("plan writes toolpaths and nothing else", "[e2e][plan]") {
  const Scratch scratch;
  REQUIRE(limitgauge(scratch, {"plan", kDome, "-o", "paths"}).exit_code == 0);
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(scratch / "paths")) {
    if (entry.is_regular_file()) {
      files.push_back(fs::relative(entry.path(), scratch / "paths").string());
    }
  }
  std::sort(files.begin(), files.end());
  CHECK(files == std::vector<std::string>{"finish/toolpath.ngc", "finish/toolpath.vtp",
                                          "manifest.sha256", "rough/toolpath.ngc",
                                          "rough/toolpath.vtp"});
}

}  // namespace
}  // namespace limitgauge::e2e
