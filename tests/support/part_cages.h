#pragma once
// Parts with flat faces and sharp edges, whose limit surfaces are the polyhedra themselves.

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/cages.h"

namespace limitgauge::tests {

/// A point of an outline across a part, in mm.
struct OutlinePoint {
  double x = 0, z = 0;
};

/// An outline drawn along Y over [−length/2, length/2], sharp at every point of it. The machining
/// side lies to the left of the outline's way (above it where x grows).
inline model::Cage drawn_outline(const std::vector<OutlinePoint>& outline, double length_mm) {
  const int nx = static_cast<int>(outline.size()) - 1, ny = 2;
  model::Cage cage = grid_cage(
      nx, ny,
      [&](int i, int j) {
        return model::Vec3{outline[static_cast<std::size_t>(i)].x, length_mm * (j - 1.0) / ny,
                           outline[static_cast<std::size_t>(i)].z};
      },
      model::BoundaryRule::edge_and_corner);
  for (int i = 1; i < nx; ++i)
    for (int j = 0; j < ny; ++j) {
      const model::Index a = j * (nx + 1) + i;
      cage.creases.push_back({{a, a + nx + 1}, model::kInfiniteSharpness});
    }
  return cage;
}

/// Ridges side by side, symmetric about x = 0, on a floor at z = 0 that goes on beside them.
struct Ridges {
  int count = 1;
  double pitch_mm = 1, flank_deg = 45;
  double length_mm = 6, floor_mm = 2;
  double height_mm() const { return pitch_mm / 2 * std::tan(flank_deg * std::numbers::pi / 180); }
};
inline model::Cage ridge_cage(const Ridges& r) {
  const double half = r.count * r.pitch_mm / 2;
  std::vector<OutlinePoint> outline = {{-half - r.floor_mm, 0}};
  for (int k = 0; k < r.count; ++k) {
    outline.push_back({-half + k * r.pitch_mm, 0});
    outline.push_back({-half + (k + 0.5) * r.pitch_mm, r.height_mm()});
  }
  outline.push_back({half, 0});
  outline.push_back({half + r.floor_mm, 0});
  return drawn_outline(outline, r.length_mm);
}

/// A slot with upright walls along Y in a top at z = 0.
struct Slot {
  double width_mm = 3, depth_mm = 2, top_mm = 4, length_mm = 6;
};
inline model::Cage slot_cage(const Slot& s) {
  const double w = s.width_mm / 2;
  return drawn_outline(
      {{-w - s.top_mm, 0}, {-w, 0}, {-w, -s.depth_mm}, {w, -s.depth_mm}, {w, 0}, {w + s.top_mm, 0}},
      s.length_mm);
}

/// A slot that is wider at its floor: its wider part is `neck_mm` below the top.
struct TSlot {
  double width_mm = 3, foot_width_mm = 6, neck_mm = 2, depth_mm = 4, top_mm = 4, length_mm = 6;
};
inline model::Cage t_slot_cage(const TSlot& s) {
  const double w = s.width_mm / 2, f = s.foot_width_mm / 2;
  return drawn_outline({{-f - s.top_mm, 0},
                        {-w, 0},
                        {-w, -s.neck_mm},
                        {-f, -s.neck_mm},
                        {-f, -s.depth_mm},
                        {f, -s.depth_mm},
                        {f, -s.neck_mm},
                        {w, -s.neck_mm},
                        {w, 0},
                        {f + s.top_mm, 0}},
                       s.length_mm);
}

/// The top and the four walls of a block, all edges and corners sharp; no underside.
inline model::Cage boss_cage(const model::Box3& box) {
  model::Cage cage;
  cage.name = "boss";
  for (int k = 0; k < 8; ++k)
    cage.vertices.push_back({k & 1 ? box.high.x : box.low.x, k & 2 ? box.high.y : box.low.y,
                             k & 4 ? box.high.z : box.low.z});
  const std::array<std::array<model::Index, 4>, 5> faces = {
      {{4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& f : faces) cage.add_face(f);
  for (const auto& [a, b] :
       {std::pair{4, 5}, {5, 7}, {6, 7}, {4, 6}, {0, 4}, {1, 5}, {2, 6}, {3, 7}})
    cage.creases.push_back({{a, b}, model::kInfiniteSharpness});
  cage.boundary = model::BoundaryRule::edge_and_corner;
  return cage;
}

/// A boss on a floor around it, in one sheet: the floor is `floor_mm` wide on all sides.
inline model::Cage boss_on_floor_cage(const model::Box3& boss, double floor_mm) {
  model::Cage cage = boss_cage(boss);
  const model::Index first = static_cast<model::Index>(cage.vertices.size());
  for (int k = 0; k < 4; ++k)
    cage.vertices.push_back({k & 1 ? boss.high.x + floor_mm : boss.low.x - floor_mm,
                             k & 2 ? boss.high.y + floor_mm : boss.low.y - floor_mm, boss.low.z});
  const std::array<std::array<model::Index, 4>, 4> faces = {{{first, first + 1, 1, 0},
                                                             {first + 1, first + 3, 3, 1},
                                                             {first + 3, first + 2, 2, 3},
                                                             {first + 2, first, 0, 2}}};
  for (const auto& f : faces) cage.add_face(f);
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 3}, {2, 3}, {0, 2}})
    cage.creases.push_back({{a, b}, model::kInfiniteSharpness});
  for (model::Index k = 0; k < 4; ++k)
    cage.creases.push_back({{k, first + k}, model::kInfiniteSharpness});
  return cage;
}

