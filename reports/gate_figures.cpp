#include "reports/gate_figures.h"

#include <algorithm>
#include <limits>

#include "reports/process.h"
#include "reports/text.h"

namespace limitgauge::reports {
namespace {

GateFigure length_figure(const char* what, const verifier::Interval& interval, bool has_limit,
                         double limit_mm) {
  const LengthUnit unit = unit_for(std::max(interval.high, has_limit ? limit_mm : 0.0));
  GateFigure figure{
      what, Standing::no_limit, interval_numbers(interval, unit) + " " + unit.symbol, {}};
  if (!has_limit) return figure;
  figure.standing = standing_of(interval, limit_mm);
  figure.limit = shortest(std::stod(fixed(limit_mm * unit.per_mm, 9))) + " " + unit.symbol;
  return figure;
}

GateFigure coverage_figure(double coverage, const verifier::GateLimits& limits) {
  GateFigure figure{"coverage", Standing::no_limit, percent_text(coverage), {}};
  if (!limits.has_coverage) return figure;
  figure.standing = coverage >= limits.coverage ? Standing::within : Standing::beyond;
  figure.limit = percent_text(limits.coverage);
  return figure;
}

GateFigure count_figure(const char* what, std::size_t count) {
  return {what, count == 0 ? Standing::within : Standing::beyond, grouped(count), "0"};
}

}  // namespace

Standing standing_of(const verifier::Interval& interval_mm, double limit_mm) {
  if (interval_mm.high <= limit_mm) return Standing::within;
  return interval_mm.low > limit_mm ? Standing::beyond : Standing::undecided;
}

double accuracy_ratio(const verifier::Interval& interval_mm, double limit_mm) {
  const double width = interval_mm.width();
  return width > 0 ? limit_mm / width : std::numeric_limits<double>::infinity();
}

std::vector<GateFigure> gate_figures(const StageResult& stage) {
  if (!stage.ran) {
    std::vector<GateFigure> none;
    for (const char* what :
         {"gouge", "uncut", "coverage", "rapid collisions", "holder collisions", "process faults"})
      none.push_back({what, Standing::not_run, {}, {}});
    return none;
  }
  const verifier::StageDeviation& d = stage.ran->deviation;
  const verifier::GateLimits& l = stage.limits;
  const std::span<const simulator::Finding> process = stage.ran->process;
  const std::size_t rapid = count(process, {simulator::FindingKind::rapid_through_stock});
  const auto holder = static_cast<std::size_t>(
      std::count_if(process.begin(), process.end(),
                    [](const simulator::Finding& f) { return is_holder_collision(f.kind); }));
  return {length_figure("gouge", d.gouge_mm, l.has_gouge, l.gouge_mm),
          length_figure("uncut", d.uncut_mm, l.has_uncut, l.uncut_mm),
          coverage_figure(d.coverage, l),
          count_figure("rapid collisions", rapid),
          count_figure("holder collisions", holder),
          count_figure("process faults", faults(process) - rapid - holder)};
}

const char* name(Standing standing) {
  switch (standing) {
    case Standing::within:
      return "within";
    case Standing::beyond:
      return "beyond";
    case Standing::undecided:
      return "undecided";
    case Standing::no_limit:
      return "no limit";
    case Standing::not_run:
      return "not run";
  }
  return "not run";
}

}  // namespace limitgauge::reports
