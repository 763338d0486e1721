#include "engine/surface/cell/vertex_zone.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace limitgauge::engine::surface {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Levels of pieces inside the cell at the corner. Control nets shrink by 0.654 a level at worst:
/// the speck left is about a thousandth of the cell.
constexpr int kLevels = 16;

/// Cells around the one that is bounded.
constexpr int kAround = 2;

void widen(SplitBound& all, const SplitBound& by, double scale) {
  all.along = std::max(all.along, by.along * scale);
  all.across = std::max(all.across, by.across * scale);
}

}  // namespace

/// One depth's argument.
class VertexZones::Zone {
 public:
  /// Of cell (u, v) at depth `at`, counted from the first level.
  Zone(const std::vector<Level>& levels, std::size_t at, const std::array<bool, 4>& rim, int u,
       int v)
      : levels_(levels),
        at_(at),
        rim_(rim),
        u_(u),
        v_(v),
        low_u_(std::max(0, u - kAround)),
        low_v_(std::max(0, v - kAround)),
        high_u_(u + kAround + 1),
        high_v_(v + kAround + 1) {
    const Level& l = own();
    const Vec3 a = l.node(low_u_, low_v_), b = l.node(high_u_, low_v_);
    const Vec3 c = l.node(high_u_, high_v_), d = l.node(low_u_, high_v_);
    const Vec3 edge_u = b + c - a - d, edge_v = c + d - a - b;
    normal_ = normalized(cross(edge_u, edge_v));
    map_ =
        LevelMap(normal_, edge_u / (2.0 * (high_u_ - low_u_)), edge_v / (2.0 * (high_v_ - low_v_)));
    if (low_v_ == 0)
      for (int t = low_u_; t < high_u_; ++t) add_chord(l.node(t, 0), l.node(t + 1, 0), 0);
    first_of_3_ = chords_.size();
    if (low_u_ == 0)
      for (int t = low_v_; t < high_v_; ++t) add_chord(l.node(0, t + 1), l.node(0, t), 1);
  }

  ZoneBound bound() {
    measure_regular();
    if (low_u_ == 0 && low_v_ == 0) {
      measure_corner();
      measure_speck();
    }
    const double plain = std::hypot(off_, slide_);
    return {std::min(plain, slide_along()), {std::min(side_, plain), 0, 0}, {}};
  }

 private:
  /// A chord of one of the patch's sides: P L is inside where the inward product is not negative.
  struct SideChord {
    Vec3 start, inward;
    int side = 0;  ///< 0 or 1: the patch's side 0 or 3
    double outside(const Vec3& p) const { return dot(inward, start - p); }
  };

  const Level& own() const { return levels_[at_]; }
  double height(const Vec3& v) const { return std::abs(dot(normal_, v)); }
  Vec3 level(const Vec3& v) const { return v - normal_ * dot(normal_, v); }

  void add_chord(const Vec3& from, const Vec3& to, int side) {
    chords_.push_back({from, normalized(cross(normal_, to - from)), side});
  }

  void widen(double off, double slide, double mapped) {
    off_ = std::max(off_, off);
    slide_ = std::max(slide_, slide);
    mapped_slide_ = std::max(mapped_slide_, mapped);
  }
  /// A piece that leaves the mesh by `deviation` at most at its nodes.
  void widen(std::span<const Vec3> deviations, const ControlCell& net) {
    const Largest uu = largest(net, 2, 0), uv = largest(net, 1, 1), vv = largest(net, 0, 2);
    const auto interpolation = [&](double Largest::*of) {
      return (uu.*of + 2 * uv.*of + vv.*of) / 8;
    };
    const double off = interpolation(&Largest::height), slide = interpolation(&Largest::level),
                 mapped = interpolation(&Largest::mapped);
    for (const Vec3& d : deviations)
      widen(off + height(d), slide + length(level(d)), mapped + map_.length(d));
  }
  /// Of differences, each by itself.
  struct Largest {
    double height = 0, level = 0, mapped = 0;
  };
  Largest largest(const ControlCell& net, int in_u, int in_v) const {
    Largest most;
    double level_squared = 0;
    Longest mapped;
    Differences(net, in_u, in_v).for_each([&](const Vec3& d) {
      most.height = std::max(most.height, height(d));
      level_squared = std::max(level_squared, length_squared(level(d)));
      mapped.see(map_(d));
    });
    most.level = std::sqrt(level_squared), most.mapped = mapped.length();
    return most;
  }

  void overhangs(const Vec3& p) {
    for (const SideChord& chord : chords_)
      overhang_[chord.side] = std::max(overhang_[chord.side], chord.outside(p));
  }
  /// Bézier points of a piece's curve along side 0 or 3 of the patch, over chord `t` of it.
  void bulges(const Piece& piece, bool along_u, int t) {
    const std::size_t at = along_u ? static_cast<std::size_t>(t - low_u_)
                                   : first_of_3_ + static_cast<std::size_t>(t - low_v_);
    const SideChord& chord = chords_[at];
    for (int k = 0; k < 4; ++k)
      bulge_[chord.side] =
          std::max(bulge_[chord.side], std::abs(chord.outside(piece.bezier[along_u ? k : 4 * k])));
  }

