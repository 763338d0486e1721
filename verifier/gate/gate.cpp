#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "model/text/rounded.h"
#include "verifier/gate/gate_text.h"
#include "verifier/gate/verify.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

/// What is no more than rounding, as nothing.
Interval but_for(const Interval& figure, double rounding) {
  const auto floored = [&](double v) { return v <= rounding ? 0 : v; };
  return {floored(figure.low), floored(figure.high)};
}

Verdict judge(const Interval& figure, double limit_mm) {
  if (figure.high <= limit_mm) return Verdict::pass;
  return figure.low > limit_mm ? Verdict::fail : Verdict::indeterminate;
}

constexpr const char *kWithin = ": within the limit everywhere", *kEnough = ": enough";

const char* standing(Verdict verdict, bool is_narrow) {
  switch (verdict) {
    case Verdict::pass:
      return kWithin;
    case Verdict::fail:
      return ": beyond the limit";
    default:
      return is_narrow ? ": the limit lies within the interval, neither is proven"
                       : ": the limit lies within the interval, and no narrower one was proven";
  }
}

void worsen(Verdict& verdict, Verdict by) {
  const auto rank = [](Verdict v) {
    return v == Verdict::fail ? 2 : v == Verdict::indeterminate ? 1 : 0;
  };
  if (rank(by) > rank(verdict)) verdict = by;
}

/// "gouge", and by which body if not by the flutes alone.
std::string gouge_by(const StageDeviation& deviation) {
  std::string what = "gouge";
  for (const BodyFigure& b : deviation.bodies)
    if (b.body != "cutter" && b.gouge_mm.low > 0 && b.gouge_mm.low >= deviation.gouge_mm.low)
      what += " by the " + b.body;
  return what;
}

/// What one stage is judged by, and the words of its decision.
class Decision {
 public:
  Decision(const StageDeviation& deviation, const GateLimits& limits,
           std::span<const std::string> stages)
      : d_(deviation), limits_(limits), stages_(stages) {}

  void judge_runs();
  void judge_coverage();
  void judge_reach();
  std::string nothing_reached_text(Verdict any) const;
  void judge_missing_stock();
  void judge_process(const ProcessFault& fault);
  void tell_reach();
  GateDecision take() { return std::move(out_); }

 private:
  /// `where`: the words for the place, said of a figure that does not pass.
  void add(const std::string& sentence, Verdict verdict, const std::string& where) {
    out_.reasons.push_back(sentence + (verdict == Verdict::pass ? "" : where));
    worsen(out_.verdict, verdict);
  }
  void judge_run(const std::string& what, const Interval& stated, const RobustFigure* robust,
                 double limit_mm, const std::vector<Finding>& findings);
  void judge_length(const std::string& what, const Interval& figure, double limit_mm,
                    bool is_narrow, const std::string& where) {
    const Verdict verdict = judge(figure, limit_mm);
    add(what + " certified " + range_text(figure, limit_mm) + ", limit " +
            length_text(limit_mm, limit_mm) + standing(verdict, is_narrow),
        verdict, where);
  }
  void judge_unreachable();

  const StageDeviation& d_;
  const GateLimits& limits_;
  std::span<const std::string> stages_;
  GateDecision out_{Verdict::pass, {}};
};

void Decision::judge_runs() {
  if (limits_.has_gouge)
    judge_run(gouge_by(d_), d_.gouge_mm, d_.robust ? &d_.robust->gouge : nullptr, limits_.gouge_mm,
              d_.gouges);
  if (limits_.has_uncut)
    judge_run("uncut", d_.uncut_mm, d_.robust ? &d_.robust->uncut : nullptr, limits_.uncut_mm,
              d_.uncuts);
}

/// Where tolerances are stated, what they may lead to decides.
void Decision::judge_run(const std::string& what, const Interval& stated,
                         const RobustFigure* robust, double limit_mm,
                         const std::vector<Finding>& findings) {
  std::string deepest = deepest_text(findings, stages_, limit_mm);
  if (&findings == &d_.uncuts && d_.stock_blunt_mm > 0)
    deepest += "; what voxels of " + length_text(d_.stock_blunt_mm, limit_mm) +
               " make blunt of the stock counts as left";
  if (!robust) return judge_length(what, stated, limit_mm, d_.reached_resolution, deepest);
  judge_length(what + tolerances_text(*robust, stated, limit_mm), robust->figure_mm, limit_mm,
               robust->reached_resolution,
               judge(stated, limit_mm) == Verdict::pass ? reached_text(*robust) : deepest);
}

