#pragma once

#include <optional>
#include <string>

namespace limitgauge::model {

/// `value` with `decimals` places after the point; never "-0".
std::string with_decimals(double value, int decimals);

enum class Rounding { down, nearest, up };

/// `value` with `decimals` places, rounded as `rounding` says; a value that has no more places than
/// that, but for the last bits of its binary form, stays. Where a `limit` is stated in the same
/// unit, the printed figure lies on the side of it that `value` lies on: below it, on it or beyond.
/// Where `decimals` places would not show that, as many more are printed as it takes, up to 15.
std::string rounded_text(double value, int decimals, Rounding rounding,
                         const std::optional<double>& limit = std::nullopt);

/// How many places after the point show `digits` significant digits of `value`, at most nine.
int significant_decimals(double value, int digits);

/// A stated decimal times a unit may carry binary dust in its last digits: `value` to nine places.
double without_dust(double value);

/// "12.500" as "12.5", "3.000" as "3".
std::string without_trailing_zeros(std::string number);

/// A factor in four significant digits, rounded to the side on which less is said: "1.427".
std::string factor_text(double factor, Rounding rounding);

}  // namespace limitgauge::model
