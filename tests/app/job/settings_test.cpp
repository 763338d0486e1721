#include "app/job/settings.h"

#include <cmath>

#include "app/run/stage_check.h"
#include "tests/app/job_text.h"
#include "tests/support/catch.h"

namespace limitgauge::app {
namespace {

const model::Box3 kSurface{{-10, -10, -2.5}, {10, 10, 4}};

TEST_CASE("voxel auto follows the tightest gate within its bounds", "[unit][settings]") {
  Job job = read(good_job());
  CHECK(automatic_voxel_mm(job) == Approx(0.1));
  job.stages[0].limits.gouge_mm = 0.001;
  CHECK(automatic_voxel_mm(job) == Approx(0.05));
  job.stages[0].limits.gouge_mm = 1;
  CHECK(automatic_voxel_mm(job) == Approx(0.25));
  job.stages[0].limits.has_gouge = false;
  CHECK(automatic_voxel_mm(job) == Approx(0.1));
  // 300 × 300 × 80 mm have 276,000 mm² of surface: five million voxels of 0.235 mm.
  job.stock = model::BoxStock{{0, 0, 0}, {300, 300, 80}};
  CHECK(automatic_voxel_mm(job) == Approx(0.24));
}

TEST_CASE("samples of the deviation lie further apart on large parts", "[unit][settings]") {
  CHECK(field_spacing_mm(5000) == 0.25);
  CHECK(field_spacing_mm(125'000) == 0.25);
  // 3 m square: two millions of 2.12 mm square.
  CHECK(field_spacing_mm(9e6) == Approx(2.13));
}

TEST_CASE("the floor lets a ball roll over the lowest edge", "[unit][settings]") {
  CHECK(automatic_floor_mm(model::parse_cutter("ball:D=6"), kSurface) == Approx(-5.5));
  CHECK(automatic_floor_mm(model::parse_cutter("flat:D=8"), kSurface) == Approx(-2.5));
  CHECK(automatic_floor_mm(model::parse_cutter("bull:D=8,r=1"), kSurface) == Approx(-3.5));
}

TEST_CASE("what the job states is not chosen again", "[unit][settings]") {
  const Job stated = read(good_job(), {"simulation.voxel=0.33", "verification.resolution=0.004",
                                       "stage.finish.floor=-7"});
  const Settings settings = choose_settings(stated, kSurface, kMemory);
  CHECK(settings.voxel_mm == 0.33);
  CHECK(settings.resolution_mm == std::vector<double>{0.004});
  CHECK(settings.floor_z_mm == std::vector<double>{-7});
  for (const std::string& line : assumptions(stated, settings)) {
    CHECK_THAT(line, !ContainsSubstring("auto"));
  }
}

TEST_CASE("what was chosen is said", "[unit][settings]") {
  const Job job = read(good_job());
  std::string all;
  for (const std::string& line : assumptions(job, choose_settings(job, kSurface, kMemory)))
    all += line + "\n";
  for (const char* said :
       {"rapids are straight", "voxel 0.1 mm (auto", "resolution 0.001 mm (auto",
        "lowest tip height z -5.5 mm (default", "plunge_feed = 500", "flute length 24 mm (default",
        "surface precision 0.01 mm (default)", "allowance 0 mm (default)"}) {
    CHECK_THAT(all, ContainsSubstring(said));
  }
}

}  // namespace
}  // namespace limitgauge::app