void Decision::judge_coverage() {
  if (!limits_.has_coverage) return;
  const bool enough = d_.coverage >= limits_.coverage;
  const auto share = [&](double value) {
    return model::rounded_text(value, 4, model::Rounding::down, limits_.coverage);
  };
  add("coverage " + share(d_.coverage) + " of the reachable area, least accepted " +
          share(limits_.coverage) + (enough ? kEnough : ": too little"),
      enough ? Verdict::pass : Verdict::fail, {});
}

/// What is proven to be out of reach is the low end, with what is undecided the high one.
void Decision::judge_unreachable() {
  const Interval area_mm2 = unreachable_area_mm2(d_);
  const double whole_mm2 = whole_area_mm2(d_);
  if (!(whole_mm2 > 0)) return;
  const double unit_mm2 = limits_.unreachable_is_share ? whole_mm2 : 1;
  const Verdict verdict =
      judge({area_mm2.low / unit_mm2, area_mm2.high / unit_mm2}, limits_.unreachable);
  add("unreachable certified " +
          area_range_text(area_mm2, whole_mm2, limits_.unreachable * unit_mm2) + ", limit " +
          (limits_.unreachable_is_share ? share_text(limits_.unreachable)
                                        : area_text(limits_.unreachable)) +
          (verdict == Verdict::pass ? ": within the limit" : standing(verdict, false)),
      verdict, out_of_reach_text(d_.field, stages_));
}

/// What is said of a stage of which nothing is proven to be in reach, some being out of it.
std::string Decision::nothing_reached_text(Verdict any) const {
  if (any == Verdict::indeterminate)
    return "none of the surface is proven to be in reach of a cutter used so far: indeterminate";
  return d_.proven_reach.undecided_mm2 > kNoArea_mm2
             ? "none of the surface is proven or sampled to be in reach of a cutter used so far"
             : "no cutter used so far can reach any of the surface";
}

void Decision::judge_reach() {
  if (const Verdict any = judge_any_reach(d_, limits_); any != Verdict::pass)
    add(nothing_reached_text(any), any, out_of_reach_text(d_.field, stages_));
  if (limits_.has_unreachable) judge_unreachable();
  if (limits_.has_unavoidable)
    judge_length("unavoidable uncut", but_for(d_.unavoidable_uncut_mm, kNoLength_mm),
                 limits_.unavoidable_mm, d_.reached_resolution,
                 out_of_reach_text(d_.field, stages_));
}

/// No program line is to blame, yet the part cannot come out of this stock: the limit is that of
/// gouges. Without one it is told and cannot fail.
void Decision::judge_missing_stock() {
  const Interval& figure = d_.missing_stock_mm;
  const std::optional<double> limit_mm =
      limits_.has_gouge ? std::optional(limits_.gouge_mm) : std::nullopt;
  const std::string range =
      "missing stock: S lies " + range_text(figure, limit_mm) + " outside the raw stock";
  const std::string where = deepest_text(d_.missing_stock, stages_, limit_mm);
  if (!limits_.has_gouge) {
    if (figure.low > 0) out_.reasons.push_back(range + where);
    return;
  }
  const Verdict verdict = judge(figure, limits_.gouge_mm);
  if (verdict == Verdict::pass && !(figure.low > 0)) return;
  add(range + ", limit " + length_text(limits_.gouge_mm, limits_.gouge_mm) +
          standing(verdict, d_.reached_resolution),
      verdict, where);
}

std::string fault_text(const ProcessFault& fault) {
  std::string text =
      fault.what + ": " + std::to_string(fault.count) + (fault.count == 1 ? " move" : " moves");
  if (fault.worst) {
    text += fault.worst->depth_mm > 0 ? "; deepest " + length_text(fault.worst->depth_mm) + " "
            : fault.is_open           ? "; neither shown nor excluded, begins "
                                      : std::string("; ");
    text += place_text(fault.worst->point);
    if (fault.worst->line > 0) text += ", program line " + std::to_string(fault.worst->line);
  }
  return text;
}

void Decision::judge_process(const ProcessFault& fault) {
  if (fault.count > 0) add(fault_text(fault), Verdict::fail, {});
}

/// Said beside every verdict: what is out of reach is judged by no other figure.
void Decision::tell_reach() {
  const StageDeviation::ProvenReach& reach = d_.proven_reach;
  const double area_mm2 = has_proven_areas(d_) ? reach.unreachable_mm2 : d_.unreachable_area_mm2;
  const double whole_mm2 = whole_area_mm2(d_);
  if (!(area_mm2 + reach.undecided_mm2 > kNoArea_mm2) || !(whole_mm2 > 0)) return;
  std::string text =
      "unreachable: " + area_text(area_mm2) + " (" + share_text(area_mm2 / whole_mm2) + ")";
  if (reach.undecided_mm2 > kNoArea_mm2) text += ", undecided " + area_text(reach.undecided_mm2);
  out_.reasons.push_back(text + ", unavoidable uncut up to " +
                         length_text(d_.unavoidable_uncut_mm.high));
}

}  // namespace

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::fail:
      return "fail";
    case Verdict::indeterminate:
      return "indeterminate";
    case Verdict::not_run:
      break;
  }
  return "not_run";
}

