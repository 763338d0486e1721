#include "simulator/mesh/tetrahedra.h"

#include <array>
#include <random>

#include "tests/support/catch.h"

namespace {

using limitgauge::simulator::negative_share;

template <class Field>
std::array<double, 8> corners(Field f) {
  std::array<double, 8> v;
  for (int k = 0; k < 8; ++k) v[k] = f(k >> 2 & 1, k >> 1 & 1, k & 1);
  return v;
}

}  // namespace

TEST_CASE("shares of a cube cut by planes", "[unit][tetrahedra]") {
  CHECK(negative_share(corners([](double x, double, double) { return x - 0.3; })) == Approx(0.3));
  CHECK(negative_share(corners([](double, double y, double) { return 0.2 - y; })) == Approx(0.8));
  // A corner cut off at a distance a along each edge: a³/6.
  CHECK(negative_share(corners([](double x, double y, double z) { return x + y + z - 0.5; })) ==
        Approx(0.125 / 6));
  CHECK(negative_share(corners([](double x, double y, double) { return x + y - 1; })) ==
        Approx(0.5));
  CHECK(negative_share(corners([](double, double, double) { return -1.0; })) == 1);
  CHECK(negative_share(corners([](double, double, double) { return 1.0; })) == 0);
  CHECK(negative_share(corners([](double, double, double z) { return -z; })) == Approx(1));
}

TEST_CASE("shares of both sides of any field make the whole", "[property][tetrahedra]") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<> in(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    std::array<double, 8> f, g;
    for (int k = 0; k < 8; ++k) f[k] = in(random), g[k] = -f[k];
    CHECK(negative_share(f) + negative_share(g) == Approx(1).margin(1e-12));
  }
}
