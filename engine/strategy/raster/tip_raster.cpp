#include "engine/strategy/raster/tip_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/strategy/locations/ball_sections.h"
#include "model/base/chunks.h"

namespace limitgauge::engine::strategy {
namespace {

constexpr double kNothingUnder = -std::numeric_limits<double>::infinity();

Raster nodes_over(const model::Box3& window, double spacing_mm) {
  constexpr double kMostNodes = 4e6;
  const Vec3 size = window.size();
  Raster raster;
  raster.pixel_mm = std::max(spacing_mm, std::sqrt(size.x * size.y / kMostNodes));
  raster.x0 = window.low.x;
  raster.y0 = window.low.y;
  raster.columns = 1 + static_cast<int>(std::ceil(size.x / raster.pixel_mm));
  raster.rows = 1 + static_cast<int>(std::ceil(size.y / raster.pixel_mm));
  return raster;
}

/// Heights of an envelope at the nodes of a row, the higher one at a step, less `lower_mm`.
void fill_row(const Envelope& envelope, const Raster& raster, double lower_mm, double* row) {
  for (const auto& run : envelope.runs) {
    const double first = std::ceil((run.front().s - raster.x0) / raster.pixel_mm);
    int i = static_cast<int>(std::clamp(first, 0.0, static_cast<double>(raster.columns)));
    for (std::size_t k = 1; k < run.size() && i < raster.columns; ++k) {
      const PlanePoint &a = run[k - 1], &b = run[k];
      for (; i < raster.columns && raster.x(i) <= b.s; ++i) {
        const double share = b.s > a.s ? std::max(0.0, (raster.x(i) - a.s) / (b.s - a.s)) : 1;
        row[i] = std::max(row[i], a.z + (b.z - a.z) * share - lower_mm);
      }
    }
  }
}

}  // namespace

TipRaster make_tip_raster(const CutterLocations& locations, const model::Box3& window,
                          double spacing_mm, const model::RunControl& control) {
  constexpr std::size_t kRowsAChunk = 4;
  TipRaster tips{nodes_over(window, spacing_mm), {}};
  const Raster& raster = tips.raster;
  tips.z.resize(raster.size());
  const auto rows = static_cast<std::size_t>(raster.rows);
  model::parallel_chunks(rows, kRowsAChunk, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j)
      for (int i = 0; i < raster.columns; ++i)
        tips.z[j * static_cast<std::size_t>(raster.columns) + i] =
            locations.tip_z(raster.x(i), raster.y(static_cast<double>(j))).value_or(kNothingUnder);
  });
  return tips;
}

TipRaster make_ball_raster(const surface::PatchModel& model, const StageRequest& request,
                           const model::Box3& window, double spacing_mm,
                           const model::RunControl& control) {
  TipRaster tips{nodes_over(window, spacing_mm), {}, request.cut.tolerance_mm};
  const Raster& raster = tips.raster;
  tips.z.assign(raster.size(), kNothingUnder);
  const BallSections sections(model, request, DriveFrame(0), 0, control);
  std::vector<double> across;
  for (int j = 0; j < raster.rows; ++j) across.push_back(raster.y(j));
  sections.each_envelope(across, control, [&](std::size_t row, const Envelope& envelope) {
    fill_row(envelope, raster, request.cutter.radius_mm(),
             &tips.z[row * static_cast<std::size_t>(raster.columns)]);
  });
  return tips;
}

}  // namespace limitgauge::engine::strategy
