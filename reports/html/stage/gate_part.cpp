#include "reports/html/stage/gate_part.h"

#include <cmath>

#include "reports/html/charts.h"
#include "reports/html/markup.h"
#include "reports/run/gate_figures.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

std::string ratio_text(const verifier::Interval& interval, bool has_limit, double limit_mm) {
  if (!has_limit) return "–";
  const double ratio = accuracy_ratio(interval, limit_mm);
  if (!std::isfinite(ratio)) return "exact";
  const std::string text = three_digits(ratio) + " : 1";
  if (ratio >= kLeastAccuracyRatio) return text;
  return text + " <strong class=\"warn\">below 4 : 1</strong>";
}

}  // namespace

std::string gate_part(const StageResult& stage) {
  const verifier::StageDeviation& d = stage.ran->deviation;
  const verifier::GateLimits& l = stage.limits;
  const std::vector<GateFigure> figures = gate_figures(stage);
  const std::string charts[] = {interval_chart(d.gouge_mm, l.has_gouge, l.gouge_mm),
                                interval_chart(d.uncut_mm, l.has_uncut, l.uncut_mm)};
  const std::string ratios[] = {ratio_text(d.gouge_mm, l.has_gouge, l.gouge_mm),
                                ratio_text(d.uncut_mm, l.has_uncut, l.uncut_mm)};
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const GateFigure& f = figures[i];
    rows.push_back({f.name, f.measured, i < 2 ? charts[i] : "",
                    f.limit.empty() ? "–" : f.relation + f.limit, i < 2 ? ratios[i] : "",
                    badge(f.standing)});
  }
  return table(
      "Gate figures. An interval is proven: some point reaches its lower end, no point of "
      "the surface exceeds its upper end.",
      {{"Figure"},
       {"Measured", true},
       {"Interval and limit"},
       {"Limit", true},
       {"Limit : interval", true},
       {"Standing"}},
      rows);
}

}  // namespace limitgauge::reports::html
