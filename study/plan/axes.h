#pragma once

#include <vector>

#include "study/plan/plan.h"

namespace limitgauge::study {

/// A variable as a search walks along it: by a coordinate from 0 to 1 where it has an order, else
/// (text, lists, switches) by the place of its setting, 0, 1, 2 and so on.
class Axis {
 public:
  /// `accuracy` is the share of a range that a setting is rounded to.
  Axis(const Variable& variable, double accuracy);

  bool ordered() const { return ordered_; }
  /// Number of settings; 0 of a continuum.
  std::size_t count() const { return counted_.size(); }
  /// Nearest to `coordinate`, rounded.
  Setting at(double coordinate) const;
  /// Of a number within the range, or of a setting that is listed; else nothing.
  std::optional<double> coordinate_of(const Setting& setting) const;
  /// Least distance of two settings that are worth telling apart.
  double finest() const { return finest_; }

 private:
  std::optional<Range> range_;  ///< of a continuum
  double accuracy_;
  std::vector<Setting> counted_;  ///< by rising number where they are ordered
  bool ordered_ = true;
  double finest_ = 0;
};

/// A coordinate for each axis.
using Spot = std::vector<double>;

std::vector<Axis> axes_of(const Plan& plan);
std::vector<Setting> settings_at(const std::vector<Axis>& axes, const Spot& spot);

}  // namespace limitgauge::study
