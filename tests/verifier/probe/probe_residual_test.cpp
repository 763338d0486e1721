#include "verifier/probe/probe_residual.h"

#include <cmath>

#include "tests/support/catch.h"
#include "tests/verifier/probe/probe_stocks.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Far above what is allowed for rounding, far below what anybody measures.
constexpr double kClose_mm = 2e-8;

void check_residual(const RemovedSpace& removed, const Vec3& p, double truth_mm) {
  const ProbeResidual r = probe_residual(removed, p);
  INFO(p.x << " " << p.y << " " << p.z << ": " << r.low_mm << " to " << r.high_mm.value_or(-99)
           << ", true " << truth_mm);
  REQUIRE(r.high_mm);
  CHECK(r.low_mm <= truth_mm);
  CHECK(*r.high_mm >= truth_mm);
  CHECK(*r.high_mm - truth_mm < kClose_mm);
  if (truth_mm < 0) CHECK(truth_mm - r.low_mm < kClose_mm);
}

}  // namespace

TEST_CASE("a floor that a flat cutter left is a plane", "[unit][probe]") {
  std::vector<std::pair<double, double>> rows;
  for (double y = -12; y <= 12; y += 3) rows.emplace_back(y, -2);
  const RemovedSpace removed = RowStock("flat:D=8,L=20", rows).removed();
  for (const double z : {-3.0, -2.0105, -2.0, -1.999, -1.5, 0.5}) {
    const Vec3 p{20.3, 1.7, z};
    check_residual(removed, p, z + 2);
    const ProbeResidual r = probe_residual(removed, p);
    if (z < 0) CHECK(z + 2 - r.low_mm < kClose_mm);
    CHECK(r.gap.normal.z == Approx(1));
    CHECK_FALSE(removed.is_stock(r.gap.body));
  }
}

TEST_CASE("residuals at a groove of a ball", "[unit][probe]") {
  const RemovedSpace removed = RowStock("ball:D=6,L=20", {{0, -1}}).removed();
  // Its axis is 2 mm above the block's face.
  for (const double degrees : {-20.0, 0.0, 10.0, 35.0})
    for (const double rho : {2.5, 2.99, 2.9999, 3.0001, 3.02, 3.5}) {
      const double a = degrees * M_PI / 180;
      check_residual(removed, {17, rho * std::sin(a), 2 - rho * std::cos(a)}, 3 - rho);
    }
}

TEST_CASE("residuals at the cusp between two grooves, above and below", "[unit][probe]") {
  const RemovedSpace removed = RowStock("ball:D=6,L=20", {{-1, -1}, {1, -1}}).removed();
  const double cusp = 2 - std::sqrt(8.0);
  for (const double up : {1e-5, 0.003, 0.02, 0.3}) check_residual(removed, {11, 0, cusp + up}, up);
  for (const double down : {0.003, 0.05, 0.4}) {
    const double rho = std::hypot(1, 2 - (cusp - down));
    check_residual(removed, {11, 0, cusp - down}, 3 - rho);
  }
  // Beside the cusp, in the air, where the cusp's edge is still what is nearest.
  check_residual(removed, {11, 0.01, cusp + 0.2}, std::hypot(0.01, 0.2));
  // In the air the low end is the depth into the deeper groove.
  const ProbeResidual r = probe_residual(removed, {11, 0, cusp + 0.3});
  CHECK(r.low_mm == Approx(3 - std::hypot(1, 2 - (cusp + 0.3))));
  CHECK(r.low_mm < *r.high_mm);
}

TEST_CASE("residuals at raw stock: a block's faces, edges and corners, a bar", "[unit][probe]") {
  const RemovedSpace block(model::BoxStock{{0, 0, 0}, {10, 10, 10}}, {});
  check_residual(block, {5, 5, 10.25}, 0.25);
  check_residual(block, {5, 5, 9.5}, -0.5);
  check_residual(block, {10.3, 5, 10.4}, 0.5);
  check_residual(block, {11, 12, 12}, 3);
  CHECK(block.is_stock(probe_residual(block, {5, 5, 10.25}).gap.body));
  const RemovedSpace bar(model::CylinderStock{{0, 0, 0}, 20, 30}, {});
  for (const double rho : {9.0, 9.999, 10.001, 12.0})
    check_residual(bar, {rho * 0.6, rho * 0.8, 12}, rho - 10);
  check_residual(bar, {6, 8, 31}, 1);
}

TEST_CASE("chords of arcs widen the interval by their error, on both sides", "[unit][probe]") {
  const RemovedSpace removed = RowStock("ball:D=6,L=20", {{0, -1}}, 0.004).removed();
  for (const double z : {-1.5, -1.002, -1.0, -0.99, -0.5}) {
    const ProbeResidual r = probe_residual(removed, {17, 0, z});
    REQUIRE(r.high_mm);
    CHECK(r.low_mm == Approx(z + 1 - 0.004).margin(1e-8));
    CHECK(*r.high_mm == Approx(z + 1 + 0.004).margin(1e-8));
  }
}

TEST_CASE("where nothing stands no high is said", "[unit][probe]") {
  std::vector<std::pair<double, double>> rows;
  for (double y = -20; y <= 20; y += 3) rows.emplace_back(y, -30);
  const RemovedSpace removed = RowStock("flat:D=8,L=60", rows).removed();
  const ProbeResidual r = probe_residual(removed, {20, 0, -5});
  CHECK(r.low_mm > 0);
  CHECK_FALSE(r.high_mm);
}

}  // namespace limitgauge::verifier
