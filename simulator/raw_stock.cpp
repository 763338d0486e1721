#include "simulator/raw_stock.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limitgauge::simulator {
namespace {

using model::Vec3;

RawSample box_distance(const model::BoxStock& box, const Vec3& p) {
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

RawSample bar_distance(const model::CylinderStock& bar, const Vec3& p) {
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

}  // namespace

RawSample raw_distance(const model::Stock& stock, const Vec3& p) {
  if (const auto* box = std::get_if<model::BoxStock>(&stock)) return box_distance(*box, p);
  return bar_distance(std::get<model::CylinderStock>(stock), p);
}

double surface_area_mm2(const model::Stock& stock) {
  if (const auto* box = std::get_if<model::BoxStock>(&stock)) {
    const Vec3& s = box->size_mm;
    return 2 * (s.x * s.y + s.y * s.z + s.z * s.x);
  }
  const auto& bar = std::get<model::CylinderStock>(stock);
  return std::numbers::pi * bar.diameter_mm * (bar.diameter_mm / 2 + bar.height_mm);
}

}  // namespace limitgauge::simulator
