// The reference surface's rules against OpenSubdiv's own: uniform refinement and limit masks of
// its Far layer, in double precision, as the witness of every run asks them.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/feature_cages.h"
#include "tests/verifier/limit_samples.h"
#include "verifier/surface/reference_surface.h"
#include "witness/bounds.h"
#include "witness/limit_points.h"

namespace limitgauge {
namespace {

using model::Cage;
using model::Vec3;
using witness::LimitPoint;
using witness::LimitPoints;

/// Agreement asked for, as a part of the cage's size: both sides work in double precision with a
/// few thousand roundings at most.
constexpr double kExact = 1e-12;

/// OpenSubdiv keeps sharpness in single precision; the cage has the same numbers then.
Cage in_single_precision(Cage cage) {
  for (auto& c : cage.creases) c.sharpness = witness::in_single_precision(c.sharpness);
  for (auto& c : cage.corners) c.sharpness = witness::in_single_precision(c.sharpness);
  return cage;
}

/// Every vertex is asked for, however its limit is found.
LimitPoints points_of(const Cage& cage, int levels) {
  return witness::limit_points(cage, {levels, std::numeric_limits<std::size_t>::max()});
}

struct Comparison {
  tests::ErrorTable errors;
  int points_without_mask = 0;
};

Comparison compared(const Cage& cage, int levels) {
  const LimitPoints found = points_of(cage, levels);
  const verifier::ReferenceSurface surface(cage);
  const tests::CornerKinds kinds(cage);
  REQUIRE(static_cast<int>(found.has_surface.size()) == surface.patch_count());
  for (int patch = 0; patch < surface.patch_count(); ++patch) {
    CAPTURE(cage.name, patch);
    REQUIRE(surface.has_surface(patch) == found.has_surface[patch]);
  }
  CHECK(found.left_out == 0);
  Comparison comparison;
  for (const LimitPoint& p : found.points) {
    comparison.errors.add(
        kinds.nearest(p.patch, p.u, p.v),
        distance(surface.evaluate(p.patch, p.u, p.v).position, p.position) / tests::size_of(cage));
    if (!p.by_mask) ++comparison.points_without_mask;
  }
  return comparison;
}

/// Levels that use up the sharpness, and two more, so that no limit is taken where a rule changes.
int levels_for(const Cage& cage) {
  const int least = cage.face_count() > 100 ? 3 : 4;  // the larger ones have valences over 34
  return std::max(least, tests::levels_of_sharpness(cage) + 2);
}

bool is_eighths(double s) {
  return std::floor(8 * s) == 8 * s;
}

/// Where a corner and creases run out together, OpenSubdiv blends two rules by the mean of their
/// sharpness, in single precision. The mean of the fractions used here is exact if they are
/// eighths.
bool rounds_blends(const Cage& cage) {
  const auto finite = [](double s) { return s > 0 && s < model::kInfiniteSharpness; };
  for (const auto& corner : cage.corners)
    for (const auto& crease : cage.creases) {
      const auto [a, b] = crease.vertices;
      if ((a == corner.vertex || b == corner.vertex) && finite(corner.sharpness) &&
          finite(crease.sharpness) &&
          !(is_eighths(corner.sharpness) && is_eighths(crease.sharpness)))
        return true;
    }
  return false;
}
/// A rounding of the blend (2^-24) of points closer than the cage is large.
constexpr double kRoundedBlend = 1e-7;

/// A corner and creases that run out in one step, with a mean that single precision holds.
std::vector<Cage> blended_cages() {
  Cage three = tests::cube_cage();
  three.name = "corner and two creases run out together";
  three.vertices[7] = {1.3, 0.9, 1.2};  // off symmetry
  three.creases = {{{4, 5}, 1.125}, {{4, 6}, 1.125}, {{7, 3}, 0.25}};
  three.corners = {{4, 1.5}, {7, 0.75}};
  Cage two = tests::sharp_star(5, 2.25, {0}, 2.75);
  two.name = "corner and one crease run out together";
  return {three, two};
}

/// A crease that runs out through vertices of valence two, beside which two faces of a star have one
/// opposite corner.
Cage creased_pillow() {
  Cage cage = tests::cube_cage();
  cage.name = "crease running out in valence 2";
  cage.vertices = {{0, 0, 0}, {9, 1, 0}, {8, 10, 2}, {-1, 9, 1}};
  cage.face_corners.clear(), cage.face_offsets = {0};
  cage.add_face(std::array<model::Index, 4>{0, 1, 2, 3});
  cage.add_face(std::array<model::Index, 4>{3, 2, 1, 0});
  cage.creases = {{{0, 1}, 4.5}, {{1, 2}, 4.5}, {{2, 3}, 1.25}};
  return cage;
}

/// Holes beside a boundary, beside a crease, and of a face of five corners.
std::vector<Cage> holed_cages() {
  std::vector<Cage> all;
  for (const auto rule : {model::BoundaryRule::none, model::BoundaryRule::edge_only,
                          model::BoundaryRule::edge_and_corner}) {
    Cage grid = tests::grid_cage(
        5, 5,
        [](int i, int j) {
          return Vec3{8.0 * i, 9.0 * j, 3.0 * ((i * 7 + j * 5) % 4)};
        },
        rule);
    grid.name = "grid with holes";
    grid.holes = {0, 7, 12};
    grid.creases = {{{14, 15}, 10}, {{15, 16}, 1.5}};
    all.push_back(grid);
  }
  Cage prism = tests::prism(5);
  prism.name = "prism with a hole";
  prism.holes = {0, 3};
  all.push_back(prism);
  return all;
}

std::vector<Cage> all_cages() {
  std::vector<Cage> all = tests::feature_cages();
  for (Cage& cage : holed_cages()) all.push_back(std::move(cage));
  for (Cage& cage : blended_cages()) all.push_back(std::move(cage));
  all.push_back(creased_pillow());
  for (Cage& cage : all) cage = in_single_precision(std::move(cage));
  return all;
}

}  // namespace

TEST_CASE("OpenSubdiv's faces are traced to their parameters", "[property]") {
  // A flat grid of unit squares with sharp corners is its own limit: x and y are the parameters.
  const int n = 3;
  const Cage cage = tests::grid_cage(
      n, n,
      [](int i, int j) {
        return Vec3{1.0 * i, 1.0 * j, 0};
      },
      model::BoundaryRule::edge_and_corner);
  const LimitPoints found = points_of(cage, 3);
  CHECK(found.points.size() == n * n * 81);
  for (const LimitPoint& p : found.points) {
    const Vec3 expected{p.patch % n + p.u, p.patch / n + p.v, 0};
    CHECK(distance(p.position, expected) < 1e-14);
  }
}

TEST_CASE("every kind of vertex agrees with OpenSubdiv's refinement", "[slow]") {
  tests::ErrorTable exact, rounded;
  int points_without_mask = 0;
  for (const Cage& cage : all_cages()) {
    const Comparison own = compared(cage, levels_for(cage));
    CAPTURE(cage.name, own.errors.text());
    CHECK(own.errors.worst() < (rounds_blends(cage) ? kRoundedBlend : kExact));
    (rounds_blends(cage) ? rounded : exact).add(own.errors);
    points_without_mask += own.points_without_mask;
  }
  // The cages are there for their kinds of vertices: all of them must have been met.
  for (const char* kind :
       {"regular", "regular boundary", "interior, valence 02", "interior, valence 03",
        "interior, valence 08", "interior, valence 50", "boundary, faces 01", "boundary, faces 20",
        "crease, valence 03", "crease, valence 50", "dart, valence 03", "dart, valence 50",
        "corner", "semi-sharp", "n-gon centre, corners 3", "n-gon centre, corners 5",
        "n-gon centre, corners 6"})
    CHECK(exact.rows.contains(kind));
  CHECK(points_without_mask > 100);
  if (std::getenv("LIMITGAUGE_TABLES") != nullptr)
    WARN("exact\n"
         << exact.text() << "blends rounded to single precision\n"
         << rounded.text() << points_without_mask << " points without an exact limit mask");
}

TEST_CASE("sharpness that one refinement leaves is used up in stars", "[property]") {
  tests::ErrorTable exact;
  for (const Cage& cage : all_cages()) {
    if (tests::levels_of_sharpness(cage) < 2) continue;
    const Comparison own = compared(cage, 1);
    CAPTURE(cage.name, own.errors.text());
    CHECK(own.errors.worst() < (rounds_blends(cage) ? kRoundedBlend : kExact));
    exact.add(own.errors);
  }
  CHECK(exact.rows.contains("semi-sharp"));
}

}  // namespace limitgauge
