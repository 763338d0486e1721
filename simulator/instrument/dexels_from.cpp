#include "simulator/instrument/dexels_from.h"

#include <algorithm>
#include <vector>

#include "simulator/instrument/dexel_grid.h"
#include "simulator/instrument/stock_rays.h"
#include "simulator/stock/material.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Interval;
using model::Vec3;

// A floor of the setup before is often a wall here, and a program's round numbers may put it right
// along a line, where rounding would decide between material and air at every step. The lines are
// walked this far beside themselves: in two directions, by shares of a step that no program has.
constexpr double kBeside_x_mm = 1.7e-7, kBeside_y_mm = 2.3e-7;
static_assert(kBeside_x_mm + kBeside_y_mm + kLeastFeature_mm <= kTakenOver_mm);

void append(std::vector<Interval>& material, const Interval& piece) {
  if (piece.high - piece.low < kDexelRounding_mm) return;
  if (!material.empty() && piece.low - material.back().high < kDexelRounding_mm)
    material.back().high = piece.high;
  else
    material.push_back(piece);
}

/// What stands on a line between the ends of one piece of the raw stock.
void walk(const StockRays& rays, double x, double y, const Interval& raw,
          std::vector<Interval>& material) {
  double z = raw.low;
  while (raw.high - z >= kDexelRounding_mm) {
    const StockRays::Run run = rays.run_in_raw({x, y, z}, {0, 0, 1}, raw.high - z);
    const double end = std::min(raw.high, z + std::max(run.length_mm, kDexelRounding_mm));
    if (run.material) append(material, {z, end});
    z = end;
  }
}

}  // namespace

DexelStock dexels_from(const StockModel& stock, double spacing_mm,
                       const model::RunControl& control) {
  const StockRays rays(stock);
  const RawStock& raw = stock.material().raw();
  const auto standing = [&](double line_x, double line_y) {
    const double x = line_x + kBeside_x_mm, y = line_y + kBeside_y_mm;
    std::vector<Interval> material;
    for (const Interval& piece : raw_on_line(raw, x, y)) walk(rays, x, y, piece, material);
    return material;
  };
  return {raw.box(), spacing_mm, standing, control};
}

}  // namespace limitgauge::simulator
