// Values that no part was ever cut by: refused where they stand, before anything is worked on.
#include <string>

#include "app/inputs/part_fit.h"
#include "model/base/error.h"
#include "tests/app/job_text.h"
#include "tests/support/catch.h"

namespace limitgauge::app {
namespace {

std::string number_words(const std::string& key, const std::string& value) {
  return "\"" + key + "\" is " + value + "; expected decimals, as 16";
}

TEST_CASE("numbers of a job are decimal", "[unit][job]") {
  for (const std::string value : {"0x10", "0b10000", "0o20"}) {
    CHECK_THAT(error_of(with(good_job(), "step = 0.1", "step = " + value)),
               ContainsSubstring("job.toml:16:8: error: " + number_words("step", value)));
    CHECK_THAT(error_of(with(good_job(), "[26, 26, 9]", "[26, " + value + ", 9]")),
               ContainsSubstring(number_words("size", value)));
    CHECK_THAT(error_of(good_job(), {"stage.finish.step=" + value}),
               ContainsSubstring("--set stage.finish.step=" + value +
                                 ": error: the value is no decimal number"));
  }
  // Text stays text.
  CHECK(read(good_job(), {"name=\"0x10\""}).name == "0x10");
}

TEST_CASE("a whole number that no double holds is still that number", "[unit][job]") {
  const std::string largest = std::to_string(INT64_MAX);
  CHECK_THAT(error_of(with(good_job(), "step = 0.1", "step = " + largest)),
             ContainsSubstring("\"step\" in [[stage]] is 9.22337e+18 mm"));
  CHECK_THAT(error_of(good_job(), {"surface.transform.rotate_z=" + largest}),
             ContainsSubstring("is 9.22337e+18; expected an angle"));
}

TEST_CASE("lengths of a job are those of a machine", "[unit][job]") {
  const auto wrong = [](const std::string& override) { return error_of(good_job(), {override}); };
  for (const std::string key :
       {"stage.finish.step", "stage.finish.tolerance", "stage.finish.scallop",
        "stage.finish.gate.gouge", "stage.finish.allowance", "simulation.voxel",
        "simulation.near_miss", "verification.resolution", "surface.precision", "post.arcs",
        "machine.clearance", "tool.ball3.diameter", "tool.ball3.flute_length"})
    for (const std::string value : {"1e-300", "9e-7", "10001", "1e30", "1e308"}) {
      CAPTURE(key, value);
      CHECK_THAT(wrong(key + "=" + value),
                 ContainsSubstring("\"" + key.substr(key.rfind('.') + 1) + "\" in ") &&
                     ContainsSubstring(" mm; expected a length from 1e-6 to 10000 mm"));
    }
  CHECK_THAT(wrong("stock.size=[26, 1e-7, 9]"), ContainsSubstring("size of the stock is 1e-07 mm"));
  CHECK_THAT(wrong("stage.finish.floor=1e30"), ContainsSubstring("is 1e+30 mm; expected at most"));
  CHECK_THAT(wrong("surface.transform.translate=[0, 1e30, 0]"),
             ContainsSubstring("moves by 1e+30 mm"));
  CHECK_THAT(wrong("surface.transform.scale=1e-300"),
             ContainsSubstring("is 1e-300; expected a scale from 0.000001 to 1000000"));
  CHECK_THAT(wrong("machine.travel.x=[-1e30, 0]"), ContainsSubstring("goes from -1e+30 to 0 mm"));
}

TEST_CASE("rates and angles of a job are those of a machine", "[unit][job]") {
  const auto wrong = [](const std::string& override) { return error_of(good_job(), {override}); };
  for (const std::string key : {"stage.finish.feed", "stage.finish.link_feed", "machine.rapid"})
    for (const std::string value : {"1e-9", "1e9"})
      CHECK_THAT(wrong(key + "=" + value),
                 ContainsSubstring("expected a rate from 0.001 to 1000000 mm/min"));
  CHECK_THAT(wrong("machine.acceleration=1e9"), ContainsSubstring("expected an acceleration"));
  CHECK_THAT(wrong("stage.finish.angle=1e30"), ContainsSubstring("expected an angle from -3600"));
  CHECK_NOTHROW(read(good_job(), {"stage.finish.angle=-450", "stage.finish.feed=120000"}));
}

model::Cage plate(double side_mm) {
  model::Cage cage;
  cage.vertices = {{0, 0, 0}, {side_mm, 0, 0}, {side_mm, side_mm, 0}, {0, side_mm, 0}};
  cage.add_face(std::array<model::Index, 4>{0, 1, 2, 3});
  return cage;
}

std::string misfit_of(const std::string& override) {
  return tests::message_of<model::InputError>([&] {
    const model::Cage cage = plate(10);
    require_fit(read(good_job(), {override}), &cage);
  });
}

TEST_CASE("what divides a part is no larger than the part", "[unit][job]") {
  // The stock, 26 mm, is larger than the cage.
  CHECK(misfit_of("stage.finish.step=26") == "no error");
  CHECK(misfit_of("stage.finish.step=26.5") ==
        "--set stage.finish.step=26.5: error: \"step\" in [[stage]] is 26.5 mm; expected at most "
        "26 mm, the largest extent of cage and stock");
  for (const std::string key :
       {"stage.finish.tolerance", "stage.finish.scallop", "stage.finish.allowance",
        "stage.finish.gate.uncut", "verification.resolution", "surface.precision", "post.arcs",
        "simulation.contact_tolerance"})
    CHECK_THAT(misfit_of(key + "=30"), ContainsSubstring(" is 30 mm; expected at most 26 mm"));
  CHECK(misfit_of("machine.clearance=100") == "no error");
}

TEST_CASE("a voxel is no larger than the cutter", "[unit][job]") {
  CHECK(misfit_of("simulation.voxel=6") == "no error");
  CHECK(misfit_of("simulation.voxel=6.5") ==
        "--set simulation.voxel=6.5: error: \"voxel\" in [simulation] is 6.5 mm; expected at most "
        "6 mm, the diameter of the largest cutter");
}

}  // namespace
}  // namespace limitgauge::app
