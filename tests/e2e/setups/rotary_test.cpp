// Programs for machines with rotary axes, posted by fixtures/rotary/post.py, whose kinematics are
// its own.
#include <nlohmann/json.hpp>

#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
using nlohmann::json;
namespace {

json result_of(const Scratch& scratch, const std::string& folder) {
  return json::parse(read_text(scratch / folder / "result.json"));
}

const json& stage_of(const json& result, const std::string& name) {
  for (const json& stage : result["stages"])
    if (stage["name"] == name) return stage;
  FAIL("no stage " << name);
  return result;
}

Outcome run(const Scratch& scratch, const std::string& job, const std::string& folder) {
  return limitgauge(scratch, {"run", job, "-o", folder, "--no-pictures", "--quiet"});
}

std::string machine_job(const std::string& name) {
  return fixture("rotary/" + name + ".toml");
}

/// The trunnion's job with a changed program, in the scratch folder.
std::string with_program(const Scratch& scratch, const std::string& from, const std::string& to) {
  std::string program = read_text(fixture("rotary/trunnion.nc"));
  const std::size_t at = program.find(from);
  REQUIRE(at != std::string::npos);
  write_text(scratch / "trunnion.nc", program.replace(at, from.size(), to));
  std::string job = read_text(machine_job("trunnion"));
  const std::string cage = "../cages/quick-dome.obj";
  job.replace(job.find(cage), cage.size(), fixture("cages/quick-dome.obj"));
  write_text(scratch / "changed.toml", job);
  return "changed.toml";
}

}  // namespace

TEST_CASE("programs for three machines have the figures of the program for three axes",
          "[e2e][setups]") {
  const Scratch scratch;
  // What the programs were posted from.
  REQUIRE(limitgauge(scratch, {"run", fixture("jobs/quick-dome.toml"), "--set",
                               "stage.rough.step=1.5", "--set", "stage.rough.gate.uncut=2", "-o",
                               "nominal", "--no-pictures", "--quiet"})
              .exit_code == 0);
  const json nominal = result_of(scratch, "nominal");
  const json& expected = stage_of(nominal, "rough")["deviation"];
  for (const char* name : {"trunnion", "tilting-head", "swivel-head"}) {
    CAPTURE(name);
    const Outcome outcome = run(scratch, machine_job(name), name);
    INFO(outcome.errors);
    REQUIRE(outcome.exit_code == 0);
    const json result = result_of(scratch, name);
    const json& found = stage_of(result, "rough")["deviation"];
    // Programs have five decimals; 0.02 µm is what the certified ends may differ by.
    for (const char* figure : {"gouge_mm", "uncut_mm"})
      for (const char* end : {"low", "high"})
        CHECK(std::abs(found[figure][end].get<double>() - expected[figure][end].get<double>()) <
              2e-5);
  }
}

TEST_CASE("an A word that a post-processor lost fails at its line", "[e2e][setups]") {
  const Scratch scratch;
  REQUIRE(run(scratch, machine_job("lost-word"), "out").exit_code == 1);
  const json result = result_of(scratch, "out");
  CHECK(stage_of(result, "rough.2")["verdict"] == "pass");
  const json& failed = stage_of(result, "rough");
  CHECK(failed["verdict"] == "fail");
  CHECK(failed["deviation"]["gouge_mm"]["low"] > 0.5);
  // The word is missing in the line that turns the axes a second time.
  const std::string program = read_text(fixture("rotary/lost-word.nc"));
  const auto line = std::count(program.begin(),
                               program.begin() + static_cast<long>(program.find("G0 C250")), '\n');
  CHECK(failed["deviation"]["gouges"][0]["line"] > line);
  CHECK(stage_of(result, "rough.4")["verdict"] == "not_run");
}

TEST_CASE("results with stretches are compared", "[e2e][setups]") {
  const Scratch scratch;
  REQUIRE(run(scratch, machine_job("tilting-head"), "a").exit_code == 0);
  CHECK(result_of(scratch, "a")["stages"][1]["stretch"]["axes"] == "B33C50");
  CHECK(limitgauge(scratch, {"compare", "a", "a"}).exit_code == 0);
}

TEST_CASE("a turn that sweeps the tool through the part is a collision, a clear one is none",
          "[e2e][setups]") {
  const Scratch scratch;
  // Without its retreat by Z the tool stands 2 mm clear of all that passes under it; without its
  // retract it still stands in the part.
  const std::string retract =
      "G0 X-9.57188 Y-14.53830 Z10.76606\nG0 X-12.99688 Y11.39770 Z10.76606\n";
  const std::string retreat = "G91 G28 Z0\nG90\nG43 H1\n", turn = "G0 A-35 C250";
  const std::string clear = with_program(scratch, "G255\n" + retreat + turn, "G255\n" + turn);
  CHECK(run(scratch, clear, "clear").exit_code == 0);
  const std::string job =
      with_program(scratch, retract + "G255\n" + retreat + turn, "G255\n" + turn);
  REQUIRE(run(scratch, job, "out").exit_code == 1);
  const json result = result_of(scratch, "out");
  const json& failed = stage_of(result, "rough");
  CHECK(failed["verdict"] == "fail");
  const std::string program = read_text(scratch / "trunnion.nc");
  const auto line = 1 + std::count(program.begin(),
                                   program.begin() + static_cast<long>(program.find(turn)), '\n');
  bool found = false;
  for (const json& finding : failed["simulation"]["findings"])
    found |= finding["kind"] == "rapid_through_stock" && finding["line"] == line;
  CHECK(found);
}

