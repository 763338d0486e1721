// The chord error of limit meshes and of offset meshes as it is, measured between nodes through the
// verifier's evaluator and its closest points, beside the bound that the engine states for them.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <vector>

#include "engine/surface/offset_model.h"
#include "model/part/cage_obj.h"
#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/feature_cages.h"
#include "tests/support/folders.h"
#include "verifier/cells/surface_cells.h"
#include "verifier/feet/closest_point.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge {
namespace {

using engine::surface::Grid;
using engine::surface::OffsetModel;
using engine::surface::PatchModel;
using model::Cage;
using model::Vec3;

/// Both evaluators work in double precision on coordinates below 100 mm.
constexpr double kRounding_mm = 1e-9;

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double square = length_squared(b - a);
  const double t = square > 0 ? std::clamp(dot(p - a, b - a) / square, 0.0, 1.0) : 0.0;
  return distance(p, a + (b - a) * t);
}

double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = cross(b - a, c - a);
  const double square = length_squared(n);
  const auto inside = [&](const Vec3& from, const Vec3& to) {
    return dot(cross(to - from, p - from), n) >= 0;
  };
  if (square > 0 && inside(a, b) && inside(b, c) && inside(c, a))
    return std::abs(dot(p - a, n)) / std::sqrt(square);
  return std::min(
      {distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

/// Distance from the triangles of the cells of `grid` from (u0, v0) to (u1, v1).
double distance_to_cells(const Vec3& p, const Grid& grid, int u0, int v0, int u1, int v1) {
  double least = std::numeric_limits<double>::infinity();
  for (int v = std::max(0, v0); v <= std::min(grid.rows - 2, v1); ++v)
    for (int u = std::max(0, u0); u <= std::min(grid.columns - 2, u1); ++u) {
      const Vec3 a = grid.at(u, v), b = grid.at(u + 1, v), c = grid.at(u + 1, v + 1),
                 d = grid.at(u, v + 1);
      least = std::min({least, distance_to_triangle(p, a, b, c), distance_to_triangle(p, a, c, d)});
    }
  return least;
}

/// A mesh of all patches; corners and specks lie over the grids where it is moved out.
class MeshDistance {
 public:
  MeshDistance(const PatchModel& model, const OffsetModel& mesh, double offset_mm)
      : model_(model), mesh_(mesh), offset_mm_(offset_mm) {
    for (const auto* grids : {&mesh.corners, &mesh.grids})
      for (const Grid& grid : *grids) {
        all_.push_back({&grid, {}});
        for (const Vec3& p : grid.points) all_.back().box.add(p);
      }
  }

  /// Not above `enough` if some part of the mesh is that near: the places at hand come first.
  double operator()(int patch, double u, double v, const Vec3& p, double enough) const {
    constexpr int kNear = 2;
    const Grid& grid = mesh_.grids[patch];
    const int n = grid.columns - 1, i = std::min(n - 1, static_cast<int>(u * n)),
              j = std::min(n - 1, static_cast<int>(v * n));
    double least = distance_to_cells(p, grid, i - kNear, j - kNear, i + kNear, j + kNear);
    if (least <= enough) return least;
    for (const auto& of : model_.patches())
      for (const Vec3& speck : of.specks)
        least = std::min(least, std::abs(distance(p, speck) - offset_mm_));
    for (const Boxed& other : all_) {
      if (least <= enough) return least;
      if (distance_squared(other.box, p) < least * least)
        least = std::min(
            least, distance_to_cells(p, *other.grid, 0, 0, other.grid->columns, other.grid->rows));
    }
    return least;
  }

 private:
  struct Boxed {
    const Grid* grid;
    model::Box3 box;
  };
  const PatchModel& model_;
  const OffsetModel& mesh_;
  std::vector<Boxed> all_;
  double offset_mm_;
};

/// Where a patch of the engine lies in the reference: a whole patch, or a quarter of it where the
/// cage has other faces than quads, since the engine then refines all of them once.
struct Place {
  int patch = 0, quarter = -1;

  verifier::SurfaceSample at(const verifier::ReferenceSurface& surface, double u, double v) const {
    switch (quarter) {
      case 0:
        return surface.evaluate(patch, u / 2, v / 2);
      case 1:
        return surface.evaluate(patch, 1 - v / 2, u / 2);
      case 2:
        return surface.evaluate(patch, 1 - u / 2, 1 - v / 2);
      case 3:
        return surface.evaluate(patch, v / 2, 1 - u / 2);
      default:
        return surface.evaluate(patch, u, v);
    }
  }
};

std::vector<Place> places(const Cage& cage, const verifier::ReferenceSurface& surface) {
  bool quads = true;
  for (model::Index f = 0; f < cage.face_count(); ++f) quads &= cage.face(f).size() == 4;
  std::vector<Place> all;
  int patch = 0;
  for (model::Index f = 0; f < cage.face_count(); ++f) {
    const int corners = static_cast<int>(cage.face(f).size());
    const int own = corners == 4 ? 1 : corners;
    const int times = corners == 4 && !quads ? 4 : own;
    for (int k = 0; k < times && surface.has_surface(patch); ++k)
      all.push_back(own == 1 ? Place{patch, quads ? -1 : k} : Place{patch + k, -1});
    patch += own;
  }
  return all;
}

struct Measured {
  double error_mm = 0, bound_mm = 0;
};

/// Places within the triangles of `grid`, both of a cell, at most `most` cells a side.
template <class Use>
void for_places_in(const Grid& grid, int most, const Use& use) {
  // Near the middle, and close to the long side, where the mesh is farthest from the surface.
  constexpr std::array<std::array<double, 3>, 2> kWeights = {
      {{0.34, 0.31, 0.35}, {0.49, 0.03, 0.48}}};
  const int step = std::max(1, (grid.columns - 1) / most);
  for (int v = step / 2; v + 1 < grid.rows; v += step)
    for (int u = step / 2; u + 1 < grid.columns; u += step) {
      const Vec3 a = grid.at(u, v), c = grid.at(u + 1, v + 1);
      for (const Vec3& b : {grid.at(u + 1, v), grid.at(u, v + 1)})
        for (const auto& w : kWeights) use(a * w[0] + b * w[1] + c * w[2]);
    }
}

/// Largest of | distance from the surface - offset | over the mesh: its grids, and at extraordinary
/// corners the finer pieces instead, which grids may stand out over. Only for surfaces whose offset
/// does not cut itself: elsewhere the mesh has parts that some other place of the surface is
/// nearer.
Measured measure_mesh(const PatchModel& model, const verifier::SurfaceCells& surface,
                      double offset_mm, double asked_mm) {
  const OffsetModel mesh = sample_offset(model, offset_mm, asked_mm);
  Measured measured{0, asked_mm + mesh.excess_mm};
  constexpr int kMost = 4;
  const double within = 4 * (offset_mm + measured.bound_mm);
  const auto use = [&](const Vec3& p) {
    const auto closest = verifier::closest_point(surface, p, within);
    REQUIRE(closest);
    measured.error_mm = std::max(measured.error_mm, std::abs(closest->distance_mm - offset_mm));
  };
  const bool pieces_at_corners = !mesh.corners.empty();
  for (const Grid& grid : mesh.corners) for_places_in(grid, kMost, use);
  for (std::size_t p = 0; p < mesh.grids.size(); ++p)
    if (!pieces_at_corners || model.patches()[p].corners.empty())
      for_places_in(mesh.grids[p], kMost, use);
  return measured;
}

/// Largest distance of `samples`² places a cell of depth 4 or less, off the nodes, from the mesh.
Measured measure(const PatchModel& model, const Cage& cage,
                 const verifier::ReferenceSurface& reference, double offset_mm, double asked_mm) {
  const OffsetModel mesh = sample_offset(model, offset_mm, asked_mm);
  const MeshDistance distance_from(model, mesh, offset_mm);
  Measured measured{0, asked_mm + mesh.excess_mm};
  const std::vector<Place> place = places(cage, reference);
  REQUIRE(place.size() == model.patches().size());
  for (int patch = 0; patch < static_cast<int>(model.patches().size()); ++patch) {
    const int cells = std::min(4, 1 << mesh.depths[patch]);
    for (int j = 0; j < 3 * cells; ++j)
      for (int i = 0; i < 3 * cells; ++i) {
        // Both triangles of a cell, and close to its corners.
        constexpr std::array<double, 3> kWithin = {0.03, 0.37, 0.71};
        const double u = (i / 3 + kWithin[i % 3]) / cells,
                     v = (j / 3 + kWithin[(i + j) % 3]) / cells;
        const auto s = place[patch].at(reference, u, v);
        const Vec3 p = s.position + s.normal * offset_mm;
        measured.error_mm = std::max(
            measured.error_mm,
            distance_from(patch, u, v, p, std::max(measured.error_mm, measured.bound_mm / 100)));
      }
  }
  return measured;
}

std::vector<Cage> test_cages() {
  // Every eighth holds all rules between them, and takes minutes.
  const auto stride = static_cast<std::size_t>(tests::by_effort(16, 8));
  std::vector<Cage> all;
  std::vector<Cage> features = tests::feature_cages();
  for (std::size_t i = 0; i < features.size(); i += stride) all.push_back(std::move(features[i]));
  for (const char* name : {"aircraft.obj", "quick-dome.obj"})
    all.push_back(model::read_cage_obj(tests::fixtures() / "cages" / name));
  if (const char* folder = std::getenv("LIMITGAUGE_CAGES"))
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".obj") {
        Cage cage = model::read_cage_obj(entry.path());
        if (model::find_defects(cage).empty()) all.push_back(std::move(cage));
      }
  return all;
}

}  // namespace

