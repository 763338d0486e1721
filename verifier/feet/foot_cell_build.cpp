#include <algorithm>
#include <span>

#include "verifier/feet/distance_polynomial.h"
#include "verifier/feet/foot_cell.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Cells are halved until the second derivatives of the squared distance from their middle vary by
/// less than this part of the greatest: Newton then settles in two or three steps ...
constexpr double kVariation = 0.5;
/// ... and until that distance is proven convex with this part of its Hessian's determinant to
/// spare, for what the curvature of the surface takes off.
constexpr double kToSpare = 0.3;
/// Sine of the angle between the parameter lines below which a cell is taken as it is: where the
/// parameters degenerate (the rounded corner of one face) no halving evens the metric.
constexpr double kSkewed = 0.2;
constexpr int kMetricHalvings = 8;
/// Cells smaller than this hold few feet; there is no use in halving them.
constexpr double kSmall_mm = 1e-2;

FootCell::LocalBox box_around(const FootCell& cell, std::span<const Vec3> points) {
  FootCell::LocalBox box;
  for (int a = 0; a < 3; ++a) {
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(), [&](const Vec3& p, const Vec3& q) {
          return dot(p, cell.frame[a]) < dot(q, cell.frame[a]);
        });
    box[a] = {dot(*low, cell.frame[a]), dot(*high, cell.frame[a])};
  }
  return box;
}

/// Boxes around the control points of the second derivatives.
void bound_second_derivatives(FootCell& cell) {
  const Vec3 normal = normalized(cross(cell.middle.du, cell.middle.dv)),
             along = normalized(cell.middle.du);
  if (length_squared(normal) > 0.5) cell.frame = {along, cross(normal, along), normal};
  const Bezier& b = cell.shape;
  std::vector<Vec3> ss, st, tt;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const int k = 4 * j + i;
      if (i < 2) ss.push_back((b.control(k) - 2 * b.control(k + 1) + b.control(k + 2)) * 6);
      if (j < 2) tt.push_back((b.control(k) - 2 * b.control(k + 4) + b.control(k + 8)) * 6);
      if (i < 3 && j < 3)
        st.push_back((b.control(k) - b.control(k + 1) - b.control(k + 4) + b.control(k + 5)) * 9);
    }
  cell.ss = box_around(cell, ss), cell.st = box_around(cell, st), cell.tt = box_around(cell, tt);
}

FootCell whole(const Piece& piece) {
  FootCell cell;
  cell.shape = piece.shape;
  const ParameterSquare& q = piece.square;
  cell.patch = q.patch, cell.u = q.u, cell.v = q.v, cell.size_u = cell.size_v = q.size;
  return cell;
}

FootCell vertex_cell(const Speck& speck) {
  FootCell cell = whole({{}, speck.square});
  for (int k = 0; k < 16; ++k) cell.shape.set(k, speck.position);
  cell.middle = jet(cell.shape, 0.5, 0.5);
  cell.vertex_normal = speck.normal;
  cell.vertex_u = speck.tangent_u, cell.vertex_v = speck.tangent_v;
  cell.is_point = true;
  return cell;
}

bool is_even(const FootCell& cell, const HessianRange& h) {
  if (!(std::max(h.uu_high, h.vv_high) > 0)) return true;
  if (control_radius(cell.shape, cell.middle.position) < kSmall_mm) return true;
  const double vary_s = (h.uu_high - h.uu_low) / h.uu_high,
               vary_t = (h.vv_high - h.vv_low) / h.vv_high,
               vary_st = (h.uv_high - h.uv_low) / std::sqrt(h.uu_high * h.vv_high);
  if (std::max({vary_s, vary_t, vary_st}) > kVariation) return false;
  const BezierJet& j = cell.middle;
  const double area = length_squared(cross(j.du, j.dv)),
               square = length_squared(j.du) * length_squared(j.dv);
  const double twist = std::max(-h.uv_low, h.uv_high);
  return area < kSkewed * kSkewed * square ||
         (h.uu_low > 0 && h.uu_low * h.vv_low - twist * twist >= kToSpare * area);
}

void mark_sides(FootCell& cell, const PatchFeatures& features) {
  const std::array<bool, 4> on_side = {cell.v <= 0, cell.u + cell.size_u >= 1,
                                       cell.v + cell.size_v >= 1, cell.u <= 0};
  for (int k = 0; k < 4; ++k)
    if (on_side[k]) cell.sides[k] = features.sides[k];
}

void halve_until_even(FootCell cell, int depth, int halvings, std::vector<FootCell>& out) {
  cell.middle = jet(cell.shape, 0.5, 0.5);
  const HessianRange h = hessian_range(distance_polynomial(cell.shape, cell.middle.position));
  if (depth >= halvings || is_even(cell, h)) {
    cell.own_ss = {h.uu_low, h.uu_high}, cell.own_tt = {h.vv_low, h.vv_high};
    cell.own_st = {h.uv_low, h.uv_high};
    bound_second_derivatives(cell);
    out.push_back(cell);
    return;
  }
  const bool in_s = h.uu_high >= h.vv_high;
  const auto halves = in_s ? split_u(cell.shape) : split_v(cell.shape);
  double& size = in_s ? cell.size_u : cell.size_v;
  double& start = in_s ? cell.u : cell.v;
  size /= 2;
  for (const Bezier& half : halves) {
    cell.shape = half;
    halve_until_even(cell, depth + 1, halvings, out);
    start += size;
  }
}

}  // namespace

std::vector<FootCell> foot_cells(const SurfaceTree& tree) {
  std::vector<FootCell> cells;
  // On a facet Newton's method finds the foot whatever the parameters are: nothing bends.
  const int halvings = tree.is_faceted() ? 0 : kMetricHalvings;
  for (const Speck& s : tree.specks()) cells.push_back(vertex_cell(s));
  for (int patch = 0; patch < tree.patch_count(); ++patch)
    for (const Piece& piece : tree.pieces_beyond(patch, kFootOmitted_mm))
      halve_until_even(whole(piece), 0, halvings, cells);
  for (FootCell& cell : cells) mark_sides(cell, tree.features().of(cell.patch));
  return cells;
}

}  // namespace limitgauge::verifier
