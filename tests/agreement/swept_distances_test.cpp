// The simulator's swept distance against the verifier's: two implementations that share only the
// cutter's definition. A disagreement of the instruments on a real job would show up here first.
#include <random>

#include "simulator/swept_distance.h"
#include "tests/support/catch.h"
#include "verifier/swept_body.h"

namespace limitgauge {
namespace {

using model::Cutter;
using model::CutterType;
using model::Vec3;

const Cutter kCutters[] = {{"ball", CutterType::ball, 6, 3, 0, 60, {}, {}},
                           {"flat", CutterType::flat, 8, 0, 0, 60, {}, {}},
                           {"bull", CutterType::bull, 10, 2, 0, 60, {}, {}},
                           {"taper", CutterType::taper, 2, 0.5, 8, 60, {}, {}},
                           // Flutes so short that their top matters to many of the points.
                           {"short ball", CutterType::ball, 6, 3, 0, 4, {}, {}},
                           {"short flat", CutterType::flat, 8, 0, 0, 5, {}, {}},
                           {"short bull", CutterType::bull, 10, 2, 0, 4, {}, {}},
                           {"short taper", CutterType::taper, 2, 0.5, 8, 6, {}, {}}};

}  // namespace

TEST_CASE("both instruments measure the same swept volume", "[property]") {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> part(-9, 9);
  const auto random_point = [&] { return Vec3{part(random), part(random), part(random)}; };
  for (const Cutter& cutter : kCutters) {
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
      // Both end their search along a sloped move within 1e-9 mm.
      CHECK(s == Approx(v).margin(2e-9));
    }
  }
}

}  // namespace limitgauge