TEST_CASE("the chord error is below its bound", "[slow]") {
  double tightest = 0;
  int proven = 0, cages = 0;
  for (const Cage& cage : test_cages()) {
    const verifier::ReferenceSurface reference(cage);
    const double size = length(reference.bounding_box().size());
    // As a part of the part's size: coarse, so that all of it can be measured.
    const double precision = size * 4e-3, offset = size * 0.02;
    const PatchModel model(cage, {precision, offset, 6}, {2, nullptr, {}});
    ++cages;
    const auto& patches = model.patches();
    if (!std::all_of(patches.begin(), patches.end(), [](const auto& p) { return p.proven; }))
      continue;
    ++proven;
    for (const double out : {0.0, offset})
      for (const double asked : {precision / 4, precision}) {
        CAPTURE(cage.name, out, asked, size);
        const Measured m = measure(model, cage, reference, out, asked);
        CHECK(m.error_mm <= m.bound_mm + kRounding_mm);
        tightest = std::max(tightest, m.error_mm / m.bound_mm);
      }
  }
  CAPTURE(proven, cages);
  CHECK(proven > 0.8 * cages);
  // The bound is worth something: somewhere it is nearly reached.
  CHECK(tightest > 0.1);
}

TEST_CASE("every limit mesh lies within its bound of the surface", "[slow]") {
  double tightest = 0;
  for (const Cage& cage : test_cages()) {
    const verifier::ReferenceSurface reference(cage);
    const verifier::SurfaceCells surface(reference.tree(), 0.5);
    const double size = length(reference.bounding_box().size()), precision = size * 4e-3;
    const PatchModel model(cage, {precision, size * 0.02, 6}, {2, nullptr, {}});
    const auto& patches = model.patches();
    if (!std::all_of(patches.begin(), patches.end(), [](const auto& p) { return p.proven; }))
      continue;
    for (const double asked : {precision}) {
      CAPTURE(cage.name, asked, size);
      const Measured m = measure_mesh(model, surface, 0, asked);
      CHECK(m.error_mm <= m.bound_mm + kRounding_mm);
      tightest = std::max(tightest, m.error_mm / m.bound_mm);
    }
  }
  // That anything was measured: places near nodes lie far below the bound.
  CHECK(tightest > 0.05);
}

TEST_CASE("offset meshes of surfaces that bend outwards keep their distance within their bound",
          "[slow]") {
  std::vector<Cage> cages = {tests::scaled(tests::cube_cage(), 10),
                             tests::paraboloid_cage(20, -0.01), tests::paraboloid_cage(20, 0.005),
                             tests::prism(5), tests::prism(6)};
  double tightest = 0;
  for (const Cage& cage : cages) {
    const verifier::ReferenceSurface reference(cage);
    const verifier::SurfaceCells surface(reference.tree(), 0.5);
    const double size = length(reference.bounding_box().size());
    const double precision = size * 2e-3, offset = size * 0.05;
    const PatchModel model(cage, {precision, offset, 8}, {2, nullptr, {}});
    for (const double asked : {precision / 4, precision}) {
      CAPTURE(cage.name, asked, size);
      const Measured m = measure_mesh(model, surface, offset, asked);
      CHECK(m.error_mm <= m.bound_mm + kRounding_mm);
      tightest = std::max(tightest, m.error_mm / m.bound_mm);
    }
  }
  CHECK(tightest > 0.1);
}

}  // namespace limitgauge
