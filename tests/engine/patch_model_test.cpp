// Patches of a model that differ in depth: no place that two of them sample has two positions, or,
// where the surface is smooth, two normals. Bit for bit, since cracks as narrow as a rounding still
// let a section's curve end.
#include "engine/surface/patch_model.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "engine/surface/offset_model.h"
#include "model/part/cage_obj.h"
#include "tests/engine/cages.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"

using namespace limitgauge;
using namespace engine::surface;

namespace {

/// Quads over [0, n]² steps of 4 mm, level but for a peak that only the patches around it feel.
model::Cage peaked_cage(int n, int at, double height_mm) {
  const double middle = at - n / 2.0;
  return test::grid_cage(n, 4, [=](double x, double y) {
    return x == middle && y == middle ? height_mm : 0.002 * (x * x + x * y);
  });
}

/// Creases through the peak and beside it, for ever and for a while, and a dart.
model::Cage creased_cage() {
  constexpr int kSide = 10, kRow = kSide + 1, kPeak = 5;
  model::Cage cage = peaked_cage(kSide, kPeak, 24);
  const auto at = [](int i, int j) { return j * kRow + i; };
  for (int j = 0; j < kSide; ++j) {
    cage.creases.push_back({{at(kPeak, j), at(kPeak, j + 1)}, 10});
    cage.creases.push_back({{at(kPeak + 2, j), at(kPeak + 2, j + 1)}, 1.5});
  }
  for (int i = 0; i < 3; ++i) cage.creases.push_back({{at(i, kPeak), at(i + 1, kPeak)}, 10});
  cage.corners = {{at(7, 3), 2.3}, {at(2, 2), 10}};
  return cage;
}

/// Triangles, quads and hexagons by turns, the peak at a corner of all three.
model::Cage n_gon_cage() {
  constexpr int kSide = 6, kRow = kSide + 1, kPeak = 3;
  model::Cage cage = peaked_cage(kSide, kPeak, 20);
  cage.face_corners.clear();
  cage.face_offsets = {0};
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      const model::Index a = j * kRow + i, b = a + 1, c = b + kRow, d = a + kRow;
      if (j % 4 == 0 && i % 4 < 2) {
        if (i % 4 == 0) cage.add_face(std::array<model::Index, 6>{a, b, b + 1, c + 1, c, d});
      } else if ((i + j) % 3 == 0) {
        cage.add_face(std::array<model::Index, 3>{a, b, c});
        cage.add_face(std::array<model::Index, 3>{a, c, d});
      } else {
        cage.add_face(std::array<model::Index, 4>{a, b, c, d});
      }
    }
  cage.creases = {{{kPeak * kRow + kPeak, kPeak * kRow + kPeak + 1}, 10}};
  return cage;
}

/// Two patches with surface, rough beyond all measure beside gentle: everything else is holes.
model::Cage pair_cage(double bend_mm) {
  constexpr int kAcross = 3, kAlong = 4;
  model::Cage cage;
  for (int j = 0; j <= kAcross; ++j)
    for (int i = 0; i <= kAlong; ++i)
      cage.vertices.push_back(
          {10.0 * i, 10.0 * j, 0.05 * (j - 1) * (j - 2) + (i == kAlong) * bend_mm});
  for (int j = 0; j < kAcross; ++j)
    for (int i = 0; i < kAlong; ++i) {
      const model::Index a = j * (kAlong + 1) + i;
      if (j != 1 || i == 0 || i == kAlong - 1) cage.holes.push_back(cage.face_count());
      cage.add_face(std::array<model::Index, 4>{a, a + 1, a + kAlong + 2, a + kAlong + 1});
    }
  return cage;
}