/// A square pocket with upright walls in a square top at z = 0, sharp all round.
struct Pocket {
  double half_mm = 3, depth_mm = 4, top_half_mm = 9;
};
inline model::Cage pocket_cage(const Pocket& p) {
  model::Cage cage;
  cage.name = "pocket";
  const double x[] = {-p.top_half_mm, -p.half_mm, p.half_mm, p.top_half_mm};
  for (const double b : x)
    for (const double a : x) cage.vertices.push_back({a, b, 0});
  for (const double b : {-p.half_mm, p.half_mm})
    for (const double a : {-p.half_mm, p.half_mm}) cage.vertices.push_back({a, b, -p.depth_mm});
  const auto top = [](int i, int j) { return static_cast<model::Index>(4 * j + i); };
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i)
      if (i != 1 || j != 1)
        cage.add_face(std::array{top(i, j), top(i + 1, j), top(i + 1, j + 1), top(i, j + 1)});
  // Rim and floor, counterclockwise from the lower left.
  const model::Index rim[] = {top(1, 1), top(2, 1), top(2, 2), top(1, 2)},
                     floor[] = {16, 17, 19, 18};
  cage.add_face(floor);
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    cage.add_face(std::array{rim[k], rim[next], floor[next], floor[k]});
    cage.creases.push_back({{rim[k], rim[next]}, model::kInfiniteSharpness});
    cage.creases.push_back({{floor[k], floor[next]}, model::kInfiniteSharpness});
    cage.creases.push_back({{rim[k], floor[k]}, model::kInfiniteSharpness});
  }
  cage.boundary = model::BoundaryRule::edge_and_corner;
  return cage;
}

/// The same surface, wound the other way.
inline model::Cage flipped(const model::Cage& cage) {
  model::Cage out = cage;
  out.face_corners.clear(), out.face_offsets = {0};
  for (model::Index f = 0; f < cage.face_count(); ++f) {
    const auto face = cage.face(f);
    out.add_face(std::vector<model::Index>(face.rbegin(), face.rend()));
  }
  return out;
}

/// Two cages as one part. Creases and corners of the second are left behind.
inline model::Cage together(model::Cage cage, const model::Cage& other) {
  const auto first = static_cast<model::Index>(cage.vertices.size());
  cage.vertices.insert(cage.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (model::Index f = 0; f < other.face_count(); ++f) {
    std::vector<model::Index> corners(other.face(f).begin(), other.face(f).end());
    for (model::Index& c : corners) c += first;
    cage.add_face(corners);
  }
  return cage;
}

}  // namespace limitgauge::tests