  void measure_regular() {
    for (int v = low_v_; v < high_v_; ++v)
      for (int u = low_u_; u < high_u_; ++u) {
        if (u == 0 && v == 0) continue;
        const Piece& piece = own().piece(u, v);
        widen(std::array{Vec3{}}, piece.net);
        if (u == u_ && v == v_)
          for (const Vec3& p : piece.bezier) overhangs(p);
        if (v == 0) bulges(piece, true, u);
        if (u == 0) bulges(piece, false, v);
      }
  }
  bool at_corner() const { return u_ == 0 && v_ == 0; }

  /// The mesh over the first cell, at u, v in [0, 1].
  Vec3 mesh_at(double u, double v) const {
    const Level& l = own();
    const Vec3 a = l.node(0, 0), b = l.node(1, 0), c = l.node(1, 1), d = l.node(0, 1);
    return v <= u ? a + (b - a) * u + (c - b) * v : a + (d - a) * v + (c - d) * u;
  }

  void measure_corner() {
    double side = 1;
    for (std::size_t j = at_ + 1; j <= at_ + kLevels; ++j) {
      side /= 2;
      for (const auto& [u, v] : {std::array{1, 0}, std::array{0, 1}, std::array{1, 1}}) {
        const Piece& piece = levels_[j].piece(u, v);
        std::array<Vec3, 4> deviations;
        for (int k = 0; k < 4; ++k) {
          const int i = u + k % 2, j2 = v + k / 2;
          deviations[k] = levels_[j].node(i, j2) - mesh_at(i * side, j2 * side);
        }
        widen(deviations, piece.net);
        if (at_corner())
          for (const Vec3& p : piece.bezier) overhangs(p);
        if (v == 0) bulges(piece, true, 0);
        if (u == 0) bulges(piece, false, 0);
      }
    }
  }

  void measure_speck() {
    const Vec3 vertex = own().node(0, 0);
    const double side = std::ldexp(1.0, -kLevels);
    double off = 0, slide = 0, mapped = 0;
    for (const auto& [u, v] : {std::array{1, 0}, std::array{0, 1}, std::array{1, 1}}) {
      const Vec3 to = mesh_at(u * side, v * side) - vertex;
      off = std::max(off, height(to));
      slide = std::max(slide, length(level(to)));
      mapped = std::max(mapped, map_.length(to));
    }
    for (const Vec3& p : levels_[at_ + kLevels].hull) {
      const Vec3 to = p - vertex;
      widen(off + height(to), slide + length(level(to)), mapped + map_.length(to));
      for (double& bulge : bulge_) bulge = std::max(bulge, length(level(to)));
      if (at_corner()) overhangs(p);
    }
  }

  /// The bound of the header, with the mesh's edges for its derivatives.
  double slide_along() {
    std::vector<Vec3> in_u, in_v;
    for (int v = low_v_; v <= high_v_; ++v)
      for (int u = low_u_; u <= high_u_; ++u) {
        if (u < high_u_) in_u.push_back(own().node(u + 1, v) - own().node(u, v));
        if (v < high_v_) in_v.push_back(own().node(u, v + 1) - own().node(u, v));
      }
    double area = kInfinity, largest_u = 0, largest_v = 0, rise_u = 0, rise_v = 0;
    for (const Vec3& a : in_u) {
      largest_u = std::max(largest_u, map_.length(a));
      rise_u = std::max(rise_u, height(a));
      for (const Vec3& b : in_v) {
        const auto s = map_(a), t = map_(b);
        area = std::min(area, s[0] * t[1] - s[1] * t[0]);
      }
    }
    for (const Vec3& b : in_v) {
      largest_v = std::max(largest_v, map_.length(b));
      rise_v = std::max(rise_v, height(b));
    }
    if (!(area > 0)) return kInfinity;
    const double slope = (largest_v * rise_u + largest_u * rise_v) / area;
    const double reach = kAround * area / std::max(largest_u, largest_v);
    const double factor = middle_factor();
    double inside = 0, rim = 0, bulge = 0;
    bool smooth = false;
    for (int side = 0; side < 2; ++side) {
      const bool here = (side == 0 ? low_v_ : low_u_) == 0;
      if (rim_[3 * side]) inside = std::max(inside, overhang_[side] * factor);
      if (rim_[3 * side]) rim = std::max(rim, 2 * bulge_[side]);
      bulge = std::max(bulge, bulge_[side]);
      smooth |= here && !rim_[3 * side];
    }
    if (!(mapped_slide_ + map_.norm() * inside < reach)) return kInfinity;
    rim = std::max(rim, inside);
    side_ = off_ + std::min(1.0, 2 * slope * map_.norm()) * bulge;
    return off_ + slope * ((smooth ? 2 : 1) * mapped_slide_ + map_.norm() * rim) + rim;
  }