TEST_CASE("bodies of the head are held against the stock as the axes have them", "[e2e][setups]") {
  const Scratch scratch;
  std::string job = read_text(machine_job("swivel-head"));
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"../cages", fixture("cages")},
                                 {"swivel-head.nc", fixture("rotary/swivel-head.nc")}})
    job.replace(job.find(from), from.size(), to);
  // A pyramid on the head: the gauge point is 80 mm above the tip.
  const auto plate = [&](double low_mm) {
    const std::string z = std::to_string(low_mm);
    write_text(scratch / "plate.obj",
               "v -40 -40 " + z + "\nv 40 -40 " + z + "\nv 40 40 " + z + "\nv -40 40 " + z +
                   "\nv 0 0 40\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
  };
  write_text(scratch / "job.toml",
             job + "[[fixture]]\nname = \"plate\"\nfile = \"plate.obj\"\naxis = \"B\"\n");
  plate(-40);
  const Outcome clear = run(scratch, "job.toml", "clear");
  INFO(clear.errors);
  CHECK(clear.exit_code == 0);
  plate(-78);
  REQUIRE(run(scratch, "job.toml", "low").exit_code == 1);
  const json result = result_of(scratch, "low");
  const json& failed = stage_of(result, "rough.2");
  CHECK(failed["verdict"] == "fail");
  const json& hit = failed["simulation"]["holder_collisions"][0];
  CHECK(hit["part"] == "plate");
  CHECK(hit["line"] > 0);
  // What was looked at is said, as the job has it.
  const json& looked_at = result["process_limits"];
  REQUIRE(looked_at["fixtures"].size() == 1);
  CHECK(looked_at["fixtures"][0] ==
        json{{"name", "plate"}, {"file", "plate.obj"}, {"translate_mm", {0, 0, 0}}, {"axis", "B"}});
  REQUIRE(looked_at["rotary_axes"].size() == 2);
  CHECK(looked_at["rotary_axes"][1] == json{{"word", "B"},
                                            {"carries", "tool"},
                                            {"direction", {0, 1, 0}},
                                            {"point_mm", {0, 0.5, 180}},
                                            {"range_deg", {-360, 360}}});
}

TEST_CASE("an axis beyond its limits fails at its line", "[e2e][setups]") {
  const Scratch scratch;
  const std::string job = with_program(scratch, "G0 A0 C0\nM5", "G0 A0 C-400\nM5");
  REQUIRE(run(scratch, job, "out").exit_code == 1);
  const json result = result_of(scratch, "out");
  CHECK(stage_of(result, "rough")["verdict"] == "pass");
  const json& last = result["stages"].back();
  CHECK(last["verdict"] == "fail");
  const json& finding = last["simulation"]["findings"][0];
  CHECK(finding["kind"] == "beyond_travel");
  CHECK(finding["against"] == "C- (-400 of -360 degrees)");
}

TEST_CASE("a head that leans takes X beyond its travel, at its line", "[e2e][setups]") {
  const Scratch scratch;
  const auto outcome = [&](const std::string& high_mm) {
    return limitgauge(scratch,
                      {"run", machine_job("tilting-head"), "-o", "out", "--force", "--no-pictures",
                       "--quiet", "--set", "machine.travel.x=[-20," + high_mm + "]"})
        .exit_code;
  };
  // With its tool of 80 mm the head leans 33 degrees about an axis 150 mm above the gauge point:
  // X stands 125.3 mm beside the tip, which itself goes no farther than 16.5.
  REQUIRE(outcome("100") == 1);
  const json stage = stage_of(result_of(scratch, "out"), "rough");
  CHECK(stage["verdict"] == "fail");
  const json& finding = stage["simulation"]["findings"][0];
  CHECK(finding["kind"] == "beyond_travel");
  CHECK(finding["against"] == "x+");
  CHECK(finding["line"] == 272);
  CHECK(finding["x"].get<double>() == Approx(16.5));
  const double depth_mm = finding["depth_mm"];
  CHECK(depth_mm > 30);
  CHECK(outcome(std::to_string(100 + depth_mm + 0.001)) == 0);
  CHECK(outcome(std::to_string(100 + depth_mm - 0.001)) == 1);
}

}  // namespace limitgauge::e2e
