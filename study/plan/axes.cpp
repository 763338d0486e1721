#include "study/plan/axes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "study/plan/reference.h"
#include "study/plan/settings.h"

namespace limitgauge::study {

Axis::Axis(const Variable& variable, double accuracy) : accuracy_(accuracy) {
  if (!is_counted(variable)) {
    range_ = variable.range;
    finest_ = accuracy;
    return;
  }
  counted_ = settings_of(variable);
  if (counted_.empty()) throw std::invalid_argument("a variable without settings");
  ordered_ = std::all_of(counted_.begin(), counted_.end(),
                         [](const Setting& setting) { return setting.number.has_value(); });
  if (!ordered_) return;
  std::sort(counted_.begin(), counted_.end(),
            [](const Setting& a, const Setting& b) { return *a.number < *b.number; });
  finest_ = counted_.size() > 1 ? 1 / static_cast<double>(counted_.size() - 1) : 1;
}

Setting Axis::at(double coordinate) const {
  if (range_) {
    if (coordinate <= 0) return number_setting(range_->low);
    if (coordinate >= 1) return number_setting(range_->high);
    const double value = study::at(*range_, coordinate);
    const double resolution = study::at(*range_, std::min(1.0, coordinate + accuracy_)) - value;
    return number_setting(std::clamp(rounded(value, resolution), range_->low, range_->high));
  }
  const auto last = static_cast<double>(counted_.size() - 1);
  const double place = std::round(ordered_ ? coordinate * last : coordinate);
  return counted_[static_cast<std::size_t>(std::clamp(place, 0.0, last))];
}

std::optional<double> Axis::coordinate_of(const Setting& setting) const {
  if (range_) {
    if (!setting.number || *setting.number < range_->low || *setting.number > range_->high)
      return std::nullopt;
    return share_of(*range_, *setting.number);
  }
  for (std::size_t i = 0; i < counted_.size(); ++i)
    if (alike(counted_[i], setting)) return static_cast<double>(i) * (ordered_ ? finest_ : 1);
  return std::nullopt;
}

std::vector<Axis> axes_of(const Plan& plan) {
  std::vector<Axis> axes;
  for (const Variable& variable : plan.variables) axes.emplace_back(variable, plan.search.accuracy);
  return axes;
}

std::vector<Setting> settings_at(const std::vector<Axis>& axes, const Spot& spot) {
  std::vector<Setting> settings;
  for (std::size_t i = 0; i < axes.size(); ++i) settings.push_back(axes[i].at(spot[i]));
  return settings;
}

}  // namespace limitgauge::study
