#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "model/base/run_control.h"
#include "model/geometry/vec3.h"

namespace limitgauge::verifier {

/// One point of a fit: its distance from the surface, and the unit slope of that.
struct FitGap {
  double value_mm = 0;
  model::Vec3 normal;
};

/// What is fitted. `gap(i, shift)` is that of point i moved by −shift, asked for from any thread.
struct FitProblem {
  std::size_t points = 0;
  std::function<FitGap(std::size_t point, const model::Vec3& shift_mm)> gap;
  /// Standard uncertainty of each point's distance, mm, above zero; empty: unknown and equal.
  std::span<const double> u_mm;
};

/// One of three directions, square to each other, in which the points say how far they are off.
struct FitDirection {
  model::Vec3 along;
  double leverage = 0;      ///< root mean square of the normals' part along it, 0 to 1
  bool determined = false;  ///< the leverage is large enough
  double shift_mm = 0;      ///< along it; 0 where it is not determined
};

/// The translation of the points that explains their distances best. Figures that have none are
/// empty: what is undetermined is never zero.
struct ZeroShift {
  std::size_t points = 0;
  model::Vec3 shift_mm;  ///< that the points were moved back by; nothing along what is undetermined
  std::array<FitDirection, 3> directions;            ///< the best determined first
  std::array<std::optional<double>, 3> axes_mm;      ///< x, y, z; none: undetermined
  std::array<std::optional<double>, 3> axes_u_mm;    ///< standard uncertainty of each
  std::array<std::optional<double>, 3> correlation;  ///< of y and z, z and x, x and y
  std::size_t degrees_of_freedom = 0;
  /// Standard uncertainty of one point by the scatter of all; none where uncertainties are stated,
  /// or where that leaves no degree of freedom.
  std::optional<double> scatter_mm;
  double chi2_before = 0, chi2_after = 0;  ///< sums of squares over u²; mm² where no u is stated
  double rms_before_mm = 0, rms_after_mm = 0;
  int steps = 0;
  double last_step_mm = 0;
  bool settled = false;  ///< the last step is below kSettledStep_mm

  std::size_t rank() const;
};

/// Steps below this end a fit, mm: far below what is shown of a shift.
inline constexpr double kSettledStep_mm = 1e-9;

/// Weighted least squares by Gauss and Newton; distances and normals are asked for anew at each
/// step, and a step that makes things worse is halved. The result is the same for any number of
/// threads. Nothing for no points.
std::optional<ZeroShift> fit_zero_shift(const FitProblem& problem,
                                        const model::RunControl& control);

}  // namespace limitgauge::verifier
