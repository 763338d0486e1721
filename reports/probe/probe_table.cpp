#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "reports/probe/probe_report.h"
#include "reports/probe/probe_words.h"
#include "reports/text/terminal_table.h"

namespace limitgauge::reports::probe {
namespace {

Tone tone_of(verifier::Verdict verdict) {
  if (verdict == verifier::Verdict::pass) return Tone::good;
  return verdict == verifier::Verdict::fail ? Tone::bad : Tone::doubtful;
}

std::string place_text(const model::Vec3& p) {
  return fmt::format("{} {} {}", fixed(p.x, 3), fixed(p.y, 3), fixed(p.z, 3));
}

std::vector<TerminalTable::Cell> residual_row(const ProbeResult& result, Residuals which) {
  const bool before = which == Residuals::before;
  const ProbedPoint& worst = worst_point(result, which);
  const verifier::ProbeResidual& residual = residual_of(worst, which);
  const LengthUnit unit = unit_for(std::abs(residual.gap.value_mm));
  return {{before ? "as measured" : "shift taken back"},
          {shown_length(before ? result.shift.rms_before_mm : result.shift.rms_after_mm)},
          {signed_length(residual.gap.value_mm)},
          {interval_text(residual, unit) + " " + unit.symbol},
          {place_text(worst.measured.at_mm)},
          {nearest_text(result, worst)}};
}

std::string residual_rows(const ProbeResult& result, bool colour, std::size_t width) {
  TerminalTable table({{}, {true}, {true}, {true}, {true}, {false, true}});
  table.add_row({{""}, {"rms"}, {"worst"}, {"certified"}, {"at"}, {"nearest"}});
  table.add_row(residual_row(result, Residuals::before));
  table.add_row(residual_row(result, Residuals::after));
  table.fit(width);
  std::string out;
  for (std::size_t row = 0; row < table.rows(); ++row) out += table.line(row, colour);
  return out;
}

std::string shift_line(const verifier::ZeroShift& shift) {
  const LengthUnit unit = shift_unit(shift);
  std::string out = "zero shift:";
  for (int axis = 0; axis < 3; ++axis) {
    out += fmt::format("{} {} ", axis == 0 ? "" : ",", axis_name(axis, true));
    if (!shift.axes_mm[axis]) {
      out += "undetermined";
      continue;
    }
    const ShiftText text = shift_text(*shift.axes_mm[axis], shift.axes_u_mm[axis], unit);
    out += text.value + (text.u.empty() ? "" : " ± " + text.u) + " " + unit.symbol;
  }
  return out + " (± standard uncertainty)\n";
}

std::string reasons(const verifier::ZeroShift& shift) {
  std::string out;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string why = why_undetermined(shift, axis), no_u = why_no_uncertainty(shift, axis);
    if (!why.empty()) out += fmt::format("{} undetermined: {}\n", axis_name(axis, true), why);
    if (!no_u.empty())
      out += fmt::format("{} without uncertainty: {}\n", axis_name(axis, true), no_u);
  }
  for (const std::string& one : shifts_between_axes(shift))
    out += "determined between axes, and taken back: " + one + "\n";
  if (!shift.settled)
    out += "the fit did not settle: the last step was " + shown_length(shift.last_step_mm) + "\n";
  return out;
}

std::string gate_line(const ResidualGate& gate, bool colour) {
  std::string out = fmt::format("residual limit {}: {}", stated_length(gate.limit_mm),
                                painted(verdict_text(gate.verdict), tone_of(gate.verdict), colour));
  if (gate.beyond > 0) out += fmt::format(", {} beyond", grouped(gate.beyond));
  if (gate.undecided > 0) out += fmt::format(", {} undecided", grouped(gate.undecided));
  return out + "\n";
}

}  // namespace

std::string probe_table(const ProbeResult& result, bool colour, std::size_t width) {
  const std::size_t count = result.points.size();
  std::string out =
      fmt::format("{} {} against stage {} of {}\n", grouped(count), count == 1 ? "point" : "points",
                  clean_text(result.stages.back().name), shortened(clean_text(result.job), 60));
  out += residual_rows(result, colour, width) + shift_line(result.shift) + reasons(result.shift);
  if (const auto ratio = scatter_ratio(result))
    out +=
        fmt::format("scatter: {} of what the stated uncertainties explain\n", three_digits(*ratio));
  for (const std::string& remark : result.remarks) out += "note: " + clean_text(remark) + "\n";
  if (result.gate) out += gate_line(*result.gate, colour);
  return out;
}

}  // namespace limitgauge::reports::probe
