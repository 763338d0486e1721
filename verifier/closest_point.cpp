#include "verifier/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitgauge::verifier {
namespace {

using model::Vec3;

constexpr int kNewtonSteps = 12;
constexpr double kSettled = 1e-14;  // of the cell's parameters
/// Sine of the angle between connection and normal up to which a foot counts as perpendicular: far
/// above Newton's residual, far below what a boundary point shows to any but its own wedge.
constexpr double kPerpendicular = 1e-5;

struct Foot {
  double s = 0.5, t = 0.5;
  double squared = std::numeric_limits<double>::infinity();
  const SurfaceCell* cell = nullptr;
};

/// Newton for the nearest point within the cell's square: variables at a side that the step pushes
/// against are held there. False where it does not settle.
bool newton(const SurfaceCell& cell, const Vec3& p, double& s, double& t) {
  for (int step = 0; step < kNewtonSteps; ++step) {
    const BezierJet j = jet(cell.shape, s, t);
    const Vec3 r = j.position - p;
    const double gs = dot(r, j.du), gt = dot(r, j.dv);
    double hss = dot(j.du, j.du) + dot(r, j.duu), hst = dot(j.du, j.dv) + dot(r, j.duv),
           htt = dot(j.dv, j.dv) + dot(r, j.dvv);
    if (hss * htt - hst * hst <= 0 || hss <= 0) {  // not convex here: Gauss-Newton goes downhill
      hss = dot(j.du, j.du), hst = dot(j.du, j.dv), htt = dot(j.dv, j.dv);
    }
    const bool hold_s = (s <= 0 && gs > 0) || (s >= 1 && gs < 0);
    const bool hold_t = (t <= 0 && gt > 0) || (t >= 1 && gt < 0);
    double ds = 0, dt = 0;
    const double det = hss * htt - hst * hst;
    if (!hold_s && !hold_t && det > 0) {
      ds = -(htt * gs - hst * gt) / det, dt = -(hss * gt - hst * gs) / det;
    } else {
      if (!hold_s && hss > 0) ds = -gs / hss;
      if (!hold_t && htt > 0) dt = -gt / htt;
      if (!hold_s && !hold_t) dt = 0;
    }
    const double s1 = std::clamp(s + ds, 0.0, 1.0), t1 = std::clamp(t + dt, 0.0, 1.0);
    const double moved = std::abs(s1 - s) + std::abs(t1 - t);
    s = s1, t = t1;
    if (moved < kSettled) return true;
  }
  return false;
}

void improve(Foot& best, const SurfaceCell& cell, const Vec3& p, double s, double t) {
  const double squared = length_squared(point(cell.shape, s, t) - p);
  if (squared < best.squared) best = {s, t, squared, &cell};
}

/// Where Newton does not settle: halve the parameter rectangle by its hull until it is a point.
void search(const SurfaceCell& cell, const Vec3& p, double s0, double s1, double t0, double t1,
            Foot& best) {
  const Bezier part = restrict(cell.shape, s0, s1, t0, t1);
  if (distance_squared(control_box(part), p) >= best.squared) return;
  const double s = (s0 + s1) / 2, t = (t0 + t1) / 2;
  improve(best, cell, p, s, t);
  if (control_radius(part, point(part, 0.5, 0.5)) < 1e-11) return;
  if (s1 - s0 >= t1 - t0) {
    search(cell, p, s0, s, t0, t1, best);
    search(cell, p, s, s1, t0, t1, best);
  } else {
    search(cell, p, s0, s1, t0, t, best);
    search(cell, p, s0, s1, t, t1, best);
  }
}

void in_cell(const SurfaceCell& cell, const Vec3& p, Foot& best) {
  if (distance_squared(control_box(cell.shape), p) >= best.squared) return;
  double s = 0.5, t = 0.5;
  const bool settled = newton(cell, p, s, t);
  improve(best, cell, p, s, t);
  if (!settled) search(cell, p, 0, 1, 0, 1, best);
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
  struct Entry {
    std::uint32_t node;
    double squared;
  };
  thread_local std::vector<Entry> stack;
  stack.clear();
  if (!cells.nodes().empty()) stack.push_back({0, distance_squared(cells.nodes()[0].box, p)});
  while (!stack.empty()) {
    const auto [at, squared] = stack.back();
    stack.pop_back();
    if (squared >= best.squared) continue;
    const SurfaceCells::Node& node = cells.nodes()[at];
    if (node.count > 0) {
      for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
        in_cell(cells.cells()[k], p, best);
      continue;
    }
    const Entry left{at + 1, distance_squared(cells.nodes()[at + 1].box, p)};
    const Entry right{node.right, distance_squared(cells.nodes()[node.right].box, p)};
    const bool left_first = left.squared <= right.squared;
    stack.push_back(left_first ? right : left);
    stack.push_back(left_first ? left : right);
  }
  if (best.cell == nullptr) return std::nullopt;
  return describe(best, p);
}

}  // namespace limitgauge::verifier
