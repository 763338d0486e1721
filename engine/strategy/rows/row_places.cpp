#include "engine/strategy/rows/row_places.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/strategy/rows/drive_rows.h"
#include "model/base/chunks.h"

namespace limitgauge::engine::strategy {
namespace {

/// cos 75: steeper surfaces across the rows are not served by rows.
constexpr double kSteepestCosine = 0.2588;
constexpr std::size_t kSamplesAChunk = 64;

class Placer {
 public:
  Placer(const LimitLocations& limit, const StageRequest& request, const model::RunControl& control)
      : limit_(limit),
        request_(request),
        control_(control),
        places_{DriveFrame(request.cut.angle_deg), 0, 0, {}} {}

  RowPlaces place() {
    measure();
    if (request_.cut.scallop_mm) {
      place_by_scallop(tip_distance_mm(request_));
    } else {
      places_.across = even_places(low_, high_, request_.cut.step_mm);
    }
    return std::move(places_);
  }

 private:
  void measure() {
    model::Box3 box;  // in rows' coordinates
    const surface::OffsetSampler& sampler = limit_.sampler;
    for (int patch = 0; patch < sampler.patches(); ++patch)
      for (const Vec3& p : sampler.grid(patch, 0).points) box.add(places_.frame.to_drive(p));
    box = box.grown(request_.cutter.radius_mm() + limit_.kept_mm);
    places_.along_low = box.low.x;
    places_.along_high = box.high.x;
    low_ = box.low.y;
    high_ = box.high.y;
  }

  void place_by_scallop(double distance) {
    const double closest = distance * kSteepestCosine;
    // The first row half a step inside: beyond it nothing but the rim is touched.
    double at = low_ + closest / 2;
    while (at < high_) {
      places_.across.push_back(at);
      control_.check();
      double step = std::min(distance, request_.cut.step_mm);
      // Slopes change with the step: what the first guess asks for is asked again.
      constexpr int kGuesses = 3;
      for (int guess = 0; guess < kGuesses; ++guess)
        step = std::max(closest, largest_step(at, step, distance));
      at += step;
    }
  }

  /// Least of what the places along the row allow, judged by their slope over `step`.
  double largest_step(double across, double step, double distance) const {
    const double spacing = std::min(request_.cut.step_mm, request_.cutter.radius_mm() / 2);
    const auto count =
        1 + static_cast<std::size_t>((places_.along_high - places_.along_low) / spacing);
    std::vector<double> allowed(count, step);
    model::parallel_chunks(
        count, kSamplesAChunk, control_, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            const double along = places_.along_low + static_cast<double>(i) * spacing;
            const Vec3 a = places_.at(along, across), b = places_.at(along, across + step);
            const auto za = limit_.surface.tip_z(a.x, a.y), zb = limit_.surface.tip_z(b.x, b.y);
            if (!za || !zb) continue;
            const double rise =
                std::max(*zb, request_.floor_z_mm) - std::max(*za, request_.floor_z_mm);
            const double cosine = step / std::hypot(step, rise);
            if (cosine > kSteepestCosine) allowed[i] = std::min(step, distance * cosine);
          }
        });
    return *std::min_element(allowed.begin(), allowed.end());
  }

  const LimitLocations& limit_;
  const StageRequest& request_;
  const model::RunControl& control_;
  RowPlaces places_;
  double low_ = 0, high_ = 0;
};

}  // namespace

double tip_distance_mm(const StageRequest& request) {
  if (!request.cut.scallop_mm) return request.cut.step_mm;
  const double r = request.cutter.corner_radius_mm, h = std::min(*request.cut.scallop_mm, r);
  if (r <= 0)
    throw std::invalid_argument(
        "scallop: a cutter without a corner radius leaves steps, not cusps; give a step only");
  return std::min(request.cut.step_mm, 2 * std::sqrt(2 * r * h - h * h));
}

RowPlaces place_rows(const LimitLocations& limit, const StageRequest& request,
                     const model::RunControl& control) {
  return Placer(limit, request, control).place();
}

}  // namespace limitgauge::engine::strategy
