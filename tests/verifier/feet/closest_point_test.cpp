#include "verifier/feet/closest_point.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "model/base/error.h"
#include "model/part/cage_obj.h"
#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// An independent search, in long double: samples all pieces densely, then walks downhill from the
/// nearest samples by trying ever smaller steps in the parameters. Slow, and nothing in common with
/// what it checks but the control points.
class BruteForce {
 public:
  explicit BruteForce(const SurfaceTree& tree) : tree_(tree) {
    for (int patch = 0; patch < tree.patch_count(); ++patch)
      for (const Piece& piece : tree.pieces_of(patch)) pieces_.push_back(piece);
    for (std::size_t n = 0; n < pieces_.size(); ++n) {
      const Piece& piece = pieces_[n];
      if (piece.square.size < 1.0 / 512) continue;
      const int steps = piece.square.size > 0.1 ? 16 : 4;
      for (int j = 0; j <= steps; ++j)
        for (int i = 0; i <= steps; ++i)
          samples_.push_back(
              {n, static_cast<Real>(i) / steps, static_cast<Real>(j) / steps,
               point(piece.shape, static_cast<double>(i) / steps, static_cast<double>(j) / steps)});
    }
  }

  double distance_mm(const Vec3& p) const {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t n = 0; n < samples_.size(); ++n)
      order.emplace_back(length_squared(samples_[n].position - p), n);
    constexpr std::size_t kStarts = 12;
    std::partial_sort(order.begin(), order.begin() + kStarts, order.end());
    Real best = order.front().first;
    for (std::size_t k = 0; k < kStarts; ++k)
      best = std::min(best, descend(samples_[order[k].second], p));
    for (const Speck& s : tree_.specks())
      best = std::min(best, static_cast<Real>(length_squared(s.position - p)));
    return static_cast<double>(std::sqrt(best));
  }

 private:
  using Real = long double;
  struct Sample {
    std::size_t piece;
    Real u, v;
    Vec3 position;
  };

  static Real cubic(Real a, Real b, Real c, Real d, Real t) {
    const Real s = 1 - t;
    return s * s * (s * a + 3 * t * b) + t * t * (3 * s * c + t * d);
  }
  static Real square_of(const std::array<double, 16>& c, double p, Real u, Real v) {
    std::array<Real, 4> row;
    for (int j = 0; j < 4; ++j)
      row[j] = cubic(c[4 * j], c[4 * j + 1], c[4 * j + 2], c[4 * j + 3], u);
    const Real d = cubic(row[0], row[1], row[2], row[3], v) - p;
    return d * d;
  }
  Real squared(std::size_t piece, const Vec3& p, Real u, Real v) const {
    const Bezier& b = pieces_[piece].shape;
    return square_of(b.x, p.x, u, v) + square_of(b.y, p.y, u, v) + square_of(b.z, p.z, u, v);
  }

  Real descend(const Sample& start, const Vec3& p) const {
    Real u = start.u, v = start.v, best = squared(start.piece, p, u, v);
    for (Real step = 0.125L; step > 1e-9L;) {
      bool better = false;
      for (int k = 0; k < 8; ++k) {
        constexpr int kU[] = {1, 1, 0, -1, -1, -1, 0, 1}, kV[] = {0, 1, 1, 1, 0, -1, -1, -1};
        const Real u1 = std::clamp<Real>(u + kU[k] * step, 0, 1),
                   v1 = std::clamp<Real>(v + kV[k] * step, 0, 1);
        const Real there = squared(start.piece, p, u1, v1);
        if (there < best) best = there, u = u1, v = v1, better = true;
      }
      if (!better) step /= 2;
    }
    return best;
  }

  const SurfaceTree& tree_;
  std::vector<Piece> pieces_;
  std::vector<Sample> samples_;
};

/// Vertices moved at random, so that cells bend strongly and feet are many.
model::Cage bent_grid(unsigned seed, double by_mm, model::BoundaryRule rule) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> off(-by_mm, by_mm);
  return tests::grid_cage(
      4, 4,
      [&](int i, int j) {
        return Vec3{5.0 * i + off(random), 5.0 * j + off(random), 2 * off(random)};
      },
      rule);
}

