#include "verifier/closest_point.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "engine/model/cage_obj.h"
#include "engine/model/error.h"
#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "verifier/distance_polynomial.h"
#include "verifier/reference_surface.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// An independent search, in long double: samples all pieces densely, then walks downhill from the
/// nearest samples by trying ever smaller steps in the parameters. Slow, and nothing in common with
/// what it checks but the control points.
class BruteForce {
 public:
  explicit BruteForce(const SurfaceTree& tree) : tree_(tree) {
    for (std::size_t n = 0; n < tree.pieces().size(); ++n) {
      const Piece& piece = tree.pieces()[n];
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
    const Bezier& b = tree_.pieces()[piece].shape;
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
  std::vector<Sample> samples_;
};

/// A cube whose edges and corners are sharp: all of them, or those of two opposite faces.
model::Cage creased_cube(bool all) {
  model::Cage cage = tests::cube_cage();
  for (int a = 0; a < 8; ++a)
    for (const int bit : {1, 2, 4})
      if ((a & bit) == 0 && (all || bit != 4)) cage.creases.push_back({{a, a | bit}, 10});
  return cage;
}

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

model::Cage scaled(model::Cage cage, double by) {
  for (Vec3& v : cage.vertices) v *= by;
  return cage;
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

std::optional<double> signed_at(const SurfaceCells& cells, const Vec3& p) {
  return signed_distance_mm(cells, p, *closest_point(cells, p, 1e6));
}

}  // namespace

TEST_CASE("nothing is nearer than the closest point: stars", "[property]") {
  for (const int valence : {3, 5, 8}) check_surface(tests::star_cage(valence, 4), 200, 7);
}

TEST_CASE("nothing is nearer than the closest point: bent grids", "[property]") {
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    check_surface(bent_grid(seed, 2, model::BoundaryRule::edge_only), 120, seed);
    check_surface(bent_grid(seed, 2, model::BoundaryRule::edge_and_corner), 120, seed);
  }
}

TEST_CASE("nothing is nearer than the closest point: cubes", "[property]") {
  for (const model::Cage& cage : {tests::cube_cage(), creased_cube(true), creased_cube(false)})
    check_surface(scaled(cage, 10), 180, 11);
}

// What the proof rests on: the coefficients bound half the squared distance and its second
// derivatives, in a window as in the whole.
TEST_CASE("the distance polynomial bounds the distance and its Hessian", "[property]") {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> off(-3, 3), part(0, 1);
  for (int n = 0; n < 100; ++n) {
    Bezier b;
    for (int k = 0; k < 16; ++k)
      b.set(k, {3.0 * (k % 4) + off(random), 3.0 * (k / 4) + off(random), off(random)});
    const Vec3 p{4 + off(random), 4 + off(random), 3 * off(random)};
    const double at = 0.1 + 0.8 * part(random);
    const DistancePolynomial f =
        split_v(split_u(distance_polynomial(b, p), at)[n % 2], 0.5)[n / 2 % 2];
    const HessianRange h = hessian_range(f);
    const double size_u = n % 2 == 0 ? at : 1 - at;
    for (int m = 0; m < 50; ++m) {
      const double u = (n % 2 == 0 ? 0 : at) + size_u * part(random),
                   v = (n / 2 % 2 + part(random)) / 2;
      const BezierJet j = jet(b, u, v);
      const Vec3 r = j.position - p;
      // Rounding of values below 1e4.
      const double slack = 1e-9;
      CHECK(f.low() <= length_squared(r) / 2 + slack);
      const double uu = (dot(j.du, j.du) + dot(r, j.duu)) * size_u * size_u,
                   uv = (dot(j.du, j.dv) + dot(r, j.duv)) * size_u / 2,
                   vv = (dot(j.dv, j.dv) + dot(r, j.dvv)) / 4;
      CHECK((h.uu_low <= uu + slack && uu <= h.uu_high + slack));
      CHECK((h.uv_low <= uv + slack && uv <= h.uv_high + slack));
      CHECK((h.vv_low <= vv + slack && vv <= h.vv_high + slack));
    }
  }
}

TEST_CASE("feet of perpendiculars are told from boundary points", "[unit]") {
  const ReferenceSurface surface(tests::plane_cage(10, 0, 0));
  const SurfaceCells cells(surface.tree(), 0.5);
  const auto over = closest_point(cells, {3.3, -2.2, 1.5}, 5);
  REQUIRE(over);
  CHECK(over->perpendicular);
  CHECK(over->feature == SurfaceFeature::smooth);
  CHECK(over->distance_mm == Approx(1.5));
  CHECK(distance(over->normal, {0, 0, 1}) < 1e-12);
  const auto beside = closest_point(cells, {13, 0.1, 4}, 10);
  REQUIRE(beside);
  CHECK_FALSE(beside->perpendicular);
  CHECK(beside->feature == SurfaceFeature::boundary);
  CHECK(beside->open);
  CHECK(beside->distance_mm == Approx(5));
  const auto off_corner = closest_point(cells, {13, 14, 12}, 20);
  REQUIRE(off_corner);
  CHECK(off_corner->feature == SurfaceFeature::corner);
  CHECK(off_corner->open);
  CHECK(off_corner->distance_mm == Approx(13));
  CHECK_FALSE(closest_point(cells, {13, 0, 4}, 4.9));
}

TEST_CASE("distance to a paraboloid along its normal", "[unit]") {
  const double k = 0.02;
  const ReferenceSurface surface(tests::paraboloid_cage(20, k));
  const SurfaceCells cells(surface.tree(), 0.5);
  for (const double x : {0.0, 3.0, 7.7, 15.0})
    for (const double off : {-2.0, -0.01, 0.01, 5.0}) {
      const Vec3 s{x, 1.0, k * (x * x + 1)}, n = normalized(Vec3{-2 * k * x, -2 * k, 1});
      const auto found = closest_point(cells, s + n * off, 20);
      REQUIRE(found);
      CAPTURE(x, off);
      CHECK(found->distance_mm == Approx(std::abs(off)).margin(1e-11));
      CHECK(distance(found->place.point, s) < 1e-9);
    }
}

// Where the query stands nearer than the centres of curvature and the rest of the part, the foot is
// known. Distances are level about a foot: next to the end of a cell they do not tell its place to
// better than 1e-8 mm.
TEST_CASE("places are exact beside the ends of cells, vertices and boundaries too", "[property]") {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> part(0, 1);
  for (const model::Cage& cage :
       {tests::star_cage(3, 1), tests::star_cage(5, 1), tests::star_cage(8, 1),
        tests::paraboloid_cage(20, 0.02), scaled(creased_cube(true), 10)}) {
    const ReferenceSurface surface(cage);
    const SurfaceCells cells(surface.tree(), 2);
    for (int n = 0; n < 300; ++n) {
      const int patch = static_cast<int>(random() % static_cast<unsigned>(surface.patch_count()));
      if (!surface.has_surface(patch)) continue;
      const auto parameter = [&] {
        const double at = static_cast<double>(random() % 5) / 4;  // an end of a cell
        const double beside = std::pow(10.0, -12 * part(random));
        return std::clamp(n % 3 == 0 ? part(random) : at + (at < 1 ? beside : -beside), 0.0, 1.0);
      };
      const double u = parameter(), v = parameter();
      // Pieces so near to a vertex are too small for their normals to be known from coordinates.
      const double off_u = std::min(u, 1 - u), off_v = std::min(v, 1 - v);
      if (std::max(off_u, off_v) < 1e-6 && off_u + off_v > 0) continue;
      const SurfaceSample s = surface.evaluate(patch, u, v);
      // The curvature of the stars grows without bound towards their vertices, slowly.
      const double off = 0.01 * part(random);
      CAPTURE(patch, n, off, s.position.x, s.position.y, s.position.z);
      const auto found = closest_point(cells, s.position + s.normal * off, 10);
      REQUIRE(found);
      CHECK(distance(found->place.point, s.position) < 1e-9);
      CHECK(std::abs(found->distance_mm - off) < 1e-9);
      const Vec3 to = s.position + s.normal * off - found->place.point;
      CHECK(length(cross(to, s.normal)) < 1e-9);
    }
  }
}

// On the axis of z = k·r², from the centre of curvature 1/(2k) upwards, the feet are a circle at
// height z − 1/(2k), √(z/k − 1/(4k²)) away. At the centre itself the distance is level to the
// fourth order.
TEST_CASE("a query at and beyond a centre of curvature gets the distance", "[unit]") {
  const double k = 0.05;
  const ReferenceSurface surface(tests::paraboloid_cage(20, k));
  const SurfaceCells cells(surface.tree(), 0.5);
  for (const double above : {0.0, 1e-9, 1e-6, 1e-3, 0.1, 3.0}) {
    const double z = 1 / (2 * k) + above;
    const auto found = closest_point(cells, {0, 0, z}, 100);
    REQUIRE(found);
    CAPTURE(above);
    CHECK(std::abs(found->distance_mm - std::sqrt(z / k - 1 / (4 * k * k))) < 1e-9);
  }
}

TEST_CASE("two feet in one cell are both found", "[unit]") {
  // A trough z = k·x² seen from near its axis, high up: a foot on either side of the middle.
  const double k = 0.05, h = 10;
  const model::Cage cage = tests::grid_cage(
      4, 4,
      [=](int i, int j) {
        const double a = i - 1.5, b = j - 1.5;
        return Vec3{a * h, b * h, k * h * h * (a * a - 1.0 / 3)};
      },
      model::BoundaryRule::none);
  const ReferenceSurface surface(cage);
  const SurfaceCells cells(surface.tree(), 20);
  for (const double aside : {-1e-3, -1e-7, 1e-7, 1e-3}) {
    const auto found = closest_point(cells, {aside, 0.3, 10.5}, 100);
    REQUIRE(found);
    CAPTURE(aside);
    CHECK(found->place.point.x * aside > 0);
    CHECK(std::abs(found->place.point.y - 0.3) < 1e-9);
  }
}

TEST_CASE("features of a cube by its sharpness", "[unit]") {
  const ReferenceSurface sharp(creased_cube(true)), lids(creased_cube(false)),
      smooth(tests::cube_cage());
  const SurfaceCells sharp_cells(sharp.tree(), 1), lid_cells(lids.tree(), 1),
      smooth_cells(smooth.tree(), 1);
  const auto at = [](const SurfaceCells& cells, const Vec3& p) {
    const auto found = closest_point(cells, p, 100);
    REQUIRE(found);
    CHECK_FALSE(found->open);
    return *found;
  };
  CHECK(at(sharp_cells, {2, 0.1, 0.2}).feature == SurfaceFeature::smooth);
  const ClosestPoint edge = at(sharp_cells, {3, 3, 0.2});
  CHECK(edge.feature == SurfaceFeature::crease);
  CHECK_FALSE(edge.perpendicular);
  CHECK(edge.distance_mm == Approx(std::sqrt(8.0)));
  CHECK(at(sharp_cells, {3, 3, 4}).feature == SurfaceFeature::corner);
  CHECK(at(smooth_cells, {3, 3, 3}).feature == SurfaceFeature::extraordinary_vertex);
  CHECK(at(smooth_cells, {3, 3, 3}).perpendicular);
  CHECK(at(smooth_cells, {3, 1, 0.5}).feature == SurfaceFeature::smooth);
  CHECK(at(lid_cells, {0, 3, 3}).feature == SurfaceFeature::crease);
  CHECK(at(lid_cells, {1.2, 1.2, 3}).feature == SurfaceFeature::crease);
}

TEST_CASE("the end of a crease in smooth surface is a dart; semi-sharp is smooth", "[unit]") {
  model::Cage cage = tests::plane_cage(10, 0, 0);
  cage.creases = {{{11, 12}, 10}, {{12, 13}, 2}};
  const ReferenceSurface surface(cage);
  const SurfaceCells cells(surface.tree(), 1);
  const auto feature = [&](const Vec3& p) { return closest_point(cells, p, 100)->feature; };
  CHECK(feature({0, 0, 1}) == SurfaceFeature::dart);
  CHECK(feature({-2, 0, 1}) == SurfaceFeature::crease);
  CHECK(feature({-2, 1e-3, 1}) == SurfaceFeature::smooth);
  CHECK(feature({2, 0, 1}) == SurfaceFeature::smooth);
}

TEST_CASE("holes and polygons carry their features to their patches", "[unit]") {
  model::Cage cage = tests::plane_cage(10, 0, 0);
  cage.holes = {5};  // [−5, 0]²
  const ReferenceSurface surface(cage);
  const SurfaceCells cells(surface.tree(), 1);
  const auto rim = closest_point(cells, {-1, -2.5, 1}, 100);
  REQUIRE(rim);
  CHECK(rim->feature == SurfaceFeature::boundary);
  CHECK(rim->distance_mm == Approx(std::sqrt(2.0)));
  model::Cage pentagon;
  for (int k = 0; k < 5; ++k)
    pentagon.vertices.push_back({std::cos(1.2566 * k), std::sin(1.2566 * k), 0});
  pentagon.add_face(std::array<model::Index, 5>{0, 1, 2, 3, 4});
  const ReferenceSurface plate(pentagon);
  const SurfaceCells plate_cells(plate.tree(), 1);
  const auto centre =
      closest_point(plate_cells, plate.evaluate(0, 1, 1).position + Vec3{0, 0, 1}, 9);
  REQUIRE(centre);
  CHECK(centre->feature == SurfaceFeature::extraordinary_vertex);
  CHECK(closest_point(plate_cells, {9, 1, 0}, 20)->feature == SurfaceFeature::boundary);
}

TEST_CASE("signed distances: outside positive, inside negative, beyond a boundary none", "[unit]") {
  const ReferenceSurface cube(creased_cube(true));
  const SurfaceCells cells(cube.tree(), 1);
  // The cube [−1, 1]³ in closed form.
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(-3, 3);
  for (int n = 0; n < 300; ++n) {
    const Vec3 p{part(random), part(random), part(random)};
    const double x = std::abs(p.x) - 1, y = std::abs(p.y) - 1, z = std::abs(p.z) - 1;
    const double outside = std::hypot(std::max(x, 0.0), std::max(y, 0.0), std::max(z, 0.0));
    const double expected = outside > 0 ? outside : std::max({x, y, z});
    const auto found = signed_at(cells, p);
    REQUIRE(found);
    CAPTURE(p.x, p.y, p.z);
    CHECK(std::abs(*found - expected) < 1e-9);
  }
  const ReferenceSurface plane(tests::plane_cage(10, 0, 0));
  const SurfaceCells plane_cells(plane.tree(), 1);
  CHECK(signed_at(plane_cells, {1, 1, -2}).value() == Approx(-2));
  CHECK(signed_at(plane_cells, {10, 1, 2}).value() == Approx(2));
  CHECK_FALSE(signed_at(plane_cells, {12, 1, 2}).has_value());
}

// A rounded lens: two bulging lids joined in one sharp rim. From beyond the rim both normals lean
// away from the query, and either alone may give the wrong side.
TEST_CASE("the side at a crease does not depend on the patch that was found", "[property]") {
  const ReferenceSurface surface(scaled(creased_cube(false), 10));
  const SurfaceCells cells(surface.tree(), 2);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(0, 1);
  for (int n = 0; n < 300; ++n) {
    const double turn = 6.2831853 * part(random), rise = 1.4 * (2 * part(random) - 1);
    const Vec3 away{std::cos(turn) * std::cos(rise), std::sin(turn) * std::cos(rise),
                    std::sin(rise)};
    CHECK(signed_at(cells, away * (20 + 30 * part(random))).value() > 0);
    CHECK(signed_at(cells, away * (3 * part(random))).value() < 0);
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

TEST_CASE("nothing is nearer than the closest point: cages from outside", "[slow]") {
  const char* folder = std::getenv("LIMITGAUGE_CAGES");
  if (folder == nullptr) return;
  for (const char* file : {"catmark_torus.obj", "parabolic_cylinder.obj", "catmark_helmet.obj",
                           "catmark_pawn.obj", "catmark_dart_edgecorner.obj", "sharp_box.obj"}) {
    const auto path = std::filesystem::path(folder) / file;
    if (std::filesystem::exists(path)) check_surface(model::read_cage_obj(path), 100, 13);
  }
}

}  // namespace limitgauge::verifier
