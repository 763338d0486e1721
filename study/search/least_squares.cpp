#include "study/search/least_squares.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace limitgauge::study {
double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

double squares_about_mean(const std::vector<double>& values) {
  const double centre = mean(values);
  double sum = 0;
  for (const double value : values) sum += (value - centre) * (value - centre);
  return sum;
}

std::size_t distinct(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return static_cast<std::size_t>(std::unique(values.begin(), values.end()) - values.begin());
}

std::optional<double> slope(const Pairs& pairs) {
  const double x = mean(pairs.x), y = mean(pairs.y);
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < pairs.x.size(); ++i) {
    xx += (pairs.x[i] - x) * (pairs.x[i] - x);
    xy += (pairs.x[i] - x) * (pairs.y[i] - y);
  }
  if (!(xx > 0)) return std::nullopt;
  return xy / xx;
}

std::optional<double> elasticity(const Pairs& pairs) {
  constexpr std::size_t kLeast = 3;
  if (distinct(pairs.x) < kLeast) return std::nullopt;
  Pairs logs;
  for (std::size_t i = 0; i < pairs.x.size(); ++i) {
    if (!(pairs.x[i] > 0) || !(pairs.y[i] > 0)) return std::nullopt;
    logs.x.push_back(std::log(pairs.x[i]));
    logs.y.push_back(std::log(pairs.y[i]));
  }
  return slope(logs);
}

std::optional<Parabola> Parabola::through(const Pairs& pairs) {
  const std::size_t different = distinct(pairs.x);
  if (different < 2) return std::nullopt;
  const auto [low, high] = std::minmax_element(pairs.x.begin(), pairs.x.end());
  Parabola fit;
  fit.centre_ = (*low + *high) / 2;
  fit.half_ = (*high - *low) / 2;
  fit.order_ = different > 2 ? 3 : 2;
  if (pairs.x.size() <= fit.order_) return std::nullopt;
  const auto rows = static_cast<Eigen::Index>(pairs.x.size());
  Eigen::MatrixXd powers = Eigen::MatrixXd::Ones(rows, static_cast<Eigen::Index>(fit.order_));
  for (Eigen::Index i = 0; i < rows; ++i)
    for (Eigen::Index k = 1; k < powers.cols(); ++k)
      powers(i, k) =
          powers(i, k - 1) * (pairs.x[static_cast<std::size_t>(i)] - fit.centre_) / fit.half_;
  const Eigen::Map<const Eigen::VectorXd> y(pairs.y.data(), rows);
  const Eigen::VectorXd c = powers.colPivHouseholderQr().solve(y);
  std::copy(c.begin(), c.end(), fit.c_);
  return fit;
}

double Parabola::at(double x) const {
  const double t = (x - centre_) / half_;
  return c_[0] + t * (c_[1] + t * c_[2]);
}

}  // namespace limitgauge::study
