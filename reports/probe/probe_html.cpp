#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "reports/html/markup.h"
#include "reports/html/shell.h"
#include "reports/probe/probe_report.h"
#include "reports/probe/probe_words.h"
#include "reports/probe/residual_chart.h"
#include "reports/text/embedded.h"

namespace limitgauge::reports::probe {
namespace {

using html::terms;
using html::typeset;

std::string points_words(std::size_t count) {
  return grouped(count) + (count == 1 ? " point" : " points");
}

std::string gate_words(const ProbeResult& result) {
  const ResidualGate& gate = *result.gate;
  std::string out =
      fmt::format("Limit of the residuals as measured: {}. ", stated_length(gate.limit_mm));
  if (gate.verdict == verifier::Verdict::pass) return out + "Every point is within it.";
  if (gate.beyond > 0) out += points_words(gate.beyond) + " beyond it. ";
  if (gate.undecided > 0) out += points_words(gate.undecided) + " undecided.";
  return out;
}

/// As part of a sentence; what is undetermined is named so.
std::string shift_words(const verifier::ZeroShift& shift, int axis) {
  const LengthUnit unit = shift_unit(shift);
  if (!shift.axes_mm[axis]) return "<strong>undetermined</strong>";
  const ShiftText text = shift_text(*shift.axes_mm[axis], shift.axes_u_mm[axis], unit);
  return typeset(text.value) + (text.u.empty() ? "" : " ± " + text.u) + " " + unit.symbol;
}

std::string shift_cell(const verifier::ZeroShift& shift, int axis) {
  return shift.axes_mm[axis] ? shift_words(shift, axis) : html::badge("open", "?", "undetermined");
}

std::string probe_box(const ProbeResult& result) {
  const char* css = result.gate ? html::css_class(result.gate->verdict) : "none";
  const std::string word =
      result.gate ? html::badge(result.gate->verdict)
                  : points_words(result.points.size()) + " against the simulated stock";
  return fmt::format(
      "<div class=\"verdict {}\"><p class=\"word\">{}</p>\n{}<p>Zero shift: X {}, Y {}, Z {}. "
      "Root mean square of the residuals: {} as measured, {} with the shift taken "
      "back.</p></div>\n",
      css, word, result.gate ? "<p>" + gate_words(result) + "</p>\n" : "",
      shift_words(result.shift, 0), shift_words(result.shift, 1), shift_words(result.shift, 2),
      shown_length(result.shift.rms_before_mm), shown_length(result.shift.rms_after_mm));
}

std::string file_term(const ProbeInput& input) {
  return fmt::format("{} <small>SHA-256 <code>{}</code></small>", escape_markup(input.file),
                     input.sha256.substr(0, 12));
}

std::string probe_masthead(const ProbeResult& result) {
  const double most_u = std::max_element(result.points.begin(), result.points.end(),
                                         [](const ProbedPoint& a, const ProbedPoint& b) {
                                           return a.measured.u_mm < b.measured.u_mm;
                                         })
                            ->measured.u_mm;
  return fmt::format(
             "<header><p class=\"kind\">Limitgauge · measured points against the simulated "
             "stock</p><h1>{}</h1>\n",
             escape_markup(result.job)) +
         probe_box(result) +
         terms({{"Result", file_term(result.result)},
                {"Measured after stage", escape_markup(result.stages.back().name) + " " +
                                             html::badge(result.stage_verdict)},
                {"Points",
                 points_words(result.points.size()) + " of " + file_term(result.points_file)},
                {"Standard uncertainty", result.has_uncertainty ? "up to " + measured_length(most_u)
                                                                : std::string("not stated")},
                {"Program version", "limitgauge " + escape_markup(result.version)}}) +
         "</header>\n";
}

std::string shift_notes(const ProbeResult& result) {
  const verifier::ZeroShift& shift = result.shift;
  std::string out;
  for (const std::string& one : shifts_between_axes(shift))
    out += "<p>Determined between axes, and taken back: " + typeset(one) + ".</p>\n";
  if (const auto ratio = scatter_ratio(result))
    out += fmt::format(
        "<p>The residuals that are left scatter by {} of what the stated uncertainties explain: 1 "
        "where shift and uncertainties explain all, more where the part differs from the "
        "simulation by something else.</p>\n",
        three_digits(*ratio));
  if (shift.scatter_mm)
    out += fmt::format(
        "<p>No uncertainty is stated: that of the shift follows from the scatter of the points, {} "
        "each.</p>\n",
        shown_length(*shift.scatter_mm));
  if (!shift.settled)
    out += fmt::format(
        "<p class=\"warn\">The fit did not settle: its last step was {}. The shift is not the "
        "best one.</p>\n",
        shown_length(shift.last_step_mm));
  return out;
}

std::string directions_table(const verifier::ZeroShift& shift) {
  std::vector<html::Row> rows;
  for (const verifier::FitDirection& one : shift.directions)
    rows.push_back({{html::coordinates(one.along), three_digits(one.leverage),
                     one.determined ? typeset(signed_length(one.shift_mm))
                                    : html::badge("open", "?", "undetermined")},
                    {}});
  return "<details><summary>Directions of the fit</summary>\n" +
         html::table("Square to each other, the best determined first",
                     {{"Direction"}, {"Leverage", true}, {"Shift along it", true}}, rows) +
         "</details>\n";
}

std::string shift_section(const ProbeResult& result) {
  const verifier::ZeroShift& shift = result.shift;
  std::vector<html::Row> rows;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string why = why_undetermined(shift, axis) + why_no_uncertainty(shift, axis);
    rows.push_back({{axis_name(axis, true), shift_cell(shift, axis), why.empty() ? "–" : why}, {}});
  }
  return "<section id=\"shift\"><h2>Zero shift</h2>\n<p>The points lie by this much further along "
         "each axis than the simulated part. A zero point that is off by as much explains them "
         "best, by weighted least squares.</p>\n" +
         html::table("Shift with its standard uncertainty", {{"Axis"}, {"Shift", true}, {"Remark"}},
                     rows) +
         shift_notes(result) + directions_table(shift) + "</section>\n";
}

html::Row summary_row(const ProbeResult& result, Residuals which) {
  const bool before = which == Residuals::before;
  const ProbedPoint& worst = worst_point(result, which);
  const verifier::ProbeResidual& residual = residual_of(worst, which);
  const LengthUnit unit = unit_for(std::abs(residual.gap.value_mm));
  return {{before ? "as measured" : "shift taken back",
           shown_length(before ? result.shift.rms_before_mm : result.shift.rms_after_mm),
           typeset(signed_length(residual.gap.value_mm)),
           typeset(interval_text(residual, unit)) + " " + unit.symbol,
           html::coordinates(worst.measured.at_mm), escape_markup(nearest_text(result, worst))},
          {}};
}

std::string residuals_section(const ProbeResult& result) {
  return "<section id=\"residuals\"><h2>Residuals</h2>\n" +
         html::table(
             "Of all points",
             {{"Residuals"},
              {"Root mean square", true},
              {"Worst", true},
              {"Certified", true},
              {"At (mm)", true},
              {"Nearest"}},
             {summary_row(result, Residuals::before), summary_row(result, Residuals::after)}) +
         residual_chart(result) + "</section>\n";
}

html::Row point_row(const ProbeResult& result, const ProbedPoint& point) {
  const auto certified = [](const verifier::ProbeResidual& residual) {
    const LengthUnit unit = unit_for(std::abs(residual.gap.value_mm));
    return fmt::format("{} <small>{} {}</small>", typeset(signed_length(residual.gap.value_mm)),
                       typeset(interval_text(residual, unit)), unit.symbol);
  };
  std::string nearest = escape_markup(nearest_text(result, point));
  if (point.nearest)
    nearest += fmt::format(" <small>{}</small>",
                           escape_markup(result.stages[point.nearest->stage].cutter));
  return {{std::to_string(point.measured.line), html::coordinates(point.measured.at_mm),
           result.has_uncertainty ? measured_length(point.measured.u_mm) : "–",
           certified(point.before), certified(point.after), std::move(nearest)},
          {}};
}

std::string points_section(const ProbeResult& result) {
  std::vector<html::Row> rows;
  for (const std::size_t i : worst_first(result, Residuals::after)) {
    if (rows.size() == kMostListed) break;
    rows.push_back(point_row(result, result.points[i]));
  }
  std::string caption = "The largest residual first, with the shift taken back";
  if (rows.size() < result.points.size())
    caption += fmt::format("; the first {} of {}, all are in probe.csv", grouped(rows.size()),
                           grouped(result.points.size()));
  return "<section id=\"points\"><h2>Points</h2>\n" +
         html::table(caption,
                     {{"Line of the file", true},
                      {"Measured at (mm)", true},
                      {"Uncertainty", true},
                      {"As measured", true},
                      {"Shift taken back", true},
                      {"Nearest surface made by"}},
                     rows) +
         "</section>\n";
}

std::string stock_section(const ProbeResult& result) {
  std::vector<html::Row> rows;
  for (const CutBy& stage : result.stages)
    rows.push_back({{escape_markup(stage.name), "<code>" + escape_markup(stage.cutter) + "</code>",
                     grouped(stage.moves), shown_length(stage.chord_error_mm)},
                    {}});
  std::string remarks;
  for (const std::string& remark : result.remarks)
    remarks += "<li>" + escape_markup(remark) + "</li>\n";
  return "<section id=\"stock\"><h2>The simulated stock</h2>\n" +
         html::table("Stages that cut it",
                     {{"Stage"}, {"Cutter"}, {"Moves", true}, {"Arcs to chords", true}}, rows) +
         "<p>A residual is the distance to what these cutters left, worked out exactly and not "
         "from "
         "voxels: positive in the air, negative within the material. The interval beside it is "
         "certified to hold that distance; it takes in how far arcs are from the chords that stand "
         "for them. Neither form errors of the real cutter nor its deflection are in it: they are "
         "what the residuals show.</p>\n" +
         (remarks.empty() ? "" : "<ul>\n" + remarks + "</ul>\n") + "</section>\n";
}

}  // namespace

void write_probe_html(const ProbeResult& result, std::ostream& out) {
  const html::Script style = {{}, {}, embedded::probe_css()};
  out << html::shell_head(result.job + ", measured", style) << probe_masthead(result)
      << "<main id=\"figures\" tabindex=\"-1\">\n"
      << shift_section(result) << residuals_section(result) << points_section(result)
      << stock_section(result)
      << "</main>\n<footer><p>probe.csv beside this page has every point, probe.json the figures."
         "</p></footer>\n"
      << html::shell_end(style, {});
}

}  // namespace limitgauge::reports::probe
