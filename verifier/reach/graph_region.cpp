#include "verifier/reach/graph_region.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "verifier/cells/derivative_hull.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Halvings of a cell over whose parts its curvature is bounded: fewer leave the bounds too wide to
/// be of use on cells whose parameters run unevenly.
constexpr int kBendHalvings = 4;
/// Cells of a region; more are not gone into.
constexpr std::size_t kMostCells = 400;
/// Normals of a region are turned by less than 69 degrees against the contact's.
constexpr double kLeastCosine = 0.36;

/// Greatest normal curvature of a cell towards its normals, which lie within `spread_rad` of `n`:
/// second derivatives along n over squared first ones, both in parameters in which the middle is
/// nearly a plane in millimetres. None where that has no bound.
std::optional<double> part_bend(const SurfaceCell& cell, const Vec3& n, double spread_rad) {
  const auto plane = PlaneParameters::of(cell);
  if (!plane) return std::nullopt;
  const DerivativeHull h = plane->taken(derivative_hull(cell));
  const Vec3 t = plane->t, b = plane->b;
  const model::Interval ut = along(h.u, t), ub = along(h.u, b), vt = along(h.v, t),
                        vb = along(h.v, b);
  const double uu = (square(ut) + square(ub)).low, vv = (square(vt) + square(vb)).low,
               uv = (ut * vt + ub * vb).largest();
  const double least = (uu + vv) / 2 - std::hypot((uu - vv) / 2, uv);
  const double lean = 2 * std::sin(spread_rad / 2);
  const auto normal_part = [&](const model::Box3& box) {
    return along(box, n).widened(lean * longest(box));
  };
  const double a = normal_part(h.uu).high, d = normal_part(h.vv).high,
               c = normal_part(h.uv).largest();
  const double most = (a + d) / 2 + std::hypot((a - d) / 2, c);
  if (most <= 0) return 0.0;
  if (!(least > 0)) return std::nullopt;
  return most / least;
}

std::optional<double> bend_of(const SurfaceCell& cell, int halvings, const Vec3& n,
                              double spread_rad) {
  if (halvings == 0) return part_bend(cell, n, spread_rad);
  double most = 0;
  for (const SurfaceCell& half : halvings % 2 == 0 ? split_u(cell) : split_v(cell)) {
    const auto bend = bend_of(half, halvings - 1, n, spread_rad);
    if (!bend) return std::nullopt;
    most = std::max(most, *bend);
  }
  return most;
}

bool is_point(const SurfaceCell& cell) {
  return indexed(cell).is_point;
}

}  // namespace

std::optional<GraphRegion::Disc> GraphRegion::over(double radius_mm) const {
  Disc out;
  // Cells that lie over the disc whole, and hang together with the contact's by such.
  std::vector<bool> inside(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell& cell = cells[i];
    inside[i] = cell.far_mm < radius_mm && (i == 0 || inside[cell.from]);
    if (cell.near_mm >= radius_mm) continue;
    // Another sheet over the disc would lie over s, too.
    if (cell.near_mm <= 0 && !inside[i]) return std::nullopt;
    out.bend = std::max(out.bend, cell.bend);
    out.rise_mm = std::max(out.rise_mm, cell.rise_mm);
  }
  return out;
}

GraphRegions::GraphRegions(const std::vector<SurfaceCell>& cells, const ParameterIndex& index,
                           const PatchCharts& charts)
    : cells_(cells),
      index_(index),
      charts_(charts),
      points_(static_cast<std::size_t>(index.patch_count())),
      shapes_(cells.size()),
      known_(std::make_unique<std::once_flag[]>(cells.size())) {
  middles_.reserve(cells.size());
  radii_mm_.reserve(cells.size());
  for (const SurfaceCell& cell : cells) {
    middles_.push_back(middle(cell.shape));
    radii_mm_.push_back(control_radius(cell.shape, middles_.back()));
    largest_radius_mm_ = std::max(largest_radius_mm_, radii_mm_.back());
    const auto patch = static_cast<std::size_t>(cell.patch);
    if (is_point(cell) && patch < points_.size()) points_[patch].push_back(rect_of(cell));
  }
}

/// Whether S ends, has an edge or an irregular vertex along the cell.
bool GraphRegions::ends(std::uint32_t k) const {
  const SurfaceCell& cell = cells_[k];
  if (is_point(cell)) return true;
  const ParameterRect own = rect_of(cell);
  const auto goes_on = [&](bool at_side, int i, int j) {
    return !at_side || charts_.covers(cell.patch, i, j);
  };
  if (!goes_on(own.u0 == 0, -1, 0) || !goes_on(own.u1 == 1, 1, 0) || !goes_on(own.v0 == 0, 0, -1) ||
      !goes_on(own.v1 == 1, 0, 1))
    return true;
  const auto& around = charts_.around(cell.patch);
  return std::any_of(around.begin(), around.end(), [&](const PlacedPatch& placed) {
    const ParameterRect there = placed.to_own(own);
    const auto& points = points_[static_cast<std::size_t>(placed.patch)];
    return std::any_of(points.begin(), points.end(),
                       [&](const ParameterRect& point) { return point.touches(there); });
  });
}

