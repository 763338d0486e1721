#include "tests/defects/surfaces/surfaces.h"

#include <cmath>
#include <filesystem>
#include <random>

#include "model/part/cage_obj.h"
#include "tests/support/cages.h"

namespace limitgauge::tests::defects {
namespace {

using model::BoundaryRule;
using model::Cage;
using model::Vec3;

Cage star(int valence, double scale) {
  return placed(star_cage(valence, 1), {scale, 20, {0, 0, 0}});
}

/// z = k·x·y: its control points lie on it.
Cage saddle(double half_mm, double k) {
  constexpr int kFaces = 4;
  return grid_cage(
      kFaces, kFaces,
      [=](int i, int j) {
        const double x = half_mm * (2.0 * i / kFaces - 1), y = half_mm * (2.0 * j / kFaces - 1);
        return Vec3{x, y, k * x * y};
      },
      BoundaryRule::edge_and_corner);
}

Cage waves(double half_mm, double height_mm) {
  constexpr int kFaces = 5;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> height(-height_mm, height_mm);
  return grid_cage(
      kFaces, kFaces,
      [&](int i, int j) {
        const double x = half_mm * (2.0 * i / kFaces - 1), y = half_mm * (2.0 * j / kFaces - 1);
        return Vec3{x, y, height(random)};
      },
      BoundaryRule::edge_only);
}

/// A roof: an infinitely sharp ridge, and a valley beside it that no rounded cutter gets to the
/// bottom of.
Cage roof(double half_mm) {
  constexpr int kFaces = 6;
  const double heights[kFaces + 1] = {-1.4, 0, 1.2, 0.1, -0.4, 0.2, 0.7};
  Cage cage = grid_cage(
      kFaces, kFaces,
      [&](int i, int j) {
        const double x = half_mm * (2.0 * i / kFaces - 1), y = half_mm * (2.0 * j / kFaces - 1);
        return Vec3{x, y, heights[i] + 0.01 * y * y};
      },
      BoundaryRule::edge_only);
  const auto crease = [&](int column) {
    for (int j = 0; j < kFaces; ++j) {
      const model::Index a = j * (kFaces + 1) + column;
      cage.creases.push_back({{a, a + kFaces + 1}, model::kInfiniteSharpness});
    }
  };
  crease(2);
  crease(4);
  return cage;
}

/// A pentagon as the top, ringed by quads.
Cage pentagon_hill(double radius_mm, double height_mm) {
  constexpr int kSides = 5, kRings = 3;
  Cage cage;
  for (int ring = 1; ring <= kRings; ++ring)
    for (int k = 0; k < kSides; ++k) {
      const double angle = 2 * std::numbers::pi * k / kSides, share = (ring - 0.4) / kRings;
      cage.vertices.push_back({radius_mm * share * std::cos(angle),
                               radius_mm * share * std::sin(angle),
                               height_mm * (1 - share * share) + 0.2 * std::sin(2 * angle + ring)});
    }
  cage.add_face(std::array<model::Index, kSides>{0, 1, 2, 3, 4});
  for (int ring = 0; ring + 1 < kRings; ++ring)
    for (int k = 0; k < kSides; ++k) {
      const model::Index a = ring * kSides + k, b = ring * kSides + (k + 1) % kSides;
      cage.add_face(std::array<model::Index, 4>{a, a + kSides, b + kSides, b});
    }
  cage.boundary = BoundaryRule::edge_and_corner;
  return cage;
}

Cage rounded_cube(double half_mm) {
  Cage cage = placed(cube_cage(), {half_mm, 15, {0, 0, 0}});
  cage.creases = {{{4, 5}, 1.5}, {{5, 7}, 1.5}, {{6, 7}, 0.7}, {{4, 6}, 0.7}};
  return cage;
}

Cage fixture(const std::string& folder, const char* name, double scale) {
  return placed(model::read_cage_obj(std::filesystem::path(folder) / "cages" / name),
                {scale, 0, {0, 0, 0}});
}

}  // namespace

std::vector<NamedCage> suite_surfaces(const std::string& fixtures) {
  return {{"slope", plane_cage(6, 0.4, 0.2)},
          {"dome", paraboloid_cage(6, -0.04)},
          {"bowl", paraboloid_cage(6, 0.03)},
          {"saddle", saddle(6, 0.05)},
          {"star of 3", star(3, 0.3)},
          {"star of 5", star(5, 0.3)},
          {"star of 7", star(7, 0.3)},
          {"waves", waves(6, 0.8)},
          {"roof with ridge and valley", roof(6)},
          {"pentagon hill", pentagon_hill(8, 2)},
          {"rounded cube", rounded_cube(6)},
          {"quick dome", fixture(fixtures, "quick-dome.obj", 0.65)}};
}

std::vector<model::Cutter> suite_cutters() {
  return {{"flat", model::CutterType::flat, 4, 0, 0, 30, {}, {}},
          {"ball", model::CutterType::ball, 5, 2.5, 0, 30, {}, {}},
          {"bull", model::CutterType::bull, 6, 1, 0, 30, {}, {}},
          {"taper", model::CutterType::taper, 3, 1, 8, 16, {}, {}}};
}

}  // namespace limitgauge::tests::defects
