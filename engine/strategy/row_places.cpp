#include "engine/strategy/row_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "engine/model/chunks.h"

namespace limitgauge::engine::strategy {
namespace {

/// Of a step: the mesh is a little smaller than the surface.
constexpr double kWholeStep = 0.1;
/// cos 75: steeper surfaces across the rows are not served by rows.
constexpr double kSteepestCosine = 0.2588;
constexpr std::size_t kSamplesAChunk = 64;

/// Directions to the bit for the angles that matter most.
Vec3 direction_of(double angle_deg) {
  const double quarter = angle_deg / 90;
  if (quarter == std::floor(quarter)) {
    const auto turns = static_cast<int>(std::fmod(std::fmod(quarter, 4) + 4, 4));
    constexpr Vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    return axes[turns];
  }
  const double angle = angle_deg * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle), 0};
}

class Placer {
 public:
  Placer(const LimitLocations& limit, const StageRequest& request, const model::RunControl& control)
      : limit_(limit), request_(request), control_(control) {}

  RowPlaces place() {
    places_.direction = direction_of(request_.cut.angle_deg);
    places_.left = {-places_.direction.y, places_.direction.x, 0};
    measure();
    if (request_.cut.scallop_mm) {
      place_by_scallop(tip_distance_mm(request_));
    } else {
      place_evenly();
    }
    return std::move(places_);
  }

 private:
  void measure() {
    model::Box3 box;  // in rows' coordinates
    for (const surface::Grid& grid : limit_.mesh.grids)
      for (const Vec3& p : grid.points)
        box.add(Vec3{dot(p, places_.direction), dot(p, places_.left), 0});
    box = box.grown(request_.cutter.radius_mm() + limit_.kept_mm);
    places_.along_low = box.low.x;
    places_.along_high = box.high.x;
    low_ = box.low.y;
    high_ = box.high.y;
  }

  void place_evenly() {
    const double width = high_ - low_, step = request_.cut.step_mm;
    const int count = std::max(1, static_cast<int>(std::floor(width / step + kWholeStep)));
    const double first = low_ + (width - (count - 1) * step) / 2;
    for (int i = 0; i < count; ++i) places_.across.push_back(first + i * step);
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
  const double r = corner_radius_mm(request.cutter), h = std::min(*request.cut.scallop_mm, r);
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