bool same_bits(const Vec3& a, const Vec3& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

struct Shared {
  int places = 0, largest_step = 0;
  int apart = 0, turned = 0;  ///< places with two positions, or two normals though smooth
};

/// The places inside the sides that two patches share.
void count_sides(const PatchModel& model, Shared& count) {
  for (Index h = 0; h < model.outer().half_edge_count(); ++h) {
    if (!model.has_patch(h) || model.ends_at(h)) continue;
    const Index twin = model.outer().twin[h];
    const LimitPatch& a = model.patches()[model.patch_at(h)].limit;
    const LimitPatch& b = model.patches()[model.patch_at(twin)].limit;
    if (a.depth > b.depth) continue;
    count.largest_step = std::max(count.largest_step, b.depth - a.depth);
    const int ratio = b.cells() / a.cells();
    for (int t = 1; t < a.cells(); ++t) {
      const int i = a.side_index(model.side_at(h), t);
      const int j = b.side_index(model.side_at(twin), (a.cells() - t) * ratio);
      ++count.places;
      count.apart += !same_bits(a.points[i], b.points[j]);
      count.turned += !model.creased_at(h) && !same_bits(a.normals[i], b.normals[j]);
    }
  }
}

bool smooth_around(const OuterMesh& mesh, Index vertex) {
  bool smooth = !(mesh.vertex_sharpness[vertex] > 0);
  for (Index h = 0; h < mesh.half_edge_count(); ++h)
    if (mesh.origin[h] == vertex || mesh.target(h) == vertex)
      smooth &= !(mesh.edge_sharpness[mesh.edge[h]] > 0);
  return smooth;
}

/// The corners of patches, each against the first at its vertex.
void count_corners(const PatchModel& model, Shared& count) {
  const OuterMesh& mesh = model.outer();
  for (Index vertex = 0; vertex < static_cast<Index>(mesh.points.size()); ++vertex) {
    const bool smooth = smooth_around(mesh, vertex);
    std::optional<std::pair<Vec3, Vec3>> first;
    for (Index h = 0; h < mesh.half_edge_count(); ++h) {
      if (mesh.origin[h] != vertex || !model.has_patch(h)) continue;
      const LimitPatch& limit = model.patches()[model.patch_at(h)].limit;
      const int i = limit.side_index(model.side_at(h), 0);
      if (!first) first = {limit.points[i], limit.normals[i]};
      ++count.places;
      count.apart += !same_bits(limit.points[i], first->first);
      count.turned += smooth && !same_bits(limit.normals[i], first->second);
    }
  }
}

/// The same of meshes as they are sampled, which may be coarser, ends of sides included. Moved out,
/// sharp vertices come apart.
void count_sampled(const PatchModel& model, const OffsetModel& mesh, Shared& count) {
  for (Index h = 0; h < model.outer().half_edge_count(); ++h) {
    if (!model.has_patch(h) || model.ends_at(h) || model.creased_at(h)) continue;
    const Index twin = model.outer().twin[h];
    const Grid& a = mesh.grids[model.patch_at(h)];
    const Grid& b = mesh.grids[model.patch_at(twin)];
    if (a.columns > b.columns) continue;
    const int cells = a.columns - 1, fine = b.columns - 1;
    const auto comes_apart = [&](Index end) {
      return mesh.offset_mm > 0 && !smooth_around(model.outer(), model.outer().origin[end]);
    };
    for (int t = 0; t <= cells; ++t) {
      if ((t == 0 && comes_apart(h)) || (t == cells && comes_apart(twin))) continue;
      ++count.places;
      count.apart +=
          !same_bits(a.points[side_index(model.side_at(h), t, cells)],
                     b.points[side_index(model.side_at(twin), fine - t * (fine / cells), fine)]);
    }
  }
}

model::Cage uneven_depths() {
  return model::read_cage_obj(tests::fixtures() / "torture" / "uneven-depths.obj");
}

}  // namespace

TEST_CASE("patches of unequal depth share their points and normals bit for bit",
          "[slow][surface]") {
  // Without an offset for the n-gons: the pieces at their many corners would take seconds.
  const auto [name, cage, offset_mm, step] = GENERATE(
      table<const char*, model::Cage, double, int>({{"uneven depths", uneven_depths(), 1.0, 4},
                                                    {"creases", creased_cage(), 1.0, 4},
                                                    {"n-gons", n_gon_cage(), 0.0, 2}}));
  CAPTURE(name);
  const PatchModel model(cage, {0.01, offset_mm, 9}, {2, nullptr, {}});
  Shared sides, corners;
  count_sides(model, sides);
  count_corners(model, corners);
  CHECK(sides.places > 500);
  CHECK(sides.largest_step >= step);
  CHECK(sides.apart == 0);
  CHECK(sides.turned == 0);
  CHECK(corners.apart == 0);
  CHECK(corners.turned == 0);
  for (const double out : {0.0, offset_mm})
    for (const double error_mm : {0.01, 0.1}) {
      Shared sampled;
      count_sampled(model, sample_offset(model, out, error_mm), sampled);
      CAPTURE(out, error_mm);
      CHECK(sampled.places > 50);
      CHECK(sampled.apart == 0);
    }
}

TEST_CASE("a patch of depth twelve shares its points with one four levels coarser",
          "[slow][surface]") {
  const PatchModel model(pair_cage(1500), {2e-5, 0, 12}, {2, nullptr, {}});
  REQUIRE(model.patches().size() == 2);
  CAPTURE(model.patches()[0].limit.depth);
  CHECK(model.patches()[1].limit.depth == 12);
  Shared sides, corners;
  count_sides(model, sides);
  count_corners(model, corners);
  CHECK(sides.largest_step >= 4);
  CHECK(sides.places > 20);
  CHECK(sides.apart + corners.apart == 0);
  CHECK(sides.turned + corners.turned == 0);
}
