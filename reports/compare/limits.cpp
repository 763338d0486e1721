#include <algorithm>
#include <cmath>
#include <limits>

#include "model/base/error.h"
#include "model/part/cutter.h"
#include "model/text/number_text.h"
#include "reports/compare/comparison_text.h"
#include "reports/compare/run_comparison.h"
#include "reports/text/text.h"

/// Limits that gave way between two runs, or were set.
namespace limitgauge::reports::compare {
namespace {

struct Limit {
  const char* what;
  bool has_base, has_now;
  double base, now;
  bool more_is_looser;
  std::string (*text)(double) = stated_length;
};

std::string stated_area(double mm2) {
  return model::shortest(mm2) + " mm²";
}

void compare_limit(const Limit& limit, const Options& options, std::vector<Remark>& out) {
  const std::string what = std::string("limit of ") + limit.what + " ";
  const auto remark = [&](Judgement judgement, const std::string& text) {
    out.push_back({"gate", if_judged(options, "gate", judgement), what + text});
  };
  if (limit.has_base && !limit.has_now)
    return remark(Judgement::worse, "taken away: it was " + limit.text(limit.base));
  if (!limit.has_base && limit.has_now)
    return remark(Judgement::better, "set: " + limit.text(limit.now));
  if (!limit.has_base || limit.base == limit.now) return;
  const bool is_looser = (limit.now > limit.base) == limit.more_is_looser;
  remark(is_looser ? Judgement::worse : Judgement::better,
         std::string(is_looser ? "loosened" : "tightened") + " from " + limit.text(limit.base) +
             " to " + limit.text(limit.now));
}

}  // namespace

std::vector<Remark> compare_gates(const verifier::GateLimits& base, const verifier::GateLimits& now,
                                  const Options& options) {
  std::vector<Remark> out;
  for (const Limit& limit :
       {Limit{"gouge", base.has_gouge, now.has_gouge, base.gouge_mm, now.gouge_mm, true},
        Limit{"uncut", base.has_uncut, now.has_uncut, base.uncut_mm, now.uncut_mm, true},
        Limit{"coverage", base.has_coverage, now.has_coverage, base.coverage, now.coverage, false,
              percent_text},
        // A share and an area cannot be compared: one is taken away and the other set.
        Limit{"the unreachable share", base.has_unreachable && base.unreachable_is_share,
              now.has_unreachable && now.unreachable_is_share, base.unreachable, now.unreachable,
              true, percent_text},
        Limit{"the unreachable area", base.has_unreachable && !base.unreachable_is_share,
              now.has_unreachable && !now.unreachable_is_share, base.unreachable, now.unreachable,
              true, stated_area},
        Limit{"unavoidable uncut", base.has_unavoidable, now.has_unavoidable, base.unavoidable_mm,
              now.unavoidable_mm, true}})
    compare_limit(limit, options, out);
  return out;
}

namespace {

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// A range has a limit at each end, none where that is infinite.
void compare_range(const std::string& what, const Range& base, const Range& now,
                   std::string (*text)(double), const Options& options, std::vector<Remark>& out) {
  const auto end = [&](const char* side, double was, double is, bool is_high) {
    const std::string named = what + side;
    compare_limit({named.c_str(), std::isfinite(was), std::isfinite(is), was, is, is_high, text},
                  options, out);
  };
  end(" downwards", base.low, now.low, false);
  end(" upwards", base.high, now.high, true);
}

void compare_travel(const std::optional<model::Box3>& base, const std::optional<model::Box3>& now,
                    const Options& options, std::vector<Remark>& out) {
  constexpr const char* kAxes[] = {"X", "Y", "Z"};
  const auto text = [](double mm) { return model::shortest(mm) + " mm"; };
  for (int axis = 0; axis < 3; ++axis) {
    const auto range = [axis](const std::optional<model::Box3>& travel) {
      return travel ? Range{travel->low[axis], travel->high[axis]} : Range{};
    };
    compare_range(std::string("travel along ") + kAxes[axis], range(base), range(now), text,
                  options, out);
  }
}

std::string place_text(const record::CheckedFixture& f) {
  const auto& at = f.translate_mm;
  return "at " + model::shortest(at.x) + ", " + model::shortest(at.y) + ", " +
         model::shortest(at.z) + " mm" + (f.setup ? " in setup " + *f.setup : "") +
         (f.axis ? " with axis " + *f.axis : "");
}

template <class All, class Same>
auto find_in(const std::optional<All>& all, const Same& same) {
  const auto at = std::find_if(all->begin(), all->end(), same);
  return at == all->end() ? nullptr : &*at;
}

/// What the base says and the other result does not: it may hold no more.
void lost(const std::string& what, const Options& options, std::vector<Remark>& out) {
  out.push_back({"gate", if_judged(options, "gate", Judgement::worse),
                 what + " that the process is checked against are said no more"});
}

/// One less to run into is a limit taken away; another place or mesh is named.
void compare_fixtures(const record::ProcessLimits& base, const record::ProcessLimits& now,
                      const Options& options, std::vector<Remark>& out) {
  if (base.fixtures && !now.fixtures) return lost("fixtures", options, out);
  if (!base.fixtures || !now.fixtures) return;
  const auto named = [](const std::string& name) {
    return [&name](const record::CheckedFixture& f) { return f.name == name; };
  };
  const auto remark = [&](const std::string& fixture, Judgement judgement, const char* text) {
    out.push_back({"gate", if_judged(options, "gate", judgement), "fixture " + fixture + text});
  };
  for (const record::CheckedFixture& fixture : *now.fixtures) {
    const auto* was = find_in(base.fixtures, named(fixture.name));
    if (!was) {
      remark(fixture.name, Judgement::better, " is new");
      continue;
    }
    const std::string what = "fixture " + fixture.name;
    name_change(out, "fixtures", what, was->file, fixture.file);
    name_change(out, "fixtures", what, place_text(*was), place_text(fixture));
  }
  for (const record::CheckedFixture& fixture : *base.fixtures)
    if (!find_in(now.fixtures, named(fixture.name)))
      remark(fixture.name, Judgement::worse, " is looked at no more");
}

/// An axis's range is a limit at each end; how it lies is named.
void compare_rotary_axes(const record::ProcessLimits& base, const record::ProcessLimits& now,
                         const Options& options, std::vector<Remark>& out) {
  if (base.rotary_axes && !now.rotary_axes) return lost("rotary axes", options, out);
  if (!base.rotary_axes || !now.rotary_axes) return;
  const auto text = [](double deg) { return model::shortest(deg) + "°"; };
  bool is_other = base.rotary_axes->size() != now.rotary_axes->size();
  for (const record::RotaryAxis& axis : *now.rotary_axes) {
    const auto* was =
        find_in(base.rotary_axes, [&](const record::RotaryAxis& a) { return a.word == axis.word; });
    is_other = is_other || !was || !was->lies_as(axis);
    if (!was) continue;
    compare_range("axis " + axis.word, {was->low_deg, was->high_deg}, {axis.low_deg, axis.high_deg},
                  text, options, out);
  }
  if (is_other)
    out.push_back(
        {"machine", Judgement::not_judged, "how the machine's rotary axes lie has changed"});
}

}  // namespace

std::vector<Remark> compare_process_limits(const std::optional<record::ProcessLimits>& base,
                                           const std::optional<record::ProcessLimits>& now,
                                           const Options& options) {
  std::vector<Remark> out;
  if (base && !now) lost("limits", options, out);
  // A result of an earlier version does not say them.
  if (!base || !now) return out;
  compare_limit(
      {"contacts", true, true, base->contact_tolerance_mm, now->contact_tolerance_mm, true},
      options, out);
  name_change(out, "near_miss", "distance of a near miss", stated_length(base->near_miss_mm),
              stated_length(now->near_miss_mm));
  compare_travel(base->travel_mm, now->travel_mm, options, out);
  compare_fixtures(*base, *now, options, out);
  compare_rotary_axes(*base, *now, options, out);
  return out;
}

namespace {

/// How steeply a cutter may go down, in degrees; none where nothing limits it, or the text is
/// another version's.
std::optional<double> steepest_descent_of(const std::string& cutter) {
  try {
    const double deg = model::parse_cutter(cutter).steepest_descent_deg;
    return deg < 90 ? std::optional(deg) : std::nullopt;
  } catch (const model::InputError&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<Remark> compare_descents(const std::string& base, const std::string& now,
                                     const Options& options) {
  const auto text = [](double deg) { return model::shortest(deg) + "°"; };
  std::vector<Remark> out;
  const std::optional<double> was = steepest_descent_of(base), is = steepest_descent_of(now);
  compare_limit({"the descent", was.has_value(), is.has_value(), was.value_or(90), is.value_or(90),
                 true, text},
                options, out);
  return out;
}

}  // namespace limitgauge::reports::compare
