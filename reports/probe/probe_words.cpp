#include "reports/probe/probe_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace limitgauge::reports::probe {
namespace {

/// A direction that lies this near to an axis, as the square of the sine between, is the axis.
constexpr double kAlongAxis = 1e-6;
/// Rounding of the normals: a leverage below is none.
constexpr double kNoLeverage = 1e-9;
/// What is shorter is the rounding of distances, a picometre, and shown as none.
constexpr double kNothing_mm = 1e-9;
constexpr int kMostDecimals = 6;

std::string direction_text(const model::Vec3& v) {
  return fmt::format("({}, {}, {})", fixed(v.x, 3), fixed(v.y, 3), fixed(v.z, 3));
}

bool is_axis(const model::Vec3& v, int axis) {
  return 1 - v[axis] * v[axis] <= kAlongAxis;
}

/// Decimals that show two significant digits of `u`.
int decimals_for(double u) {
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(u))), 0, kMostDecimals);
}

std::string named_line(const NearestMove& nearest) {
  if (nearest.line > 0) return fmt::format("line {}", nearest.line);
  return fmt::format("move {}", nearest.move);
}

}  // namespace

verifier::Verdict standing(const ProbedPoint& point, double limit_mm) {
  const verifier::ProbeResidual& r = point.before;
  const double expanded_mm = kCoverageFactor * point.measured.u_mm;
  const double least_mm = std::max({0.0, r.low_mm, r.high_mm ? -*r.high_mm : 0.0});
  if (least_mm - expanded_mm > limit_mm) return verifier::Verdict::fail;
  if (!r.high_mm) return verifier::Verdict::indeterminate;
  const double most_mm = std::max(std::abs(r.low_mm), std::abs(*r.high_mm));
  return most_mm + expanded_mm <= limit_mm ? verifier::Verdict::pass
                                           : verifier::Verdict::indeterminate;
}

ResidualGate judged(const std::vector<ProbedPoint>& points, double limit_mm) {
  ResidualGate gate{limit_mm};
  for (const ProbedPoint& point : points) {
    const verifier::Verdict one = standing(point, limit_mm);
    if (one == verifier::Verdict::fail) ++gate.beyond;
    if (one == verifier::Verdict::indeterminate) ++gate.undecided;
  }
  if (gate.beyond > 0)
    gate.verdict = verifier::Verdict::fail;
  else if (gate.undecided > 0)
    gate.verdict = verifier::Verdict::indeterminate;
  return gate;
}

const char* axis_name(int axis, bool capital) {
  constexpr const char* kSmall[] = {"x", "y", "z"};
  constexpr const char* kCapital[] = {"X", "Y", "Z"};
  return capital ? kCapital[axis] : kSmall[axis];
}

std::string why_undetermined(const verifier::ZeroShift& shift, int axis) {
  if (shift.axes_mm[axis]) return {};
  std::string directions;
  double leverage = 0;
  for (const verifier::FitDirection& one : shift.directions) {
    if (one.determined || one.along[axis] * one.along[axis] <= kAlongAxis) continue;
    leverage = std::max(leverage, one.leverage);
    directions += directions.empty() ? "" : " or ";
    directions += is_axis(one.along, axis) ? axis_name(axis, true) : direction_text(one.along);
  }
  return (leverage < kNoLeverage ? "no point lies on a surface that faces "
                                 : "too few points lie on surfaces that face ") +
         directions;
}

std::vector<std::string> shifts_between_axes(const verifier::ZeroShift& shift) {
  std::vector<std::string> out;
  for (const verifier::FitDirection& one : shift.directions) {
    bool is_shown = true;
    for (int axis = 0; axis < 3; ++axis)
      if (!shift.axes_mm[axis] && one.along[axis] * one.along[axis] > kAlongAxis) is_shown = false;
    if (!one.determined || is_shown) continue;
    out.push_back(
        fmt::format("{} along {}", signed_length(one.shift_mm), direction_text(one.along)));
  }
  return out;
}

std::string why_no_uncertainty(const verifier::ZeroShift& shift, int axis) {
  if (!shift.axes_mm[axis] || shift.axes_u_mm[axis]) return {};
  return "no uncertainty is stated, and there are no more points than the shift takes";
}

std::optional<double> scatter_ratio(const ProbeResult& result) {
  const verifier::ZeroShift& shift = result.shift;
  if (!result.has_uncertainty || shift.degrees_of_freedom == 0) return std::nullopt;
  return std::sqrt(shift.chi2_after / static_cast<double>(shift.degrees_of_freedom));
}

LengthUnit shift_unit(const verifier::ZeroShift& shift) {
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    largest = std::max(largest, std::abs(shift.axes_mm[axis].value_or(0)));
    largest = std::max(largest, shift.axes_u_mm[axis].value_or(0));
  }
  return unit_for(largest);
}

ShiftText shift_text(double shift_mm, std::optional<double> u_mm, const LengthUnit& unit) {
  const double shown = shift_mm * unit.per_mm;
  constexpr int kDecimals = 4;
  if (!u_mm || *u_mm <= 0) return {fixed(shown, kDecimals), u_mm ? "0" : ""};
  const int decimals = decimals_for(*u_mm * unit.per_mm);
  return {fixed(shown, decimals), fixed(*u_mm * unit.per_mm, decimals)};
}

std::string shown_length(double mm) {
  return std::abs(mm) < kNothing_mm ? "0 µm" : measured_length(mm);
}

std::string signed_length(double mm) {
  if (std::abs(mm) < kNothing_mm) return "0 µm";
  return (mm < 0 ? "-" : "+") + measured_length(std::abs(mm));
}

std::string interval_text(const verifier::ProbeResidual& residual, const LengthUnit& unit) {
  if (residual.high_mm) return interval_numbers({residual.low_mm, *residual.high_mm}, unit);
  const std::string both = interval_numbers({residual.low_mm, residual.low_mm}, unit);
  return both.substr(0, both.find(',')) + ", unknown]";
}

std::string nearest_text(const ProbeResult& result, const ProbedPoint& point) {
  if (!point.nearest) return "raw stock";
  return fmt::format("{} of {}{}", named_line(*point.nearest),
                     result.stages[point.nearest->stage].name,
                     point.nearest->is_rapid ? ", a rapid" : "");
}

const verifier::ProbeResidual& residual_of(const ProbedPoint& point, Residuals which) {
  return which == Residuals::before ? point.before : point.after;
}

std::vector<std::size_t> worst_first(const ProbeResult& result, Residuals which) {
  std::vector<std::size_t> order(result.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto size = [&](std::size_t i) {
    return std::abs(residual_of(result.points[i], which).gap.value_mm);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
  return order;
}

const ProbedPoint& worst_point(const ProbeResult& result, Residuals which) {
  return *std::max_element(result.points.begin(), result.points.end(),
                           [&](const ProbedPoint& a, const ProbedPoint& b) {
                             return std::abs(residual_of(a, which).gap.value_mm) <
                                    std::abs(residual_of(b, which).gap.value_mm);
                           });
}

}  // namespace limitgauge::reports::probe
