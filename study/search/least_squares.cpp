#include "study/search/least_squares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace limitgauge::study {
namespace {

using Matrix = std::array<std::array<double, 4>, 3>;  ///< normal equations, right side last

/// Gauss with the largest pivot; the system is regular where there are enough different x.
void solve(Matrix& m, std::size_t order) {
  for (std::size_t k = 0; k < order; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < order; ++i)
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    std::swap(m[k], m[pivot]);
    for (std::size_t i = 0; i < order; ++i) {
      if (i == k) continue;
      const double factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < 4; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  for (std::size_t k = 0; k < order; ++k) m[k][3] /= m[k][k];
}

Matrix normal_equations(const Pairs& pairs, double centre, double half, std::size_t order) {
  Matrix m{};
  for (std::size_t i = 0; i < pairs.x.size(); ++i) {
    const double t = (pairs.x[i] - centre) / half;
    const double powers[3] = {1, t, t * t};
    for (std::size_t r = 0; r < order; ++r) {
      for (std::size_t c = 0; c < order; ++c) m[r][c] += powers[r] * powers[c];
      m[r][3] += powers[r] * pairs.y[i];
    }
  }
  return m;
}

}  // namespace

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
  Matrix m = normal_equations(pairs, fit.centre_, fit.half_, fit.order_);
  solve(m, fit.order_);
  for (std::size_t k = 0; k < fit.order_; ++k) fit.c_[k] = m[k][3];
  return fit;
}

double Parabola::at(double x) const {
  const double t = (x - centre_) / half_;
  return c_[0] + t * (c_[1] + t * c_[2]);
}

}  // namespace limitgauge::study