  double middle_factor() const {
    Vec3 sum;
    for (const SideChord& chord : chords_)
      if (rim_[3 * chord.side]) sum += chord.inward;
    double least = 1;
    for (const SideChord& chord : chords_)
      if (rim_[3 * chord.side]) least = std::min(least, dot(chord.inward, normalized(sum)));
    return least > 0 ? 1 / least : kInfinity;
  }

  const std::vector<Level>& levels_;
  std::size_t at_;
  std::array<bool, 4> rim_;
  int u_, v_, low_u_, low_v_, high_u_, high_v_;
  std::size_t first_of_3_ = 0;
  double side_ = kInfinity;
  Vec3 normal_;
  std::vector<SideChord> chords_;  ///< of sides 0 and 3 in turn
  LevelMap map_;
  double off_ = 0, slide_ = 0, mapped_slide_ = 0;
  std::array<double, 2> overhang_{}, bulge_{};
};

VertexZones::VertexZones(CellPatch corner, int level, int analysed_depth, int largest_depth,
                         const std::array<bool, 4>& rim)
    : first_(level + 3), analysed_(analysed_depth), rim_{rim[0], true, true, rim[3]} {
  for (; first_ + static_cast<int>(levels_.size()) <= largest_depth + kLevels; ++level) {
    corner.refine();
    CellPatch next = corner.corner_cell(0);
    while (corner.cells() < kBlock) corner.refine();
    add_level(corner, level + 3 <= largest_depth ? kBlock : 2);
    if (level + 4 > analysed_ && level + 4 <= largest_depth) {
      corner.refine();
      add_ring(corner);
    }
    corner = std::move(next);
  }
  for (int depth = first_; depth <= largest_depth; ++depth)
    zones_.push_back(zone(static_cast<std::size_t>(depth - first_)));
}

/// Nodes and pieces of the first `width` cells each way.
void VertexZones::add_level(const CellPatch& patch, int width) {
  Level level;
  const LimitPatch limit = patch.limit();
  for (int v = 0; v <= width; ++v)
    for (int u = 0; u <= width; ++u)
      level.nodes[v * (kBlock + 1) + u] = limit.points[limit.index(u, v)];
  for (int v = 0; v < width; ++v)
    for (int u = 0; u < width; ++u) {
      const auto net = control_cell(patch, u, v);
      if (net) level.pieces[v * kBlock + u] = {*net, net->bezier()};
    }
  patch.ring(0).add_points(level.hull);
  for (int v = patch.has_border(0) ? -1 : 0; v <= 2; ++v) level.hull.push_back(patch.control(2, v));
  for (int u = patch.has_border(3) ? -1 : 0; u <= 2; ++u) level.hull.push_back(patch.control(u, 2));
  levels_.push_back(std::move(level));
}

ZoneBound VertexZones::zone(std::size_t at) const {
  ZoneBound all;
  for (int v = 0; v < kWidth; ++v)
    for (int u = 0; u < kWidth; ++u) {
      const ZoneBound bound = Zone(levels_, at, rim_, u, v).bound();
      all.surface = std::max(all.surface, bound.surface);
      if (u == 0 || v == 0) widen(all.side, bound.side, 1);
    }
  return all;
}

void VertexZones::add_ring(const CellPatch& patch) {
  // The cells of one depth between those of the depth before, already bounded, and Q.
  constexpr int kOuter = 2 * kWidth, kInner = kWidth;
  const CellGrid grid(patch, 0, rim_);
  Ring ring;
  for (int v = 0; v < kOuter; ++v)
    for (int u = 0; u < kOuter; ++u)
      if (u >= kInner || v >= kInner) {
        ring.cells.push_back(grid.bound(u, v));
        if (grid.meets(u, v)) ring.meeting.push_back(ring.cells.back());
      }
  for (int t = kInner; t < kOuter; ++t)
    for (const int side : {0, 3}) widen(ring.side, grid.side_bound(side, t), 1);
  rings_.push_back(std::move(ring));
}

ZoneBound VertexZones::rings_at(int depth) const {
  ZoneBound bound;
  for (int at = analysed_ + 1; at <= depth; ++at) {
    const Ring& ring = rings_[static_cast<std::size_t>(at - analysed_ - 1)];
    const double scale = std::ldexp(1.0, -2 * (depth - at));
    for (const MeshBound& cell : ring.cells)
      bound.surface = std::max(bound.surface, cell.at(scale));
    for (const MeshBound& cell : ring.meeting)
      bound.meeting = worse(bound.meeting, cell.meeting(scale));
    widen(bound.side, ring.side, scale);
  }
  return bound;
}

ZoneBound VertexZones::at(int depth) const {
  if (depth < first_) return {kInfinity, {kInfinity, kInfinity, 0}, {}};
  ZoneBound bound = rings_at(depth);
  const ZoneBound& zone = zones_[static_cast<std::size_t>(depth - first_)];
  bound.surface = std::max(bound.surface, zone.surface);
  widen(bound.side, zone.side, 1);
  return bound;
}

}  // namespace limitgauge::engine::surface
