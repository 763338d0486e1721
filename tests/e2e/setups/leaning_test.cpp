// Rows that lean: a holder that would run into a wall, and programs that are read again.
#include <nlohmann/json.hpp>

#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
using nlohmann::json;
namespace {

const std::vector<std::string> kCoarse = {
    "--set", "stage.finish.step=1.5",        "--set", "stage.finish.gate.uncut=0.5",
    "--set", "verification.resolution=0.01", "--set", "simulation.voxel=0.3"};

Outcome run_step(const Scratch& scratch, const std::string& job, const std::string& folder,
                 const std::vector<std::string>& settings, const std::string& command = "run") {
  std::vector<std::string> words = {command, job, "-o", folder, "--quiet"};
  if (command == "run") words.push_back("--no-pictures");
  words.insert(words.end(), kCoarse.begin(), kCoarse.end());
  for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
  return limitgauge(scratch, words);
}

json finish_of(const Scratch& scratch, const std::string& folder) {
  return json::parse(read_text(scratch / folder / "result.json"))["stages"][0];
}

std::string step_job() {
  return fixture("leaning/step.toml");
}

/// The job, its stage replaced by the program that was planned for it.
std::string strangers_job(const Scratch& scratch, const std::string& program) {
  std::string job = read_text(step_job());
  for (const std::string file : {"step.obj", "step-stock.obj"})
    job.replace(job.find("\"" + file), file.size() + 1, "\"" + fixture("leaning/" + file));
  const std::size_t from = job.find("strategy"), to = job.find("[stage.gate]");
  job.replace(from, to - from, "program = \"" + program + "\"\n");
  job = job.replace(job.find("[post]"), job.find("[[tool]]") - job.find("[post]"), "");
  write_text(scratch / "stranger.toml", job);
  return "stranger.toml";
}

}  // namespace

TEST_CASE("a holder that meets a wall upright is given the least tilt that clears it",
          "[e2e][setups][slow]") {
  const Scratch scratch;
  const Outcome upright = run_step(scratch, step_job(), "upright", {"stage.finish.tilt=0"});
  CHECK(upright.exit_code == 1);
  CHECK(finish_of(scratch, "upright")["simulation"]["holder_collisions"].size() > 0);
  const Outcome leaning = run_step(scratch, step_job(), "leaning", {});
  INFO(leaning.errors);
  REQUIRE(leaning.exit_code == 0);
  const json stage = finish_of(scratch, "leaning");
  CHECK(stage["simulation"]["holder_collisions"].empty());
  const double tilt = stage["toolpath"]["lean"]["tilt_deg"];
  CHECK(tilt == -20);
  // `plan` proves the same one.
  REQUIRE(run_step(scratch, step_job(), "planned", {}, "plan").exit_code == 0);
  CHECK(read_text(scratch / "planned/finish/toolpath.ngc") ==
        read_text(scratch / "leaning/finish/toolpath.ngc"));
}

TEST_CASE("a leaning stage's program and CL data, read as a stranger's, have its figures",
          "[e2e][setups][slow]") {
  const Scratch scratch;
  const std::vector<std::string> both = {"stage.finish.tilt=-25", "stage.finish.lead=8"};
  const Outcome planned = run_step(scratch, step_job(), "planned", both);
  INFO(planned.errors);
  REQUIRE(planned.exit_code == 0);
  const json expected = finish_of(scratch, "planned")["deviation"];
  for (const std::string file : {"toolpath.ngc", "toolpath.apt"}) {
    const std::string job = strangers_job(scratch, "planned/finish/" + file);
    Outcome again =
        limitgauge(scratch, {"run", job, "-o", file, "--quiet", "--no-pictures", "--set",
                             "stage.finish.gate.uncut=0.5", "--set", "verification.resolution=0.01",
                             "--set", "simulation.voxel=0.3"});
    INFO(again.errors);
    REQUIRE(again.exit_code == 0);
    const json found = finish_of(scratch, file)["deviation"];
    for (const char* figure : {"gouge_mm", "uncut_mm"})
      for (const char* end : {"low", "high"})
        CHECK(found[figure][end].get<double>() ==
              Approx(expected[figure][end].get<double>()).margin(0.012));
  }
}

TEST_CASE("rows that cannot lean are one error with its place", "[e2e][setups]") {
  const Scratch scratch;
  const auto refusal = [&](const std::vector<std::string>& settings) {
    const Outcome outcome = run_step(scratch, step_job(), "refused", settings, "plan");
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.out.empty());
    return outcome.errors;
  };
  CHECK_THAT(refusal({"machine.control=grbl"}), ContainsSubstring("has no words for it"));
  CHECK_THAT(refusal({"machine.control=linuxcnc"}), ContainsSubstring("dialect = \"linuxcnc\""));
  CHECK_THAT(refusal({"stage.finish.strategy=steep_shallow"}),
             ContainsSubstring("\"tilt\" changes nothing"));
  CHECK_THAT(refusal({"stage.finish.tilt=61"}), ContainsSubstring("-60 to 60"));
  CHECK_THAT(refusal({"stage.finish.tilt=-20", "machine.travel.y=[-20, 20]"}),
             ContainsSubstring("of its program takes Y"));
}

}  // namespace limitgauge::e2e