double automatic_resolution_mm(const GateLimits& limits) {
  constexpr double kUnlimited_mm = 0.001;
  double tightest = std::numeric_limits<double>::infinity();
  if (limits.has_gouge && limits.gouge_mm > 0) tightest = std::min(tightest, limits.gouge_mm);
  if (limits.has_uncut && limits.uncut_mm > 0) tightest = std::min(tightest, limits.uncut_mm);
  if (limits.has_unavoidable && limits.unavoidable_mm > 0)
    tightest = std::min(tightest, limits.unavoidable_mm);
  return std::isfinite(tightest) ? tightest / 10 : kUnlimited_mm;
}

const Interval& judged_gouge_mm(const StageDeviation& d) {
  return d.robust ? d.robust->gouge.figure_mm : d.gouge_mm;
}

const Interval& judged_uncut_mm(const StageDeviation& d) {
  return d.robust ? d.robust->uncut.figure_mm : d.uncut_mm;
}

Verdict judge_robust(const RobustDeviation& robust, const GateLimits& limits) {
  Verdict verdict = Verdict::pass;
  if (limits.has_gouge) worsen(verdict, judge(robust.gouge.figure_mm, limits.gouge_mm));
  if (limits.has_uncut) worsen(verdict, judge(robust.uncut.figure_mm, limits.uncut_mm));
  return verdict;
}

const RobustFigure* least_margin(const RobustDeviation& robust) {
  const RobustFigure* least = nullptr;
  const auto proven = [](const RobustFigure& f) { return f.margin->proven.value_or(-1); };
  for (const RobustFigure* figure : {&robust.gouge, &robust.uncut})
    if (figure->margin && (!least || proven(*figure) < proven(*least))) least = figure;
  return least;
}

double whole_area_mm2(const StageDeviation& d) {
  if (d.surface_area_mm2 > 0) return d.surface_area_mm2;
  return d.proven_reach.reachable_mm2 + d.proven_reach.unreachable_mm2 +
         d.proven_reach.undecided_mm2;
}

bool has_proven_areas(const StageDeviation& d) {
  const StageDeviation::ProvenReach& reach = d.proven_reach;
  return reach.reachable_mm2 + reach.unreachable_mm2 + reach.undecided_mm2 > kNoArea_mm2;
}

Interval unreachable_area_mm2(const StageDeviation& d) {
  const StageDeviation::ProvenReach& reach = d.proven_reach;
  // The whole is summed otherwise than its parts.
  const double whole_mm2 = whole_area_mm2(d);
  return but_for({std::min(reach.unreachable_mm2, whole_mm2),
                  std::min(reach.unreachable_mm2 + reach.undecided_mm2, whole_mm2)},
                 kNoArea_mm2);
}

Verdict judge_any_reach(const StageDeviation& d, const GateLimits& limits) {
  const StageDeviation::ProvenReach& reach = d.proven_reach;
  if (d.surface_area_mm2 <= 0 || reach.reachable_mm2 > kNoArea_mm2) return Verdict::pass;
  const bool sampled = d.reachable_area_mm2 > 0;
  if (reach.all_is_judged)
    return sampled || limits.has_uncut ? Verdict::pass : Verdict::indeterminate;
  if (!has_proven_areas(d) || !reach.is_mapped) return sampled ? Verdict::pass : Verdict::fail;
  return sampled && reach.undecided_mm2 > kNoArea_mm2 ? Verdict::indeterminate : Verdict::fail;
}

GateDecision decide(const StageDeviation& deviation, const GateLimits& limits,
                    std::span<const ProcessFault> faults, std::span<const std::string> stages) {
  Decision decision(deviation, limits, stages);
  decision.judge_runs();
  decision.judge_coverage();
  decision.judge_reach();
  decision.judge_missing_stock();
  for (const ProcessFault& fault : faults) decision.judge_process(fault);
  decision.tell_reach();
  return decision.take();
}

GateDecision decide(std::span<const ProcessFault> faults) {
  GateDecision decision{Verdict::pass, {}};
  for (const ProcessFault& fault : faults) {
    if (fault.count == 0) continue;
    decision.verdict = Verdict::fail;
    decision.reasons.push_back(fault_text(fault));
  }
  if (decision.verdict == Verdict::pass)
    decision.reasons.push_back("no fault in the process; nothing was measured against a design");
  return decision;
}

bool tells_a_pass(const std::string& reason) {
  return reason.ends_with(kWithin) || reason.ends_with(kEnough);
}

}  // namespace limitgauge::verifier
