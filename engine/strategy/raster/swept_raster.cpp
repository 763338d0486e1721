#include "engine/strategy/raster/swept_raster.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "engine/tolerance.h"
#include "model/geometry/interval.h"

namespace limitgauge::engine::strategy {
namespace {

using model::Interval;

Interval disc_span(const FlatPoint& centre, double radius, double y) {
  const double dy = y - centre.y, square = radius * radius - dy * dy;
  if (square < 0) return Interval::none();
  const double half = std::sqrt(square);
  return {centre.x - half, centre.x + half};
}

/// Where low <= slope x + offset <= high.
Interval strip_span(double slope, double offset, double low, double high) {
  if (std::abs(slope) < kLevelLine)
    return offset >= low && offset <= high ? Interval::all() : Interval::none();
  const double a = (low - offset) / slope, b = (high - offset) / slope;
  return {std::min(a, b), std::max(a, b)};
}

/// A disc moved along a straight line, row by row: convex, so each row meets it in one span.
class Capsule {
 public:
  Capsule(const FlatPoint& a, const FlatPoint& b, double radius)
      : a_(a), b_(b), radius_(radius), length_(distance(a, b)) {
    if (length_ > 0) way_ = {(b.x - a.x) / length_, (b.y - a.y) / length_};
  }

  double low_y() const { return std::min(a_.y, b_.y) - radius_; }
  double high_y() const { return std::max(a_.y, b_.y) + radius_; }
  Interval at(double y) const {
    Interval span = disc_span(a_, radius_, y);
    if (length_ <= 0) return span;
    span.add(disc_span(b_, radius_, y));
    const double dy = y - a_.y;
    const Interval along = strip_span(way_.x, dy * way_.y - a_.x * way_.x, 0, length_);
    const Interval across = strip_span(-way_.y, dy * way_.x + a_.x * way_.y, -radius_, radius_);
    span.add(Interval{std::max(along.low, across.low), std::min(along.high, across.high)});
    return span;
  }

 private:
  FlatPoint a_, b_, way_{};
  double radius_, length_;
};

}  // namespace

/// Calls visit(first pixel, count) for each row of pixels covered as long as it returns true.
template <class Visit>
bool SweptRaster::visit_rows(const FlatPoint& from, const FlatPoint& to, double radius_mm,
                             const Visit& visit) const {
  const Capsule capsule(from, to, radius_mm);
  const double p = raster_.pixel_mm;
  const int first = std::max(0, static_cast<int>(std::ceil((capsule.low_y() - raster_.y0) / p)));
  const int last =
      std::min(raster_.rows - 1, static_cast<int>(std::floor((capsule.high_y() - raster_.y0) / p)));
  for (int j = first; j <= last; ++j) {
    const Interval span = capsule.at(raster_.y(j));
    if (span.empty()) continue;
    const int begin = std::max(0, static_cast<int>(std::ceil((span.low - raster_.x0) / p)));
    const int end =
        std::min(raster_.columns - 1, static_cast<int>(std::floor((span.high - raster_.x0) / p)));
    if (begin > end) continue;
    const std::size_t at = static_cast<std::size_t>(j) * raster_.columns + begin;
    if (!visit(at, static_cast<std::size_t>(end - begin + 1))) return false;
  }
  return true;
}

void SweptRaster::sweep(const FlatPoint& from, const FlatPoint& to, double radius_mm) {
  visit_rows(from, to, radius_mm, [&](std::size_t at, std::size_t count) {
    std::memset(&swept_[at], 1, count);
    return true;
  });
}

void SweptRaster::sweep(const std::vector<FlatPoint>& line, double radius_mm) {
  if (line.size() == 1) sweep(line[0], line[0], radius_mm);
  for (std::size_t i = 1; i < line.size(); ++i) sweep(line[i - 1], line[i], radius_mm);
}

bool SweptRaster::is_swept(const FlatPoint& from, const FlatPoint& to, double radius_mm) const {
  return visit_rows(from, to, radius_mm, [&](std::size_t at, std::size_t count) {
    return std::memchr(&swept_[at], 0, count) == nullptr;
  });
}

}  // namespace limitgauge::engine::strategy
