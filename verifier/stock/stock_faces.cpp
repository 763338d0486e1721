#include "verifier/stock/stock_faces.h"

#include <cmath>

namespace limitgauge::verifier {
namespace {

using model::Vec3;

constexpr std::uint32_t kBarSide = 2;

}  // namespace

std::optional<StockFaces> StockFaces::of(const model::Stock& stock) {
  if (const auto* box = std::get_if<model::BoxStock>(&stock)) return StockFaces({*box, {}});
  if (const auto* bar = std::get_if<model::CylinderStock>(&stock)) return StockFaces({*bar, {}});
  if (const auto* leaning = std::get_if<model::LeaningStock>(&stock)) return StockFaces(*leaning);
  return std::nullopt;
}

StockFaces::StockFaces(const model::LeaningStock& stock)
    : stock_(stock),
      box_(std::visit([](const auto& shape) { return bounding_box(model::Stock(shape)); },
                      stock.upright)),
      leans_(stock.pose != model::Pose{}) {}

BodyDistance StockFaces::distance(std::uint32_t face, const Vec3& p) const {
  if (!leans_) return upright_distance(face, p);
  BodyDistance d = upright_distance(face, stock_.pose.point_back(p));
  d.gradient = stock_.pose.direction(d.gradient);
  return d;
}

BodyDistance StockFaces::upright_distance(std::uint32_t face, const Vec3& p) const {
  const auto* round = bar();
  if (!round) {
    const int axis = static_cast<int>(face / 2);
    Vec3 inwards;
    inwards[axis] = face % 2 == 0 ? 1 : -1;
    return {face % 2 == 0 ? p[axis] - box_.low[axis] : box_.high[axis] - p[axis], inwards, 0};
  }
  if (face != kBarSide)
    return {face == 0 ? p.z - box_.low.z : box_.high.z - p.z, {0, 0, face == 0 ? 1.0 : -1.0}, 0};
  const double dx = p.x - round->base_mm.x, dy = p.y - round->base_mm.y, rho = std::hypot(dx, dy);
  const double scale = rho > 0 ? -1 / rho : 0;
  return {round->diameter_mm / 2 - rho, {dx * scale, dy * scale, 0}, 0};
}

bool StockFaces::is_concave(std::uint32_t face) const {
  return bar() && face == kBarSide;
}

}  // namespace limitgauge::verifier
