#include "simulator/instrument/turned_lines.h"

#include <optional>
#include <utility>
#include <vector>

#include "simulator/instrument/stock_rays.h"
#include "simulator/stock/material.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

constexpr Vec3 kUp{0, 0, 1};
/// How far a ray looks ahead where it follows a surface: which side of it is material, no place on
/// it can tell.
constexpr double kAlongSurface_mm = 1e-3;

/// Material on one line, as rays come upon it.
class Line {
 public:
  /// What begins or ends here.
  void change_at(double z) {
    if (begin_) add(*begin_, z);
    begin_ = begin_ ? std::nullopt : std::optional(z);
  }
  bool in_material() const { return begin_.has_value(); }
  std::vector<model::Interval> take() { return std::move(material_); }

 private:
  void add(double low, double high) {
    if (high - low >= kDexelRounding_mm) material_.push_back({low, high});
  }

  std::optional<double> begin_;
  std::vector<model::Interval> material_;
};

/// From below the stock's box to above it.
std::vector<model::Interval> material_on(const StockRays& rays, const model::Box3& box, double x,
                                         double y) {
  constexpr double kStep_mm = 2 * kLeastFeature_mm;
  const double end = box.high.z + kStep_mm;
  Line line;
  for (double z = box.low.z - kStep_mm; z < end;) {
    const StockRays::Run run = rays.run({x, y, z}, kUp, end - z);
    // It changed where the ray followed a surface.
    if (run.material != line.in_material()) line.change_at(z);
    const double reached = z + run.length_mm;
    if (run.ends) line.change_at(reached + kLeastFeature_mm / 2);
    z = reached + (run.ends ? kStep_mm : kAlongSurface_mm);
  }
  if (line.in_material()) line.change_at(box.high.z);
  return line.take();
}

}  // namespace

DexelStock turned_lines(const StockModel& stock, double spacing_mm,
                        const model::RunControl& control) {
  const StockRays rays(stock);
  const model::Box3& box = stock.material().raw().box();
  return {stock.material().raw().stock(), spacing_mm,
          [&](double x, double y) { return material_on(rays, box, x, y); }, control};
}

}  // namespace limitgauge::simulator
