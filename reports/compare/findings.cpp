#include "reports/compare/run_comparison.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

#include "reports/compare/matching.h"
#include "reports/compare/noise.h"

namespace limitgauge::reports::compare {
namespace {

using record::Place;
using record::ProcessFinding;

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
/// Of the reach: places closer together than this are where they were.
constexpr double kStill = 0.1;

/// One list of findings of one run, and from which depth on it counts.
struct Side {
  std::vector<FoundPlace> places;
  std::vector<Spot> spots;
  double limit_mm = kUnlimited;   ///< of the gate: what is deeper fails the stage
  double listed_mm = kUnlimited;  ///< whatever is deeper is in the list for certain

  void add(FoundPlace place, double reach_mm) {
    spots.push_back({place.at_mm, reach_mm});
    places.push_back(std::move(place));
  }
};

struct Kind {
  std::string name;
  double floor_mm = 0;  ///< of depths
  double reach_mm = 0;
  bool judged = true;
};

Judgement judged(const Kind& kind, bool counts, Judgement judgement) {
  return kind.judged && counts ? judgement : Judgement::not_judged;
}

/// Nothing where the two are alike.
std::optional<FindingChange> matched(const Kind& kind, const Side& base, const Side& now,
                                     const Match& match) {
  const FoundPlace& from = base.places[match.base];
  const FoundPlace& to = now.places[match.now];
  FindingChange out{kind.name, FindingStatus::moved, Judgement::not_judged, from,
                    to,        match.distance_mm};
  if (to.depth_mm > from.depth_mm + kind.floor_mm) {
    out.status = FindingStatus::deeper;
    out.judgement = judged(kind, to.depth_mm > now.limit_mm, Judgement::worse);
  } else if (to.depth_mm < from.depth_mm - kind.floor_mm) {
    out.status = FindingStatus::shallower;
    out.judgement = judged(kind, from.depth_mm > base.limit_mm, Judgement::better);
  } else if (match.distance_mm <= kStill * kind.reach_mm) {
    return std::nullopt;
  }
  return out;
}

/// A place that only one run lists counts where the other would have listed it, had it been there.
bool counts_alone(const Kind& kind, const FoundPlace& place, const Side& own, const Side& other) {
  return place.depth_mm > own.limit_mm && place.depth_mm > other.listed_mm + kind.floor_mm;
}

void compare_sides(const Kind& kind, const Side& base, const Side& now, StageComparison& out) {
  std::vector<char> has_base(base.spots.size()), has_now(now.spots.size());
  for (const Match& match : match_spots(base.spots, now.spots)) {
    has_base[match.base] = has_now[match.now] = 1;
    if (std::optional<FindingChange> change = matched(kind, base, now, match))
      out.findings.push_back(std::move(*change));
    else
      ++out.same_findings;
  }
  for (std::size_t i = 0; i < has_now.size(); ++i) {
    if (has_now[i]) continue;
    const bool counts = counts_alone(kind, now.places[i], now, base);
    out.findings.push_back({kind.name, FindingStatus::fresh, judged(kind, counts, Judgement::worse),
                            std::nullopt, now.places[i], 0});
  }
  for (std::size_t i = 0; i < has_base.size(); ++i) {
    if (has_base[i]) continue;
    const bool counts = counts_alone(kind, base.places[i], base, now);
    out.findings.push_back({kind.name, FindingStatus::gone, judged(kind, counts, Judgement::better),
                            base.places[i], std::nullopt, 0});
  }
}

/// The certificate's witness stands in the list however shallow it is: the figure has it already.
Side places_of(const std::vector<Place>& places, double threshold_mm, bool is_complete,
               double limit_mm, double reach_mm) {
  Side side;
  for (const Place& place : places)
    if (place.depth_mm >= threshold_mm)
      side.add(found_place(place), std::max(reach_mm, place.extent_mm / 2));
  side.limit_mm = limit_mm;
  side.listed_mm = is_complete ? threshold_mm : kUnlimited;
  return side;
}

double gouge_limit_mm(const record::StageRecord& stage) {
  return stage.limits.has_gouge ? stage.limits.gouge_mm : kUnlimited;
}

double uncut_limit_mm(const record::StageRecord& stage) {
  return stage.limits.has_uncut ? stage.limits.uncut_mm : kUnlimited;
}

Side gouges_of(const record::StageRecord& stage, double reach_mm) {
  const record::DeviationMeasures& m = *stage.measures->deviation;
  return places_of(m.gouges, m.gouge_threshold_mm, m.findings_complete, gouge_limit_mm(stage),
                   reach_mm);
}

Side uncuts_of(const record::StageRecord& stage, double reach_mm) {
  const record::DeviationMeasures& m = *stage.measures->deviation;
  return places_of(m.uncuts, m.uncut_threshold_mm, m.findings_complete, uncut_limit_mm(stage),
                   reach_mm);
}

/// The gate's limit of gouges holds for the stock, too; what was found of it is in the list.
Side missing_stock_of(const record::StageRecord& stage, double reach_mm) {
  const record::DeviationMeasures& m = *stage.measures->deviation;
  return places_of(m.missing_stock, m.gouge_threshold_mm, m.findings_complete,
                   gouge_limit_mm(stage), reach_mm);
}

/// The one place that reaches a figure over tolerances, as far as it is a finding: with a limit,
/// one beyond it. Nothing lies deeper than the figure's upper end.
Side reached_of(const std::optional<Place>& place, const verifier::Interval& figure_mm,
                double limit_mm, double reach_mm) {
  Side side;
  const bool is_limited = limit_mm < kUnlimited;
  if (place && (!is_limited || place->depth_mm > limit_mm)) side.add(found_place(*place), reach_mm);
  side.limit_mm = limit_mm;
  side.listed_mm = is_limited ? std::max(figure_mm.high, limit_mm) : figure_mm.high;
  return side;
}

Side robust_gouge_of(const record::StageRecord& stage, double reach_mm) {
  const record::RobustMeasures& m = *stage.measures->deviation->robust;
  return reached_of(m.gouge, m.gouge_mm, gouge_limit_mm(stage), reach_mm);
}

Side robust_uncut_of(const record::StageRecord& stage, double reach_mm) {
  const record::RobustMeasures& m = *stage.measures->deviation->robust;
  return reached_of(m.uncut, m.uncut_mm, uncut_limit_mm(stage), reach_mm);
}

/// Faults of one kind, part and obstacle, and whether they fail the stage.
using ProcessKey = std::tuple<std::string, bool, std::string, std::string>;

std::map<ProcessKey, Side> process_of(const record::StageRecord& stage, double reach_mm) {
  std::map<ProcessKey, Side> out;
  for (const ProcessFinding& f : stage.measures->process_findings)
    out[{f.kind, f.fails, f.part, f.against}].add(found_place(f, stage.name), reach_mm);
  return out;
}

/// Every fault is listed and every fault fails: there is no depth below which one does not count.
void compare_process(const record::StageRecord& base, const record::StageRecord& now,
                     double reach_mm, const Options& options, StageComparison& out) {
  std::map<ProcessKey, Side> of_base = process_of(base, reach_mm),
                             of_now = process_of(now, reach_mm);
  for (const auto& [key, side] : of_now) of_base.try_emplace(key);
  for (auto& [key, side] : of_base) {
    Side& other = of_now[key];
    const auto& [name, fails, part, against] = key;
    const double voxel_mm = std::max(base.measures->voxel_mm, now.measures->voxel_mm);
    const Kind kind{name, voxel_mm, reach_mm, fails && is_judged(options, "process")};
    for (Side* s : {&side, &other}) s->limit_mm = s->listed_mm = -kUnlimited;
    compare_sides(kind, side, other, out);
  }
}

int rank(Judgement judgement) {
  switch (judgement) {
    case Judgement::worse:
      return 0;
    case Judgement::better:
      return 1;
    default:
      return 2;
  }
}

/// Of one stage, or one that is compared with it.
using PlacesOf = Side (*)(const record::StageRecord& stage, double reach_mm);

/// Places of one kind on the design, which the metric of that name counts.
void compare_places(const std::string& kind, PlacesOf places_of, const record::StageRecord& base,
                    const record::StageRecord& now, double reach_mm, const Options& options,
                    StageComparison& out) {
  const double floor_mm = fineness_of(*base.measures, *now.measures).resolution_mm;
  compare_sides({kind, floor_mm, reach_mm, is_judged(options, kind + "_mm")},
                places_of(base, reach_mm), places_of(now, reach_mm), out);
}

void compare_deviation_findings(const record::StageRecord& base, const record::StageRecord& now,
                                double reach_mm, const Options& options, StageComparison& out) {
  compare_places("gouge", gouges_of, base, now, reach_mm, options, out);
  compare_places("uncut", uncuts_of, base, now, reach_mm, options, out);
  compare_places("missing_stock", missing_stock_of, base, now, reach_mm, options, out);
}

/// Where figures over the same tolerances are reached: these decide then, and may fail a stage of
/// which no stated place does.
void compare_reached(const record::StageRecord& base, const record::StageRecord& now,
                     double reach_mm, const Options& options, StageComparison& out) {
  compare_places("robust_gouge", robust_gouge_of, base, now, reach_mm, options, out);
  compare_places("robust_uncut", robust_uncut_of, base, now, reach_mm, options, out);
}

bool has_robust(const record::StageRecord& stage) {
  return stage.measures->deviation && stage.measures->deviation->robust;
}

}  // namespace

void compare_findings(const record::StageRecord& base, const record::StageRecord& now,
                      const RunContext& run, StageComparison& out) {
  if (base.measures->deviation && now.measures->deviation)
    compare_deviation_findings(base, now, run.reach_mm, run.options, out);
  if (run.same_tolerances && has_robust(base) && has_robust(now))
    compare_reached(base, now, run.reach_mm, run.options, out);
  compare_process(base, now, run.reach_mm, run.options, out);
  std::stable_sort(out.findings.begin(), out.findings.end(),
                   [](const FindingChange& a, const FindingChange& b) {
                     return std::pair(rank(a.judgement), -depth_mm(a)) <
                            std::pair(rank(b.judgement), -depth_mm(b));
                   });
}

}  // namespace limitgauge::reports::compare
