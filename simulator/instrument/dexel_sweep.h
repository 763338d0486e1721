#pragma once

#include <algorithm>
#include <optional>

#include "model/geometry/interval.h"
#include "model/geometry/vec3.h"
#include "simulator/instrument/dexel_meridian.h"

namespace limitgauge::simulator {

/// Planes that lie over rectangles of lines, in columns: the rectangles' middles, the height there,
/// and the slopes.
struct DexelPlanes {
  const double *x, *y, *height, *slope_x, *slope_y;
  double half_x, half_y;  ///< of all rectangles, mm
};

/// What one straight move of a cutter's flutes takes from vertical lines. The swept solid is the
/// Minkowski sum of two convex sets, so that its part of a line is one interval, found by
/// minimising a convex function of the place along the move. Lives no longer than its profile.
class DexelSweep {
 public:
  DexelSweep(const DexelProfile& profile, const model::Vec3& from, const model::Vec3& to);

  /// The heights between which the flutes take from the line, mm; nothing where they do not reach
  /// it.
  std::optional<model::Interval> interval(double x, double y) const;
  /// The lower ends on `n` lines at (x + i·step, y); infinite where the flutes do not reach the
  /// line, and where the end is seen not to lie below `standing[i]`.
  void lower_ends(double x, double y, double step, int n, const double* standing,
                  double* low) const;
  /// Of a ball alone: the lower ends on kSquare × kSquare lines from (x, y) on, x first; infinite
  /// where it does not reach the line.
  void ball_ends(double x, double y, double step_x, double step_y, double* low) const;
  static constexpr int kSquare = 8;
  /// A range of x, empty where there is none, that holds all of the sweep with y in [y_low,
  /// y_high].
  model::Interval span(double y_low, double y_high) const;
  /// By how much at least the lower side stays above each of `n` planes, all over its rectangle;
  /// negative where that is not shown, infinite where the flutes reach no line of it.
  void clearances(const DexelPlanes& planes, std::size_t n, double* clear) const;
  bool of_ball() const { return profile_->is_ball(); }

  bool vertical() const { return run_ == 0; }
  double lowest_tip() const { return tip_low_; }
  double lowest_y() const { return std::min(start_.y, end_.y) - profile_->largest_radius(); }
  double highest_y() const { return std::max(start_.y, end_.y) + profile_->largest_radius(); }
  /// No upper end of an interval lies below this.
  double least_upper() const { return tip_low_ + profile_->least_upper(); }
  double across(double x, double y) const {
    return (y - start_.y) * along_x_ - (x - start_.x) * along_y_;
  }
  double along(double x, double y) const {
    return (x - start_.x) * along_x_ + (y - start_.y) * along_y_;
  }

 private:
  struct Reach {
    double first, last;  // places along the move from which the cutter covers the line
  };
  std::optional<Reach> reach(double along, double across) const;
  double tip_z(double s) const { return s == run_ ? end_z_ : start_.z + slope_ * s; }
  double best_place(const ConvexMeridian& side, double toward, double along, double across,
                    const Reach& reach) const;
  double radius(double along, double across) const;
  double lowest(double along, double across, const Reach& reach) const;
  double highest(double along, double across, const Reach& reach) const;
  struct BallEnd;
  BallEnd ball_end() const;
  void ball_clearances(const DexelPlanes& planes, std::size_t n, double* clear) const;
  double level_clearance(const DexelPlanes& planes, std::size_t k) const;

  const DexelProfile* profile_;
  model::Vec3 start_, end_;
  double end_z_ = 0, tip_low_ = 0, tip_high_ = 0;
  double run_ = 0, slope_ = 0, along_x_ = 1, along_y_ = 0;
};

}  // namespace limitgauge::simulator
