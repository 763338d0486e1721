#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "verifier/gate/verify.h"

namespace limitgauge::verifier {

/// Micrometres below a tenth of a millimetre, millimetres above; nanometres where micrometres would
/// need an exponent.
std::string length_text(double mm);
/// Likewise, with more digits where four would not show on which side of the limit it lies.
std::string length_text(double mm, const std::optional<double>& limit_mm);
/// "between 1.234 µm and 2.346 µm": rounded outwards to four digits, so that it stays true, and to
/// more where four would put an end on another side of the limit.
std::string range_text(const Interval& figure,
                       const std::optional<double>& limit_mm = std::nullopt);
/// "between 12.1 mm² and 12.9 mm² (4.03 % to 4.3 %)", rounded likewise; `whole_mm2` > 0.
std::string area_range_text(const Interval& area_mm2, double whole_mm2,
                            const std::optional<double>& limit_mm2 = std::nullopt);
/// "12.3 mm²".
std::string area_text(double mm2);
/// 0.041 as "4.1 %".
std::string share_text(double share);

/// "at (1.000, 2.000, 3.000) mm".
std::string place_text(const model::Vec3& p);
/// "program line 12"; with the stage whose program it is where that is not the last of `stages`.
std::string line_text(std::size_t stage, std::uint32_t line, std::span<const std::string> stages);
/// Of the deepest of `findings`: "; deepest 0.3 mm at (1.000, 2.000, 3.000) mm, program line 12".
/// Empty where there is none.
std::string deepest_text(const std::vector<Finding>& findings, std::span<const std::string> stages,
                         const std::optional<double>& limit_mm = std::nullopt);
/// Where a figure over tolerances is reached and at which values: "; at (1.000, 2.000, 3.000) mm
/// with zero.z -3 µm, tool.ball3.radius +10 µm". Empty where it is not.
std::string reached_text(const RobustFigure& figure);
/// " for all values of the tolerances (as stated: between 1 µm and 2 µm; the tolerances may grow
/// 1.372 times)": what is certified, and what stands beside it.
std::string tolerances_text(const RobustFigure& figure, const Interval& stated_mm, double limit_mm);
/// Of what stands highest among the samples out of reach, likewise; empty where none is.
std::string out_of_reach_text(const DeviationField& field, std::span<const std::string> stages);

}  // namespace limitgauge::verifier
