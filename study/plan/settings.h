#pragma once

#include <vector>

#include "study/plan/plan.h"

/// What a variable can be set to.
namespace limitgauge::study {

/// `value` with the shortest text that reads back as it.
Setting number_setting(double value);

/// `value` to the decimal place of `resolution` or of the next finer power of ten, so that its text
/// is short.
double rounded(double value, double resolution);

/// The number at `share` (0 to 1) of the way through `range`, exact at both ends.
double at(const Range& range, double share);
/// The other way round.
double share_of(const Range& range, double value);

/// True where a variable has settings that can be counted: listed ones, or steps.
bool is_counted(const Variable& variable);
/// Number of them; 0 where they cannot be counted.
std::size_t setting_count(const Variable& variable);
/// All of them, in the order in which they are stated. The inner steps of a range are rounded by
/// less than a thousandth of the distance between two of them.
std::vector<Setting> settings_of(const Variable& variable);

/// The number at `share` of the way from `from` to `to` (shares of the range themselves), rounded
/// to `parts` parts of that stretch or finer, but never out of it.
double drawn(const Range& range, double from, double to, double share, double parts);

}  // namespace limitgauge::study
