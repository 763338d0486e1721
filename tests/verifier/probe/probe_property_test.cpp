// Certified residuals against brute force that knows of nothing but balls at places.
#include <cmath>
#include <random>

#include "tests/support/catch.h"
#include "tests/verifier/probe/probe_stocks.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// A ball cutter of 3 mm radius, as a ball with an upright bar of the same radius on it, at places
/// 2 µm apart along its moves: it removes less than the moves do, by no more than 1e-6 mm.
struct BruteBalls {
  static constexpr double kRadius_mm = 3, kStep_mm = 2e-3, kLess_mm = 1e-6;

  explicit BruteBalls(const RowStock& stock) : block(stock.block), moves(stock.passes[0].path) {}

  double depth(const Vec3& tip, const Vec3& q) const {
    const double rho = model::level_distance(tip, q), up = q.z - tip.z - kRadius_mm;
    return kRadius_mm - (up >= 0 ? rho : std::hypot(rho, up));
  }

  bool is_in_block(const Vec3& q) const {
    return model::Box3{block.corner_mm, block.corner_mm + block.size_mm}.contains(q);
  }

  /// Whether a place stands; `q` counts as standing within kLess_mm of what was swept.
  bool stands(const Vec3& q, double wanted_mm) const {
    if (!is_in_block(q)) return false;
    for (std::size_t i = 0; i < moves->moves.size(); ++i) {
      const Vec3 &a = model::move_from(*moves, i), &b = moves->moves[i].to;
      const double length = distance(a, b);
      // Only places near to q can hold it.
      const double at = length > 0 ? dot(q - a, b - a) / length : 0;
      for (double s = std::max(0.0, at - 4); s <= std::min(length, at + 4); s += kStep_mm)
        if (depth(length > 0 ? lerp(a, b, s / length) : a, q) > wanted_mm) return false;
    }
    return true;
  }

  model::BoxStock block;
  std::shared_ptr<const model::Toolpath> moves;
};

RowStock slanted_rows(std::mt19937& random) {
  std::uniform_real_distribution<double> part(0, 1);
  RowStock stock("ball:D=6,L=60", {{-8, -1}});
  auto path = std::make_shared<model::Toolpath>();
  path->start = {-10, -8, 20};
  for (int k = 0; k < 7; ++k) {
    const double y = -9 + 3 * k;
    path->moves.push_back({{-8, y, -3 * part(random)}, 500, 1, model::MoveKind::feed});
    path->moves.push_back(
        {{48, y + 2 * part(random), -3 * part(random)}, 500, 2, model::MoveKind::feed});
  }
  stock.passes[0].path = path;
  return stock;
}

Vec3 direction(std::mt19937& random) {
  std::normal_distribution<double> part;
  return normalized(Vec3{part(random), part(random), part(random)});
}

}  // namespace

TEST_CASE("intervals hold what dense samples of the cut find", "[property][probe]") {
  std::mt19937 random(41);
  std::uniform_real_distribution<double> part(0, 1);
  int in_air = 0, in_material = 0, narrow = 0;
  for (int stock_number = 0; stock_number < 4; ++stock_number) {
    const RowStock stock = slanted_rows(random);
    const RemovedSpace removed = stock.removed();
    const BruteBalls brute(stock);
    for (int n = 0; n < 25; ++n) {
      const Vec3 p{1 + 38 * part(random), -9 + 18 * part(random), -4 + 4.5 * part(random)};
      const ProbeResidual r = probe_residual(removed, p);
      REQUIRE(r.high_mm);
      CHECK(r.low_mm <= *r.high_mm);
      INFO(p.x << " " << p.y << " " << p.z << ": " << r.low_mm << " to " << *r.high_mm);
      // What is nearer than the interval says is all of one kind.
      const bool air = r.low_mm > 0;
      const double sure = air ? r.low_mm : std::max(0.0, -*r.high_mm);
      for (int k = 0; k < 8; ++k) {
        const Vec3 q = p + direction(random) * (sure * std::cbrt(part(random)));
        CHECK(brute.stands(q, air ? -BruteBalls::kLess_mm : BruteBalls::kLess_mm) != air);
      }
      air ? ++in_air : ++in_material;
      if (air) {
        // No sample that stands is nearer than the low end; most often none is than the high end.
        double nearest = 1e9;
        for (int k = 0; k < 60; ++k) {
          const double reach = *r.high_mm * 1.2;
          const Vec3 q = p + direction(random) * (reach * std::cbrt(part(random)));
          if (distance(p, q) < nearest && brute.stands(q, BruteBalls::kLess_mm))
            nearest = distance(p, q);
        }
        CHECK(nearest >= r.low_mm);
        narrow += nearest >= *r.high_mm - 1e-6 ? 1 : 0;
      } else {
        // The other end of the exact distance is the other kind.
        const Vec3 q = p + r.gap.normal * (-r.low_mm + 2e-6);
        CHECK_FALSE(brute.stands(q, 0));
      }
    }
  }
  CHECK(in_air > 20);
  CHECK(in_material > 20);
  // The search for the high end is local; here it found the nearest place for all.
  CHECK(narrow >= in_air * 95 / 100);
}

}  // namespace limitgauge::verifier
