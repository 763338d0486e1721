#include "engine/strategy/raster/stock_outline.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limitgauge::engine::strategy {
namespace {

/// How far `p` lies beyond each side: -X, +X, -Y, +Y.
std::array<double, 4> beyond(const model::BoxStock& box, const FlatPoint& p) {
  return {box.corner_mm.x - p.x, p.x - box.corner_mm.x - box.size_mm.x, box.corner_mm.y - p.y,
          p.y - box.corner_mm.y - box.size_mm.y};
}

}  // namespace

StockOutline::StockOutline(const model::Stock& stock) : stock_(planned_stock(stock)) {}

double StockOutline::distance_mm(const FlatPoint& p) const {
  if (const auto* bar = std::get_if<model::CylinderStock>(&stock_))
    return std::hypot(p.x - bar->base_mm.x, p.y - bar->base_mm.y) - bar->diameter_mm / 2;
  const auto out = beyond(std::get<model::BoxStock>(stock_), p);
  const double x = std::max(out[0], out[1]), y = std::max(out[2], out[3]);
  return std::hypot(std::max(x, 0.0), std::max(y, 0.0)) + std::min(0.0, std::max(x, y));
}

FlatPoint StockOutline::outward(const FlatPoint& p) const {
  if (const auto* bar = std::get_if<model::CylinderStock>(&stock_)) {
    const double x = p.x - bar->base_mm.x, y = p.y - bar->base_mm.y, r = std::hypot(x, y);
    return r > 0 ? FlatPoint{x / r, y / r} : FlatPoint{1, 0};
  }
  constexpr std::array<FlatPoint, 4> kWays = {{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
  const auto out = beyond(std::get<model::BoxStock>(stock_), p);
  return kWays[static_cast<std::size_t>(std::max_element(out.begin(), out.end()) - out.begin())];
}

}  // namespace limitgauge::engine::strategy
