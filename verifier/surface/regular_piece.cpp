#include "verifier/surface/regular_piece.h"

#include <algorithm>

namespace limitgauge::verifier {
namespace {

using model::Index;
using model::Vec3;

bool is_infinite(double sharpness) {
  return sharpness >= model::kInfiniteSharpness;
}

bool all_quads(const Neighbourhood& n) {
  for (int f = 0; f < n.face_count(); ++f)
    if (n.size_of(f) != 4) return false;
  return true;
}

struct FaceCorner {
  int face = 0, corner = 0;
};

/// The face at `star`'s vertex that has the directed edge towards `end` (if `after`) or from it.
std::optional<FaceCorner> wedge_at(const Neighbourhood& n, const Star& star, Index end,
                                   bool after) {
  for (const Star::Wedge& w : star.wedges)
    if ((after ? n.next(w.face, w.corner) : n.prev(w.face, w.corner)) == end)
      return FaceCorner{w.face, w.corner};
  return std::nullopt;
}

/// A crease vertex whose sector on this side holds this face and one more.
bool is_regular_crease(const Neighbourhood& n, const Star& star, int k) {
  const bool after = is_infinite(n.sharpness_after(0, k)),
             before = is_infinite(n.sharpness_before(0, k));
  if (after == before) return false;
  if (after) {
    const auto beyond = wedge_at(n, star, n.prev(0, k), true);
    return beyond && is_infinite(n.sharpness_before(beyond->face, beyond->corner));
  }
  const auto beyond = wedge_at(n, star, n.next(0, k), false);
  return beyond && is_infinite(n.sharpness_after(beyond->face, beyond->corner));
}

/// Place of corner k, of the two points beyond edge k (next to its start and its end) and of the
/// point diagonally beyond corner k, in the 4×4 grid.
constexpr int kInner[4] = {5, 6, 10, 9};
constexpr int kBeyondStart[4] = {1, 7, 14, 8};
constexpr int kBeyondEnd[4] = {2, 11, 13, 4};
constexpr int kDiagonal[4] = {0, 3, 15, 12};

class GridBuilder {
 public:
  explicit GridBuilder(const Neighbourhood& n) : n_(n) {
    for (int k = 0; k < 4; ++k) take(kInner[k], n.corner(0, k));
    for (int k = 0; k < 4; ++k) edge(k);
    for (int k = 0; k < 4; ++k) diagonal(k);
  }
  const RegularGrid& grid() const { return grid_; }

 private:
  bool sharp(int k) const { return is_infinite(n_.sharpness_after(0, k & 3)); }
  void take(int to, Index point) { grid_.entries[count_++] = {to, false, point, 0}; }
  void reflect(int to, int twice, int less) { grid_.entries[count_++] = {to, true, twice, less}; }

  void edge(int k) {
    const int a = kInner[k], b = kInner[(k + 1) & 3], a_in = kInner[(k + 3) & 3],
              b_in = kInner[(k + 2) & 3];
    if (sharp(k)) {
      reflect(kBeyondStart[k], a, a_in);
      reflect(kBeyondEnd[k], b, b_in);
      return;
    }
    const Star star = star_of(n_, n_.corner(0, k));
    const auto w = wedge_at(n_, star, n_.next(0, k), false);
    take(kBeyondStart[k], n_.next(w->face, w->corner));
    take(kBeyondEnd[k], n_.corner(w->face, (w->corner + 2) & 3));
  }

  /// Reflected across whichever of the two edges at the corner is sharp, else the point itself.
  void diagonal(int k) {
    const int before = (k + 3) & 3;
    if (sharp(k)) {
      // Along edge k's line: the point beyond the edge before, and the one further in.
      reflect(kDiagonal[k], kBeyondEnd[before], kBeyondStart[before]);
    } else if (sharp(before)) {
      reflect(kDiagonal[k], kBeyondStart[k], kBeyondEnd[k]);
    } else {
      const Star star = star_of(n_, n_.corner(0, k));
      const auto across = wedge_at(n_, star, n_.next(0, k), false);
      const Index edge = n_.next(across->face, across->corner);
      const auto far = wedge_at(n_, star, edge, false);
      take(kDiagonal[k], n_.corner(far->face, (far->corner + 2) & 3));
    }
  }

  const Neighbourhood& n_;
  RegularGrid grid_;
  std::size_t count_ = 0;
};

}  // namespace

bool is_irregular_corner(const Neighbourhood& n, int k) {
  const Index v = n.corner(0, k);
  const Star star = star_of(n, v);
  const double s = n.vertex_sharpness[v];
  if (s > 0 && !is_infinite(s)) return true;
  int sharp = 0;
  for (const Star::Spoke& spoke : star.spokes) {
    if (spoke.sharpness > 0 && !is_infinite(spoke.sharpness)) return true;
    sharp += spoke.sharpness > 0;
  }
  if (s > 0 || sharp > 2)
    return !(is_infinite(n.sharpness_after(0, k)) && is_infinite(n.sharpness_before(0, k)));
  if (sharp == 2) return !is_regular_crease(n, star, k);
  return sharp != 0 || star.wedges.size() != 4 || star.spokes.size() != 4;
}

std::optional<RegularGrid> regular_grid(const Neighbourhood& n) {
  if (!all_quads(n)) return std::nullopt;
  for (int k = 0; k < 4; ++k)
    if (is_irregular_corner(n, k)) return std::nullopt;
  return GridBuilder(n).grid();
}

Bezier piece_of(const RegularGrid& grid, std::span<const Vec3> points) {
  std::array<Vec3, 16> control{};
  for (const RegularGrid::Entry& e : grid.entries)
    control[e.to] = e.reflected ? control[e.a] * 2 - control[e.b] : points[e.a];
  return from_bspline(control);
}

std::optional<Bezier> regular_piece(const Neighbourhood& n) {
  const auto grid = regular_grid(n);
  return grid ? std::optional(piece_of(*grid, n.points)) : std::nullopt;
}

}  // namespace limitgauge::verifier
