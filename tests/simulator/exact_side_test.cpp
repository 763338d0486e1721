#include "simulator/mesh/exact_side.h"

#include <cmath>
#include <random>

#include "tests/support/catch.h"

using namespace limitgauge::simulator;

namespace {

// Integers of up to 30 bits have exact products in 64; scaled by a power of two they are doubles.
int side_in_integers(const long long (&v)[6]) {
  const long long det = (v[2] - v[0]) * (v[5] - v[1]) - (v[3] - v[1]) * (v[4] - v[0]);
  return (det > 0) - (det < 0);
}

}  // namespace

TEST_CASE("the side of a line, by whole numbers", "[property][mesh]") {
  std::mt19937 random(1);
  int on_it = 0;
  for (int n = 0; n < 200000; ++n) {
    const long long range = n % 2 == 0 ? 4 : 1 << 29;
    long long v[6];
    for (auto& x : v) x = static_cast<long long>(random() % (2 * range)) - range;
    // A third of the points are put on the line as far as whole numbers allow.
    if (n % 3 == 0) {
      const long long k = static_cast<long long>(random() % 3);
      v[4] = v[0] + k * (v[2] - v[0]) / 2, v[5] = v[1] + k * (v[3] - v[1]) / 2;
    }
    const auto scaled = [](long long x) { return std::ldexp(static_cast<double>(x), -20); };
    const FlatPoint a{scaled(v[0]), scaled(v[1])}, b{scaled(v[2]), scaled(v[3])},
        p{scaled(v[4]), scaled(v[5])};
    const int side = side_of_line(a, b, p);
    REQUIRE(side == side_in_integers(v));
    REQUIRE(side_of_line(b, a, p) == -side);
    REQUIRE(side_of_line(b, p, a) == side);
    on_it += side == 0;
  }
  CHECK(on_it > 10000);
}

TEST_CASE("the side of a line one unit in the last place off", "[unit][mesh]") {
  // p lies on the line from (12, 12) to (24, 24) but for the last bit; differences of these
  // numbers are not exact.
  const FlatPoint a{12, 12}, b{24, 24};
  const double up = std::nextafter(0.1, 1.0);
  CHECK(side_of_line(a, b, {0.1, 0.1}) == 0);
  CHECK(side_of_line(a, b, {0.1, up}) == 1);
  CHECK(side_of_line(a, b, {up, 0.1}) == -1);
  CHECK(side_of_line({0.1, 0.1}, {0.7, 0.7}, {1e5, std::nextafter(1e5, 2e5)}) == 1);
}