/// Queries of all kinds: anywhere about the part, near to it, on it, and as far as 20 mm along its
/// normals, where centres of curvature lie.
std::vector<Vec3> queries(const ReferenceSurface& surface, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(0, 1), side(-1, 1);
  const model::Box3 box = surface.bounding_box().grown(5);
  std::vector<Vec3> out;
  while (static_cast<int>(out.size()) < count) {
    const int patch = static_cast<int>(random() % static_cast<unsigned>(surface.patch_count()));
    if (!surface.has_surface(patch)) continue;
    const SurfaceSample s = surface.evaluate(patch, part(random), part(random));
    switch (out.size() % 4) {
      case 0:
        out.push_back(box.low + Vec3{part(random) * box.size().x, part(random) * box.size().y,
                                     part(random) * box.size().z});
        break;
      case 1:
        out.push_back(s.position + s.normal * (0.5 * side(random)));
        break;
      case 2:
        out.push_back(s.position);
        break;
      default:
        out.push_back(s.position + s.normal * (20 * side(random)));
    }
  }
  return out;
}

/// What must hold of every answer: it is on S, as far away as it says, and nothing is nearer. How
/// much nearer the search by brute force came, in mm; below zero where it did not come so near.
double check_query(const ReferenceSurface& surface, const SurfaceCells& cells,
                   const BruteForce& brute, const Vec3& p) {
  const auto found = closest_point(cells, p, 1e6);
  REQUIRE(found);
  const SurfaceSample s = surface.evaluate(found->place.patch, found->place.u, found->place.v);
  CHECK(distance(s.position, found->place.point) < 1e-9);
  CHECK(std::abs(distance(p, found->place.point) - found->distance_mm) < 1e-12);
  if (found->feature == SurfaceFeature::smooth) CHECK(found->perpendicular);
  return found->distance_mm - brute.distance_mm(p);
}

void check_surface(const model::Cage& cage, int count, unsigned seed) {
  const ReferenceSurface surface(cage);
  const SurfaceCells cells(surface.tree(), 2);
  const BruteForce brute(surface.tree());
  double worst = -1;
  for (const Vec3& p : queries(surface, count, seed)) {
    CAPTURE(p.x, p.y, p.z);
    const double nearer = check_query(surface, cells, brute, p);
    CHECK(nearer <= 1e-9);
    worst = std::max(worst, nearer);
  }
  INFO("brute force is nearer by at most " << worst << " mm");
  CHECK(worst <= 1e-9);
}

}  // namespace

TEST_CASE("nothing is nearer than the closest point: stars", "[slow]") {
  for (const int valence : {3, 5, 8}) check_surface(tests::star_cage(valence, 4), 200, 7);
}

TEST_CASE("nothing is nearer than the closest point: bent grids", "[property]") {
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    check_surface(bent_grid(seed, 2, model::BoundaryRule::edge_only), 120, seed);
    check_surface(bent_grid(seed, 2, model::BoundaryRule::edge_and_corner), 120, seed);
  }
}

TEST_CASE("nothing is nearer than the closest point: cubes", "[property]") {
  for (const model::Cage& cage :
       {tests::cube_cage(), tests::sharp_cube(true), tests::sharp_cube(false)})
    check_surface(tests::scaled(cage, 10), 180, 11);
}

TEST_CASE("nothing is nearer than the closest point: cages from outside", "[slow]") {
  const char* folder = std::getenv("LIMITGAUGE_CAGES");
  if (folder == nullptr) return;
  for (const char* file : {"catmark_torus.obj", "parabolic_cylinder.obj", "catmark_helmet.obj",
                           "catmark_pawn.obj", "catmark_dart_edgecorner.obj", "sharp_box.obj"}) {
    const auto path = std::filesystem::path(folder) / file;
    if (std::filesystem::exists(path)) check_surface(model::read_cage_obj(path), 100, 13);
  }
}

TEST_CASE("batches equal single queries for any number of threads", "[property]") {
  const ReferenceSurface surface(tests::star_cage(5, 4));
  const SurfaceCells cells(surface.tree(), 2);
  const std::vector<Vec3> points = queries(surface, 1500, 9);
  for (const unsigned threads : {1U, 2U, 5U}) {
    const auto batch = closest_points(cells, points, 12, {threads, nullptr, {}});
    REQUIRE(batch.size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto single = closest_point(cells, points[i], 12);
      REQUIRE(batch[i].has_value() == single.has_value());
      if (!single) continue;
      CHECK(batch[i]->place.point == single->place.point);
      CHECK(batch[i]->distance_mm == single->distance_mm);
      CHECK(batch[i]->feature == single->feature);
    }
  }
  const std::atomic<bool> stop{true};
  CHECK_THROWS_AS(closest_points(cells, points, 12, {2, &stop, {}}), model::Interrupted);
}

}  // namespace limitgauge::verifier
