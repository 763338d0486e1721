#include "reports/picture/deviation_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/tolerance.h"

namespace limitgauge::reports {
namespace {

constexpr Rgba kZero{247, 247, 247};
/// Inside the limit, outwards; then beyond it, outwards.
using Ramp = std::array<Rgba, 5>;
constexpr Ramp kUncut{
    {{253, 219, 199}, {244, 165, 130}, {214, 96, 77}, {178, 24, 43}, {103, 0, 31}}};
constexpr Ramp kGouge{
    {{209, 229, 240}, {146, 197, 222}, {67, 147, 195}, {33, 102, 172}, {5, 48, 97}}};

/// Colour at `t` in [0, 1] along a side; with a limit, it jumps at one half.
Rgba along(const Ramp& ramp, double t, bool has_limit) {
  const auto between = [](const Rgba& a, const Rgba& b, const Rgba& c, double s) {
    return s < 0.5 ? mixed(a, b, 2 * s) : mixed(b, c, 2 * s - 1);
  };
  // The limit itself still passes.
  if (t <= 0.5) return between(kZero, ramp[0], ramp[1], 2 * t);
  if (has_limit) return between(ramp[2], ramp[3], ramp[4], 2 * t - 1);
  const double s = (2 * t - 1) * 3;  // without a jump: from ramp[1] through the rest
  const auto i = std::min<std::size_t>(2, static_cast<std::size_t>(s));
  return mixed(ramp[1 + i], ramp[2 + i], s - double(i));
}

/// The next of 1, 2, 5 times a power of ten.
double rounded_up(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0})
    if (value <= step * power * (1 + kRounding)) return step * power;
  return 10 * power;
}

constexpr double kFinestScale_mm = 1e-6;

DeviationScale::Side side(bool has_limit, double limit_mm, double measured_mm) {
  if (has_limit && limit_mm > 0)
    return {limit_mm,
            std::max(2 * limit_mm, measured_mm > 2 * limit_mm ? rounded_up(measured_mm) : 0.0),
            true};
  const double end = rounded_up(std::max(measured_mm, kFinestScale_mm));
  return {end / 2, end, false};
}

double position_on(const DeviationScale::Side& s, double size_mm) {
  if (size_mm <= s.limit_mm) return 0.5 * size_mm / s.limit_mm;
  return std::min(1.0, 0.5 + 0.5 * (size_mm - s.limit_mm) / (s.end_mm - s.limit_mm));
}

double size_on(const DeviationScale::Side& s, double t) {
  if (t <= 0.5) return 2 * t * s.limit_mm;
  return s.limit_mm + (2 * t - 1) * (s.end_mm - s.limit_mm);
}

}  // namespace

DeviationScale DeviationScale::for_gate(const verifier::StageDeviation& d,
                                        const verifier::GateLimits& l) {
  return {side(l.has_gouge, l.gouge_mm, d.gouge_mm.high),
          side(l.has_uncut, l.uncut_mm, d.uncut_mm.high)};
}

DeviationScale DeviationScale::magnified(const verifier::StageDeviation& d) {
  const Side both = side(false, 0, std::max(d.gouge_mm.high, d.uncut_mm.high));
  return {both, both};
}

double DeviationScale::position(double deviation_mm) const {
  return deviation_mm < 0 ? -position_on(gouge_, -deviation_mm) : position_on(uncut_, deviation_mm);
}

double DeviationScale::deviation_mm(double position) const {
  return position < 0 ? -size_on(gouge_, -position) : size_on(uncut_, position);
}

Rgba DeviationScale::colour(double deviation_mm) const {
  const double t = position(deviation_mm);
  return t < 0 ? along(kGouge, -t, gouge_.has_limit) : along(kUncut, t, uncut_.has_limit);
}

std::vector<double> DeviationScale::ticks_mm() const {
  return {-gouge_.end_mm, -gouge_.limit_mm, 0, uncut_.limit_mm, uncut_.end_mm};
}

}  // namespace limitgauge::reports
