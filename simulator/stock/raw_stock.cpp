#include "simulator/stock/raw_stock.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limitgauge::simulator {
namespace {

using model::Vec3;

RawSample shape_distance(const model::BoxStock& box, const Vec3& p) {
  const Vec3 half = box.size_mm * 0.5, q = p - (box.corner_mm + half);
  Vec3 over, away;
  int nearest_face = 0;
  for (int a = 0; a < 3; ++a) {
    over[a] = std::abs(q[a]) - half[a];
    away[a] = std::max(over[a], 0.0);
    if (over[a] > over[nearest_face]) nearest_face = a;
  }
  Vec3 g;
  if (over[nearest_face] <= 0) {
    g[nearest_face] = q[nearest_face] < 0 ? -1 : 1;
    return {over[nearest_face], g};
  }
  const double d = length(away);
  for (int a = 0; a < 3; ++a) g[a] = std::copysign(away[a] / d, q[a]);
  return {d, g};
}

RawSample shape_distance(const model::CylinderStock& bar, const Vec3& p) {
  const double half = bar.height_mm / 2, x = p.x - bar.base_mm.x, y = p.y - bar.base_mm.y;
  const double z = p.z - bar.base_mm.z - half, rho = std::sqrt(x * x + y * y);
  const double side = rho - bar.diameter_mm / 2, end = std::abs(z) - half;
  double g_rho = side >= end ? 1 : 0, g_z = side >= end ? 0 : 1, d = std::max(side, end);
  if (side > 0 && end > 0) {
    d = std::sqrt(side * side + end * end);
    g_rho = side / d, g_z = end / d;
  }
  const double level = rho > 0 ? g_rho / rho : 0.0;
  return {d, {level * x, level * y, std::copysign(g_z, z)}};
}

RawSample leaning_distance(const model::LeaningStock& stock, const Vec3& p) {
  const Vec3 own = stock.pose.point_back(p);
  const RawSample s =
      std::visit([&](const auto& shape) { return shape_distance(shape, own); }, stock.upright);
  return {s.distance, stock.pose.direction(s.gradient)};
}

double area_mm2(const model::BoxStock& box) {
  const Vec3& s = box.size_mm;
  return 2 * (s.x * s.y + s.y * s.z + s.z * s.x);
}
double area_mm2(const model::CylinderStock& bar) {
  return std::numbers::pi * bar.diameter_mm * (bar.diameter_mm / 2 + bar.height_mm);
}
double area_mm2(const model::LeaningStock& stock) {
  return std::visit([](const auto& shape) { return area_mm2(shape); }, stock.upright);
}

}  // namespace

RawStock::RawStock(const model::Stock& stock) : stock_(stock) {
  require_valid(stock);
  box_ = bounding_box(stock);
  if (const auto* mesh = std::get_if<model::MeshStock>(&stock)) solid_.emplace(mesh->mesh);
}

RawSample RawStock::distance(const Vec3& p) const {
  if (const auto* box = std::get_if<model::BoxStock>(&stock_)) return shape_distance(*box, p);
  if (const auto* bar = std::get_if<model::CylinderStock>(&stock_)) return shape_distance(*bar, p);
  if (const auto* leaning = std::get_if<model::LeaningStock>(&stock_))
    return leaning_distance(*leaning, p);
  const SolidSample s = solid_->sample(p);
  return {s.distance, s.gradient};
}

void RawStock::distances_up(const Vec3& p, double step_mm, std::span<double> out) const {
  if (solid_) return solid_->distances_up(p, step_mm, out);
  for (std::size_t n = 0; n < out.size(); ++n)
    out[n] = distance({p.x, p.y, p.z + static_cast<double>(n) * step_mm}).distance;
}

double RawStock::surface_area_mm2() const {
  if (solid_) return solid_->area_mm2();
  if (const auto* box = std::get_if<model::BoxStock>(&stock_)) return area_mm2(*box);
  if (const auto* bar = std::get_if<model::CylinderStock>(&stock_)) return area_mm2(*bar);
  return area_mm2(std::get<model::LeaningStock>(stock_));
}

}  // namespace limitgauge::simulator
