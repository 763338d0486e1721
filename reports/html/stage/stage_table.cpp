#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/html/charts.h"
#include "reports/html/markup.h"
#include "reports/html/stage/stage_parts.h"
#include "reports/html/tolerance_line.h"
#include "reports/run/gate_figures.h"
#include "reports/run/process.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

/// Where they stand in gate_figures().
constexpr std::size_t kGougeFigure = 0, kUncutFigure = 1, kCoverageFigure = 2;

/// A column of machining times in one unit.
class TimeColumn {
 public:
  explicit TimeColumn(const std::vector<StageResult>& stages) {
    constexpr double kMinute_s = 60;
    for (const StageResult& stage : stages)
      if (stage.ran && stage.ran->machining_time_s >= kMinute_s) long_ = true;
  }
  Column column() const { return {long_ ? "Machining time, h:min:s" : "Machining time, s", true}; }
  std::string cell(const StageResult& stage) const {
    if (!stage.ran) return "–";
    const double seconds = stage.ran->machining_time_s;
    return long_ ? clock_text(seconds) : fixed(seconds, 1);
  }

 private:
  bool long_ = false;
};

std::string ratio_text(const GateFigure::Length& figure) {
  const double ratio = accuracy_ratio(figure.interval_mm, *figure.limit_mm);
  if (!std::isfinite(ratio)) return "exact";
  const std::string text =
      fmt::format("<span title=\"limit : interval\">{} : 1</span>", three_digits(ratio));
  if (ratio >= kLeastAccuracyRatio) return text;
  return text + " <strong class=\"warn\">below 4 : 1</strong>";
}

std::string standing_badge(const GateFigure& figure) {
  const bool speaks = figure.standing == Standing::beyond || figure.standing == Standing::undecided;
  return speaks ? "<small>" + badge(figure.standing) + "</small>" : std::string();
}

/// Of a certified figure the interval, its limit, how wide it is against that, and both drawn.
std::string length_cell(const GateFigure& figure, const LengthUnit& unit) {
  if (figure.standing == Standing::not_run || !figure.length) return "–";
  const GateFigure::Length& length = *figure.length;
  std::string out = figure.measured_in(unit);
  if (length.limit_mm)
    out += fmt::format("<small>limit {} · {}</small>", figure.limit_in(unit), ratio_text(length));
  return out + standing_badge(figure) +
         interval_chart(length.interval_mm, length.limit_mm.has_value(),
                        length.limit_mm.value_or(0));
}

std::string without_percent(const std::string& text) {
  return text.substr(0, text.rfind(" %"));
}

std::string coverage_cell(const GateFigure& figure) {
  if (figure.standing == Standing::not_run) return "–";
  std::string out = without_percent(figure.measured);
  if (!figure.limit.empty()) out += "<small>limit " + without_percent(figure.limit) + "</small>";
  return out + standing_badge(figure);
}

std::string setup_words(const StageResult& stage) {
  return stage.setup.name.empty() ? std::string() : ", setup " + escape_markup(stage.setup.name);
}

/// What stands in a row whether there is a design or not.
std::vector<std::string> first_cells(const StageResult& stage, std::size_t index) {
  return {
      fmt::format("<a href=\"#{}\">{}</a>", stage_anchor(index), escape_markup(stage.name)),
      badge(stage.verdict()),
      escape_markup(stage.tool) + "<small>" + path_source(stage) + setup_words(stage) + "</small>"};
}

std::string process_faults_cell(const StageResult& stage) {
  return stage.ran ? grouped(faults(stage.ran->process)) : "–";
}

using TableRows = std::vector<std::vector<std::string>>;

std::string cut_table(const RunResult& result) {
  const TimeColumn times(result.stages);
  TableRows rows;
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    const StageResult& stage = result.stages[i];
    std::vector<std::string>& cells = rows.emplace_back(first_cells(stage, i));
    cells.push_back(stage.ran ? three_digits(stage.ran->removed_volume_mm3 / 1000) : "–");
    cells.push_back(process_faults_cell(stage));
    cells.push_back(times.cell(stage));
  }
  return table("What was cut, without a design to measure it against.",
               {{"Stage"},
                {"Verdict"},
                {"Tool, path"},
                {"Removed volume, cm³", true},
                {"Process faults", true},
                times.column()},
               rows);
}

/// The unit of the column of one gate figure.
LengthUnit unit_of_column(const std::vector<std::vector<GateFigure>>& stages, std::size_t figure) {
  std::vector<GateFigure> column;
  for (const std::vector<GateFigure>& figures : stages) column.push_back(figures[figure]);
  return column_unit(column);
}

std::string design_table(const RunResult& result) {
  const TimeColumn times(result.stages);
  std::vector<std::vector<GateFigure>> figures;
  for (const StageResult& stage : result.stages) figures.push_back(gate_figures(stage));
  const LengthUnit gouge = unit_of_column(figures, kGougeFigure),
                   uncut = unit_of_column(figures, kUncutFigure);
  TableRows rows;
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    std::vector<std::string>& cells = rows.emplace_back(first_cells(result.stages[i], i));
    cells.push_back(length_cell(figures[i][kGougeFigure], gouge));
    cells.push_back(length_cell(figures[i][kUncutFigure], uncut));
    cells.push_back(coverage_cell(figures[i][kCoverageFigure]));
    cells.push_back(process_faults_cell(result.stages[i]));
    cells.push_back(times.cell(result.stages[i]));
  }
  return table(
      std::string(
          "Gouge and uncut are runs along the normals against the stage's own allowance surface, "
          "as "
          "proven intervals: some point reaches the lower end, no point of the surface exceeds the "
          "upper one.") +
          toleranced_table_words(result),
      {{"Stage"},
       {"Verdict"},
       {"Tool, path"},
       {std::string("Gouge, ") + gouge.symbol, true},
       {std::string("Uncut, ") + uncut.symbol, true},
       {"Coverage, %", true},
       {"Process faults", true},
       times.column()},
      rows);
}

}  // namespace

std::string stage_table(const RunResult& result) {
  return "<section id=\"stages\"><h2>Stages</h2>\n" +
         (result.surface && !result.stages.empty() ? design_table(result) : cut_table(result)) +
         "</section>\n";
}

}  // namespace limitgauge::reports::html
