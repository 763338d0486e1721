#include "reports/run/gate_figures.h"

#include <algorithm>
#include <limits>

#include "model/text/number_text.h"
#include "reports/run/process.h"
#include "reports/text/text.h"
#include "reports/tolerance.h"
#include "verifier/gate/verify.h"

namespace limitgauge::reports {
namespace {

GateFigure length_figure(const char* what, const verifier::Interval& interval, bool has_limit,
                         double limit_mm) {
  GateFigure figure{what, Standing::no_limit, {}, {}, "≤ "};
  figure.length = {interval, has_limit ? std::optional(limit_mm) : std::nullopt};
  const LengthUnit unit = column_unit({figure});
  figure.measured = figure.measured_in(unit) + " " + unit.symbol;
  if (!has_limit) return figure;
  figure.standing = standing_of(interval, limit_mm);
  figure.limit = figure.limit_in(unit) + " " + unit.symbol;
  return figure;
}

GateFigure coverage_figure(double coverage, const verifier::GateLimits& limits) {
  GateFigure figure{"coverage", Standing::no_limit, percent_text(coverage), {}, "≥ "};
  if (!limits.has_coverage) return figure;
  figure.standing = coverage >= limits.coverage ? Standing::within : Standing::beyond;
  figure.measured = percent_beside(coverage, limits.coverage);
  figure.limit = stated_percent(limits.coverage);
  return figure;
}

std::string area_text(double mm2) {
  return (mm2 == 0 ? "0" : three_digits(mm2)) + " mm²";
}

/// Two numbers in three digits, rounded outwards, each on its side of the limit.
std::string range_numbers(const verifier::Interval& figure, const std::optional<double>& limit) {
  const auto end = [&](double value, model::Rounding rounding) {
    return model::rounded_text(value, model::significant_decimals(value, 3), rounding, limit);
  };
  if (figure.low == figure.high) return end(figure.low, model::Rounding::nearest);
  return end(figure.low, model::Rounding::down) + " to " + end(figure.high, model::Rounding::up);
}

/// "12.3 mm² (4.10 %)", with "12.3 to 12.9 mm² (4.10 to 4.30 %)" where some is undecided.
std::string reach_text(const verifier::Interval& area_mm2, double whole_mm2,
                       const std::optional<double>& limit_mm2 = std::nullopt) {
  if (!(whole_mm2 > 0)) return area_text(area_mm2.high);
  const bool none = area_mm2.low < kNoArea_mm2 && area_mm2.low < area_mm2.high;
  const double percent = 100 / whole_mm2;
  const verifier::Interval area{none ? 0 : area_mm2.low, area_mm2.high};
  std::optional<double> share_limit;
  if (limit_mm2) share_limit = *limit_mm2 * percent;
  return range_numbers(area, limit_mm2) + " mm² (" +
         range_numbers({area.low * percent, area.high * percent}, share_limit) + " %)";
}

GateFigure unreachable_figure(const verifier::StageDeviation& d, const verifier::GateLimits& l) {
  const verifier::Interval area_mm2 = unreachable_area_mm2(d);
  const double whole_mm2 = whole_area_mm2(d);
  GateFigure figure{"unreachable", Standing::no_limit, reach_text(area_mm2, whole_mm2), {}, "≤ "};
  if (l.has_unreachable && whole_mm2 > 0) {
    const double unit_mm2 = l.unreachable_is_share ? whole_mm2 : 1;
    figure.measured = reach_text(area_mm2, whole_mm2, l.unreachable * unit_mm2);
    figure.standing =
        standing_of({area_mm2.low / unit_mm2, area_mm2.high / unit_mm2}, l.unreachable);
    figure.limit = l.unreachable_is_share
                       ? model::shortest(std::stod(fixed(100 * l.unreachable, 9))) + " %"
                       : model::shortest(l.unreachable) + " mm²";
  }
  // Whatever the limit: what no cutter touches at all is no part of the work.
  const verifier::Verdict any = judge_any_reach(d, l);
  if (any == verifier::Verdict::fail) figure.standing = Standing::beyond;
  if (any == verifier::Verdict::indeterminate && figure.standing != Standing::beyond)
    figure.standing = Standing::undecided;
  return figure;
}

/// What concerns reach and stock, see gate_figures().
void add_reach(const verifier::StageDeviation& d, const verifier::GateLimits& l,
               std::vector<GateFigure>& out) {
  out.push_back(unreachable_figure(d, l));
  if (l.has_unavoidable || unreachable_area_mm2(d).low > 0)
    out.push_back(length_figure("unavoidable uncut", d.unavoidable_uncut_mm, l.has_unavoidable,
                                l.unavoidable_mm));
  if (d.missing_stock_mm.high > 0)
    out.push_back(length_figure("missing stock", d.missing_stock_mm, l.has_gouge, l.gouge_mm));
}

/// The figures without tolerances, beside those that the gate judges.
void add_stated(const verifier::StageDeviation& d, std::vector<GateFigure>& out) {
  out.push_back(length_figure("gouge as stated", d.gouge_mm, false, 0));
  out.push_back(length_figure("uncut as stated", d.uncut_mm, false, 0));
}

/// Figures of what is measured against a design.
void add_deviation(const verifier::StageDeviation& d, const verifier::GateLimits& l,
                   std::vector<GateFigure>& out) {
  out = {length_figure("gouge", judged_gouge_mm(d), l.has_gouge, l.gouge_mm),
         length_figure("uncut", judged_uncut_mm(d), l.has_uncut, l.uncut_mm),
         coverage_figure(d.coverage, l)};
  if (d.robust) add_stated(d, out);
  add_reach(d, l, out);
}

std::vector<GateFigure> figures_not_run(const StageResult& stage) {
  std::vector<GateFigure> none;
  const auto add = [&](std::initializer_list<const char*> names) {
    for (const char* what : names) none.push_back({what, Standing::not_run, {}, {}});
  };
  if (stage.allowance_mm) add({"gouge", "uncut", "coverage", "unreachable"});
  add({"rapid collisions", "holder collisions", "process faults"});
  return none;
}

GateFigure count_figure(const char* what, std::size_t count) {
  return {what, count == 0 ? Standing::within : Standing::beyond, grouped(count), "0"};
}

/// A pass of a program that cuts nothing is no praise.
std::vector<std::string> cut_notes(const StageRun& ran) {
  if (ran.removal.totals.volume_mm3 > 0) return {};
  // A sliver between the lines of material is touched by moves that take none of them.
  if (faults(ran.process) > 0) return {"nothing was cut"};
  return {"nothing was cut: no move came to the stock; are stock, program and tool in one frame?"};
}

/// A stage with a design may pass for what others left; that it did nothing is said.
std::vector<std::string> path_notes(const StageResult& stage) {
  if (stage.ran->cut_length_mm > 0) return {};
  if (stage.strategy == "rest")
    return {"no moves, since nothing that this cutter can reach was left beyond the threshold"};
  return {"no moves that cut"};
}

}  // namespace

std::string GateFigure::measured_in(const LengthUnit& unit) const {
  return length ? interval_numbers(length->interval_mm, unit, length->limit_mm) : measured;
}

std::string GateFigure::limit_in(const LengthUnit& unit) const {
  return length && length->limit_mm ? stated_number(*length->limit_mm, unit) : limit;
}

LengthUnit column_unit(const std::vector<GateFigure>& figures) {
  double largest_mm = 0;
  for (const GateFigure& f : figures)
    if (f.length)
      largest_mm =
          std::max({largest_mm, f.length->interval_mm.high, f.length->limit_mm.value_or(0.0)});
  return unit_for(largest_mm);
}

Standing standing_of(const verifier::Interval& interval_mm, double limit_mm) {
  if (interval_mm.high <= limit_mm) return Standing::within;
  return interval_mm.low > limit_mm ? Standing::beyond : Standing::undecided;
}

double accuracy_ratio(const verifier::Interval& interval_mm, double limit_mm) {
  const double width = interval_mm.width();
  return width > 0 ? limit_mm / width : std::numeric_limits<double>::infinity();
}

std::vector<GateFigure> gate_figures(const StageResult& stage) {
  if (!stage.ran) return figures_not_run(stage);
  std::vector<GateFigure> out;
  if (stage.ran->deviation) {
    add_deviation(*stage.ran->deviation, stage.limits, out);
  } else if (stage.allowance_mm) {
    for (const char* what : {"gouge", "uncut", "coverage", "unreachable"})
      out.push_back({what, Standing::not_run, "–", {}});
  }
  const std::span<const simulator::Finding> process = stage.ran->process;
  const std::size_t rapid = count(process, {simulator::FindingKind::rapid_through_stock});
  const auto holder = static_cast<std::size_t>(
      std::count_if(process.begin(), process.end(),
                    [](const simulator::Finding& f) { return is_holder_collision(f.kind); }));
  out.push_back(count_figure("rapid collisions", rapid));
  out.push_back(count_figure("holder collisions", holder));
  out.push_back(count_figure("process faults", faults(process) - rapid - holder));
  return out;
}

std::vector<std::string> stage_notes(const StageResult& stage) {
  if (!stage.ran) return {};
  // A stretch of a program that turns rotary axes: only its last one needs to be.
  if (!stage.ran->deviation && stage.allowance_mm)
    return {"not measured: it is a stretch of a program that only positions, or has no limit"};
  if (!stage.ran->deviation) return cut_notes(*stage.ran);
  const verifier::StageDeviation& d = *stage.ran->deviation;
  std::vector<std::string> out = path_notes(stage);
  // By samples where there are no areas by proof.
  const bool proven = has_proven_areas(d);
  const verifier::Interval area_mm2 =
      proven ? unreachable_area_mm2(d)
             : verifier::Interval{d.unreachable_area_mm2, d.unreachable_area_mm2};
  const bool nothing_known = proven && d.proven_reach.reachable_mm2 <= 0;
  if (area_mm2.low > 0 || nothing_known)
    out.push_back("unreachable " + reach_text(area_mm2, whole_area_mm2(d)) +
                  ", unavoidable uncut up to " + measured_length(d.unavoidable_uncut_mm.high));
  if (d.missing_stock_mm.low > 0)
    out.push_back("missing stock " + length_figure("", d.missing_stock_mm, false, 0).measured +
                  ": so deep the surface lies outside the raw stock");
  if (d.missing_allowance)
    out.push_back("missing allowance " + measured_length(d.missing_allowance->depth_mm) +
                  ": so much of what is to be left lies outside the raw stock");
  return out;
}

bool is_note(const std::string& reason) {
  return reason.starts_with("unreachable: ");
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
