#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reports/probe/probe_result.h"
#include "reports/text/text.h"

namespace limitgauge::reports::probe {

/// "x", "y", "z" and their capitals.
const char* axis_name(int axis, bool capital);

/// Why an axis of the shift is undetermined; empty where it is not.
std::string why_undetermined(const verifier::ZeroShift& shift, int axis);
/// What is taken back along a direction that is determined, though the axes that it lies between
/// are not: "+12.0 µm along (0.707, 0.707, 0.000)".
std::vector<std::string> shifts_between_axes(const verifier::ZeroShift& shift);
/// Why it has no uncertainty; empty where it has one.
std::string why_no_uncertainty(const verifier::ZeroShift& shift, int axis);

/// The root mean square of residual over uncertainty, over what is expected of it: 1 where the
/// scatter is as the uncertainties state. None where none are stated or no degree of freedom is
/// left.
std::optional<double> scatter_ratio(const ProbeResult& result);

/// The unit that the shift is shown in.
LengthUnit shift_unit(const verifier::ZeroShift& shift);
/// "3.012" and "0.035" in `unit`, two digits of the uncertainty; the other as fine.
struct ShiftText {
  std::string value, u;  ///< `u` is empty where there is none
};
ShiftText shift_text(double shift_mm, std::optional<double> u_mm, const LengthUnit& unit);

/// As measured_length(), "0 µm" below a picometre.
std::string shown_length(double mm);
/// "+1.25 µm", three significant digits with a sign; "0 µm" below a picometre.
std::string signed_length(double mm);
/// "[1.24, 1.26]", rounded outwards, or "[1.24, unknown]" where nothing was proven to stand.
std::string interval_text(const verifier::ProbeResidual& residual, const LengthUnit& unit);
/// "line 12 of finish", "move 3 of finish" where a program has no lines, "raw stock".
std::string nearest_text(const ProbeResult& result, const ProbedPoint& point);

/// Indices of points, the largest |residual| first; equal ones in the order of the file.
enum class Residuals { before, after };
std::vector<std::size_t> worst_first(const ProbeResult& result, Residuals which);
/// The point with the largest |residual|; among equals the first.
const ProbedPoint& worst_point(const ProbeResult& result, Residuals which);
const verifier::ProbeResidual& residual_of(const ProbedPoint& point, Residuals which);

}  // namespace limitgauge::reports::probe
