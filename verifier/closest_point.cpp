#include "verifier/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verifier/nearest_first.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

constexpr int kNewtonSteps = 20;
/// Newton has settled when a step is below this part of the cell: squared, it is below rounding.
constexpr double kSettled = 1e-9;
/// Relative change of the squared distance that is lost in rounding.
constexpr double kLevel = 1e-13;
/// Halvings of a cell in which Newton did not settle.
constexpr int kHalvings = 12;
/// Sine of the angle between connection and normal up to which a foot counts as perpendicular: far
/// above Newton's residual, far below what a boundary point shows to any but its own wedge.
constexpr double kPerpendicular = 1e-5;

struct Foot {
  double s = 0.5, t = 0.5;
  double squared = std::numeric_limits<double>::infinity();
  const SurfaceCell* cell = nullptr;
};

/// A rectangle of a cell's parameters.
struct Window {
  double s0 = 0, s1 = 1, t0 = 0, t1 = 1;
};

struct Step {
  double ds = 0, dt = 0;
};

/// Newton's step for half the squared distance, Gauss-Newton where that is not convex; a variable
/// at a side that the gradient pushes against is held there.
Step downhill(const BezierJet& j, const Vec3& r, const Window& w, double s, double t) {
  const double gs = dot(r, j.du), gt = dot(r, j.dv);
  double hss = dot(j.du, j.du) + dot(r, j.duu), hst = dot(j.du, j.dv) + dot(r, j.duv),
         htt = dot(j.dv, j.dv) + dot(r, j.dvv);
  if (hss <= 0 || hss * htt - hst * hst <= 0)
    hss = dot(j.du, j.du), hst = dot(j.du, j.dv), htt = dot(j.dv, j.dv);
  const bool hold_s = (s <= w.s0 && gs > 0) || (s >= w.s1 && gs < 0);
  const bool hold_t = (t <= w.t0 && gt > 0) || (t >= w.t1 && gt < 0);
  const double det = hss * htt - hst * hst;
  if (!hold_s && !hold_t && det > 0)
    return {-(htt * gs - hst * gt) / det, -(hss * gt - hst * gs) / det};
  return {!hold_s && hss > 0 ? -gs / hss : 0, hold_s && !hold_t && htt > 0 ? -gt / htt : 0};
}

/// The nearest point within the window, from its middle: steps that do not come nearer are halved.
/// False where that does not settle.
bool newton(const SurfaceCell& cell, const Vec3& p, const Window& w, double& s, double& t) {
  BezierJet j = jet(cell.shape, s, t);
  double squared = length_squared(j.position - p);
  for (int n = 0; n < kNewtonSteps; ++n) {
    Step step = downhill(j, j.position - p, w, s, t);
    for (int halving = 0;; ++halving) {
      const double s1 = std::clamp(s + step.ds, w.s0, w.s1),
                   t1 = std::clamp(t + step.dt, w.t0, w.t1);
      if (std::abs(s1 - s) + std::abs(t1 - t) < kSettled) {
        s = s1, t = t1;
        return true;
      }
      const BezierJet there = jet(cell.shape, s1, t1);
      const double now = length_squared(there.position - p);
      // Near the foot the distance is level to rounding: there a Newton step is trusted as it is.
      if (now <= squared + kLevel * (squared + 1)) {
        s = s1, t = t1, j = there, squared = now;
        break;
      }
      if (halving > 30) return true;  // no way down is left above rounding
      step = {step.ds / 2, step.dt / 2};
    }
  }
  return false;
}

/// Searches a window of a cell; halves it where Newton does not settle.
void search(const SurfaceCell& cell, const Bezier& part, const Vec3& p, const Window& w, int depth,
            Foot& best) {
  if (distance_squared(control_box(part), p) >= best.squared) return;
  double s = (w.s0 + w.s1) / 2, t = (w.t0 + w.t1) / 2;
  const bool settled = newton(cell, p, w, s, t);
  const double squared = length_squared(point(cell.shape, s, t) - p);
  if (squared < best.squared) best = {s, t, squared, &cell};
  if (settled || depth >= kHalvings) return;
  const bool in_s = w.s1 - w.s0 >= w.t1 - w.t0;
  const double ms = (w.s0 + w.s1) / 2, mt = (w.t0 + w.t1) / 2;
  const auto halves = in_s ? split_u(part) : split_v(part);
  search(cell, halves[0], p, in_s ? Window{w.s0, ms, w.t0, w.t1} : Window{w.s0, w.s1, w.t0, mt},
         depth + 1, best);
  search(cell, halves[1], p, in_s ? Window{ms, w.s1, w.t0, w.t1} : Window{w.s0, w.s1, mt, w.t1},
         depth + 1, best);
}

void in_cell(const SurfaceCell& cell, const Vec3& p, Foot& best) {
  search(cell, cell.shape, p, {}, 0, best);
}

ClosestPoint describe(const Foot& foot, const Vec3& p) {
  ClosestPoint out;
  const BezierJet j = jet(foot.cell->shape, foot.s, foot.t);
  out.place = {foot.cell->patch, foot.cell->u_at(foot.s), foot.cell->v_at(foot.t), j.position};
  out.normal = normalized(cross(j.du, j.dv));
  out.distance_mm = std::sqrt(foot.squared);
  const Vec3 to = p - j.position;
  const Vec3 aside = to - out.normal * dot(to, out.normal);
  out.perpendicular = length(aside) <= kPerpendicular * out.distance_mm + 1e-9;
  return out;
}

}  // namespace

std::optional<ClosestPoint> closest_point(const SurfaceCells& cells, const Vec3& p,
                                          double within_mm) {
  Foot best;
  best.squared = within_mm * within_mm;
  nearest_first(
      cells.nodes(), [&](const SurfaceCells::Node& node) { return distance_squared(node.box, p); },
      [&](double squared) { return squared >= best.squared; },
      [&](const SurfaceCells::Node& leaf) {
        for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k)
          in_cell(cells.cells()[k], p, best);
      });
  if (best.cell == nullptr) return std::nullopt;
  return describe(best, p);
}

}  // namespace limitgauge::verifier
