#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace limitgauge::study {

/// Numbers that belong together.
struct Pairs {
  std::vector<double> x, y;
};

/// d y / d x of the straight line; nothing where all x are alike.
std::optional<double> slope(const Pairs& pairs);
/// d ln y / d ln x; nothing with fewer than three different x, or anything not above zero.
std::optional<double> elasticity(const Pairs& pairs);
double mean(const std::vector<double>& values);
/// Sum of squares of the differences from the mean.
double squares_about_mean(const std::vector<double>& values);
/// Number of different values.
std::size_t distinct(std::vector<double> values);

/// The polynomial of degree 2, or 1 where there are only two different x, that leaves the least sum
/// of squares.
class Parabola {
 public:
  /// Nothing where all x are alike or there are too few pairs to leave any freedom.
  static std::optional<Parabola> through(const Pairs& pairs);
  double at(double x) const;
  std::size_t coefficients() const { return order_; }

 private:
  double centre_ = 0, half_ = 1;  ///< x is counted from -1 to 1 for the sake of the digits
  std::size_t order_ = 0;
  double c_[3] = {0, 0, 0};
};

}  // namespace limitgauge::study
