#include <cmath>
#include <string>

#include "reports/compare/noise.h"
#include "reports/compare/run_comparison.h"
#include "reports/record/tolerance_ranges.h"
#include "reports/text/text.h"

namespace limitgauge::reports::compare {
namespace {

using model::Interval;
using model::Tolerances;

using Ranges = record::ToleranceRanges;

constexpr std::size_t kMostNamed = 4;

std::string end_text(double mm) {
  return (mm < 0 ? "−" : "") + stated_length(std::abs(mm));
}

std::string range_text(const Ranges& ranges, const std::string& name) {
  const auto found = ranges.find(name);
  if (found == ranges.end()) return "none";
  const Interval& range = found->second;
  if (range.low == -range.high) return "±" + stated_length(range.high);
  return end_text(range.low) + " to " + end_text(range.high);
}

/// Which way a box changed.
struct Change {
  bool narrower = false, wider = false;
  std::size_t count = 0;
  std::string words;  ///< "zero.x was ±5 µm, is ±2 µm"

  void add(const std::string& name, const Ranges& base, const Ranges& now) {
    const auto at = [&](const Ranges& all) {
      const auto found = all.find(name);
      return found == all.end() ? Interval{} : found->second;
    };
    const Interval was = at(base), is = at(now);
    const bool one_has_flat = name.ends_with(".flat") && base.contains(name) != now.contains(name);
    if (was.low == is.low && was.high == is.high && !one_has_flat) return;
    narrower = narrower || is.low > was.low || is.high < was.high || one_has_flat;
    wider = wider || is.low < was.low || is.high > was.high || one_has_flat;
    if (++count <= kMostNamed)
      words += (words.empty() ? "" : "; ") + name + " was " + range_text(base, name) + ", is " +
               range_text(now, name);
  }
};

Change change_of(const Ranges& base, const Ranges& now) {
  Ranges both = base;
  both.insert(now.begin(), now.end());
  Change out;
  for (const auto& [name, range] : both) out.add(name, base, now);
  if (out.count > kMostNamed) out.words += "; and " + grouped(out.count - kMostNamed) + " more";
  return out;
}

Judgement judgement_of(const Change& change) {
  if (change.narrower == change.wider) return Judgement::not_judged;
  return change.narrower ? Judgement::worse : Judgement::better;
}

const char* verb_of(const Change& change) {
  if (change.narrower == change.wider) return "changed";
  return change.narrower ? "narrowed" : "widened";
}

bool same_limit(bool has_base, double base, bool has_now, double now) {
  return has_base == has_now && (!has_base || base == now);
}

bool same_limits(const verifier::GateLimits& a, const verifier::GateLimits& b) {
  return same_limit(a.has_gouge, a.gouge_mm, b.has_gouge, b.gouge_mm) &&
         same_limit(a.has_uncut, a.uncut_mm, b.has_uncut, b.uncut_mm);
}

}  // namespace

std::optional<Remark> compare_tolerances(const std::optional<Tolerances>& base,
                                         const std::optional<Tolerances>& now,
                                         const Options& options) {
  const auto remark = [&](Judgement judgement, const std::string& text) {
    return Remark{"tolerances", if_judged(options, "gate", judgement), "tolerances were " + text};
  };
  if (!base && !now) return std::nullopt;
  if (!now)
    return remark(Judgement::worse, "taken away: the gates judge gouge and uncut as stated alone");
  if (!base)
    return remark(Judgement::better, "set: the gates judge gouge and uncut over all their values");
  const Change change = change_of(record::tolerance_ranges(*base), record::tolerance_ranges(*now));
  if (change.count == 0) return std::nullopt;
  return remark(judgement_of(change),
                std::string(verb_of(change)) + " (" + change.words +
                    "): figures over them and margins are not held against each other");
}

void leave_other_questions(const record::StageRecord& base, const record::StageRecord& now,
                           bool same_tolerances, std::vector<FigureChange>& figures) {
  const bool limits_differ = !same_limits(base.limits, now.limits);
  for (FigureChange& figure : figures) {
    if (!record::is_over_tolerances(figure.metric->id)) continue;
    const bool of_other_limit = limits_differ && is_margin(*figure.metric);
    if (same_tolerances && !of_other_limit) continue;
    figure.judgement = Judgement::not_judged;
    figure.floor.reset();
    figure.why =
        same_tolerances ? "of another limit than before" : "of other tolerances than before";
  }
}

}  // namespace limitgauge::reports::compare