std::vector<std::uint32_t> GraphRegions::neighbours(std::uint32_t k) const {
  std::vector<std::uint32_t> out;
  const ParameterRect own = rect_of(cells_[k]);
  for (const PlacedPatch& placed : charts_.around(cells_[k].patch)) {
    const ParameterRect there = placed.to_own(own);
    if (!there.touches({0, 1, 0, 1})) continue;
    index_.overlapping(placed.patch, there, [&](std::uint32_t other) {
      if (other != k) out.push_back(other);
    });
  }
  return out;
}

const GraphRegions::Shape& GraphRegions::shape(std::uint32_t k) const {
  std::call_once(known_[k], [&] {
    Shape out;
    if (!ends(k)) {
      const OffsetCell offset = offset_cell(cells_[k].shape, {});
      out.normal = offset.normal;
      out.cosine = std::cos(offset.spread_rad), out.sine = std::sin(offset.spread_rad);
      const bool has_plane = length_squared(offset.normal) > 0 && out.cosine > kLeastCosine;
      if (has_plane) out.bend = bend_of(cells_[k], kBendHalvings, offset.normal, offset.spread_rad);
      out.neighbours = neighbours(k);
    }
    shapes_[k] = std::make_unique<const Shape>(std::move(out));
  });
  return *shapes_[k];
}

/// One search over the cells about a contact.
class GraphRegions::Search {
 public:
  Search(const GraphRegions& in, const CellContact& contact, double widest_mm, double most_bend)
      : in_(in),
        contact_(contact),
        lean_(2 * std::sin(contact.alpha() / 2)),
        cosine_(std::cos(contact.alpha())),
        sine_(std::sin(contact.alpha())),
        most_bend_(most_bend) {
    region_.limit_mm = widest_mm;
  }

  std::optional<GraphRegion> from(std::uint32_t whole) {
    if (!look(whole, 0)) return std::nullopt;
    for (std::size_t i = 0; i < region_.cells.size(); ++i) {
      if (region_.cells[i].near_mm >= region_.limit_mm) continue;
      for (const std::uint32_t next : in_.shape(region_.cells[i].index).neighbours)
        if (!look(next, i)) return std::nullopt;
    }
    return std::move(region_);
  }

 private:
  /// False where no disc is left.
  bool look(std::uint32_t k, std::size_t from) {
    if (!seen_.add(k)) return !seen_.is_full();
    const GraphRegion::Cell cell = distances(k, from);
    if (cell.near_mm >= region_.limit_mm) return true;
    const auto bend = bend_over_plane(k);
    if (!bend || *bend > most_bend_ || region_.cells.size() >= kMostCells) {
      region_.limit_mm = std::min(region_.limit_mm, cell.near_mm);
      return cell.near_mm > 0;
    }
    region_.cells.push_back(cell);
    region_.cells.back().bend = *bend;
    return true;
  }

  GraphRegion::Cell distances(std::uint32_t k, std::size_t from) const {
    GraphRegion::Cell out{k, from, 0, 0, 0, 0};
    const Vec3 w = in_.middles_[k] - contact_.middle();
    const double both_mm = in_.radii_mm_[k] + contact_.radius() + kDistanceRounding_mm;
    out.far_mm = length(w) + both_mm;
    // The projections along n₀ and along n(s) differ by the sine of their angle at most.
    const double in_plane_mm = length(w - contact_.normal() * dot(w, contact_.normal()));
    out.near_mm = in_plane_mm - both_mm - lean_ * out.far_mm;
    out.rise_mm = w.z + both_mm;
    return out;
  }

  /// Of a normal turned by θ against the plane's: curvature over cos³θ.
  std::optional<double> bend_over_plane(std::uint32_t k) const {
    const Shape& shape = in_.shape(k);
    if (!shape.bend) return std::nullopt;
    const double c0 = std::min(1.0, dot(contact_.normal(), shape.normal));
    if (c0 <= kLeastCosine) return std::nullopt;
    const double s0 = std::sqrt(1 - c0 * c0);
    const double c1 = c0 * cosine_ - s0 * sine_, s1 = s0 * cosine_ + c0 * sine_;
    const double cosine = c1 * shape.cosine - std::abs(s1) * shape.sine;
    if (cosine <= kLeastCosine) return std::nullopt;
    return *shape.bend / (cosine * cosine * cosine);
  }

  /// Indices that were seen, of cells of a region and those beside them: room for 2048.
  class SeenCells {
   public:
    /// False where it was seen before. Once there is no room all count as seen.
    bool add(std::uint32_t index) {
      if (count_ * 2 > slots_.size()) return false;
      for (std::size_t at = index * 2654435761U % slots_.size();; at = (at + 1) % slots_.size()) {
        if (slots_[at] == index + 1) return false;
        if (slots_[at] != 0) continue;
        slots_[at] = index + 1;
        ++count_;
        return true;
      }
    }
    bool is_full() const { return count_ * 2 > slots_.size(); }

   private:
    std::array<std::uint32_t, 4096> slots_{};  // the index and 1; 0: free
    std::size_t count_ = 0;
  };

  const GraphRegions& in_;
  const CellContact& contact_;
  double lean_, cosine_, sine_, most_bend_;
  SeenCells seen_;
  GraphRegion region_;
};

std::optional<GraphRegion> GraphRegions::around(const CellContact& contact, std::uint32_t whole,
                                                double widest_mm, double most_bend) const {
  return Search(*this, contact, widest_mm, most_bend).from(whole);
}

}  // namespace limitgauge::verifier
