// The simulator's swept distance against the verifier's: two implementations that share only the
// cutter's definition. A disagreement of the instruments on a real job would show up here first.
#include <cmath>
#include <random>

#include "simulator/sweep/swept_distance.h"
#include "tests/support/catch.h"
#include "verifier/cutter/swept_body.h"

namespace limitgauge {
namespace {

using model::Cutter;
using model::CutterType;
using model::Vec3;

const Cutter kSweptCutters[] = {{"ball", CutterType::ball, 6, 3, 0, 60, {}, {}},
                                {"flat", CutterType::flat, 8, 0, 0, 60, {}, {}},
                                {"bull", CutterType::bull, 10, 2, 0, 60, {}, {}},
                                {"taper", CutterType::taper, 2, 0.5, 8, 60, {}, {}},
                                // Flutes so short that their top matters to many of the points.
                                {"short ball", CutterType::ball, 6, 3, 0, 4, {}, {}},
                                {"short flat", CutterType::flat, 8, 0, 0, 5, {}, {}},
                                {"short bull", CutterType::bull, 10, 2, 0, 4, {}, {}},
                                {"short taper", CutterType::taper, 2, 0.5, 8, 6, {}, {}},
                                model::parse_cutter("drill:D=6,angle=118,L=60"),
                                model::parse_cutter("drill:D=9,angle=90,L=5"),
                                model::parse_cutter("apt:D=8,r=1,a=10,b=5,L=30"),
                                model::parse_cutter("apt:D=6,r=6,a=45,L=12"),
                                model::parse_cutter("apt:D=10,r=2,b=-10,L=9"),
                                model::parse_cutter("apt:D=6,a=20,b=-30,L=5"),
                                model::parse_cutter("apt:D=10,r=1,a=15,b=-40,L=6"),
                                model::parse_cutter("apt:D=8,b=-45,L=4")};

}  // namespace

TEST_CASE("both instruments measure the same swept volume", "[property]") {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> part(-9, 9);
  const auto random_point = [&] { return Vec3{part(random), part(random), part(random)}; };
  for (const Cutter& cutter : kSweptCutters) {
    const simulator::CutterProfile simulated(cutter);
    const verifier::CutterProfile verified(cutter);
    for (int n = 0; n < 5000; ++n) {
      const Vec3 a = random_point(), p = random_point();
      Vec3 b = random_point();
      if (n % 4 == 1) b.z = a.z;
      if (n % 4 == 2) b.x = a.x, b.y = a.y;
      if (n % 4 == 3) b = a;
      const double s = swept_distance(simulated, {a, b, 0}, p).distance;
      const double v = body_value(verified, {a, b}, p);
      CAPTURE(cutter.id, n, s, v);
      // Both end their search along a sloped move within 1e-10 mm.
      CHECK(std::abs(s - v) <= 1e-9);
    }
  }
}

}  // namespace limitgauge
