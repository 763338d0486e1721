#include "simulator/process/turning/trailing_contact.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace limitgauge::simulator {
namespace {

using model::Pass;
using model::Toolpath;

// At one time there is little to look through.
constexpr std::size_t kWitnessLooks = 10'000;

double farthest_from_tip_mm(const CutterProfile& flutes) {
  return std::hypot(flutes.length(), flutes.largest_radius());
}

class TrailingContact {
 public:
  TrailingContact(const TurnSearch& search, const TurningCut& cut, double tolerance_mm,
                  const model::RunControl& control)
      : search_(search),
        pass_(*cut.pass),
        line_(pass_.path->moves[cut.move]),
        motion_(move_from(*pass_.path, cut.move), line_.to, axis_from(*pass_.axes, cut.move),
                pass_.axes->to[cut.move], 0),
        speed_mm_(length(motion_.delta) +
                  motion_.turn_rad * farthest_from_tip_mm(CutterProfile(pass_.cutter))),
        tolerance_mm_(tolerance_mm),
        control_(control),
        looks_left_(search.most_looks) {}

  TurnAnswer during(double from, double to) {
    if (looks_left_ == 0) return {{}, 0, false};
    const TurnAnswer early = contact(from, to, from, looks_left_, tolerance_mm_);
    if (!early.place && early.proven) return early;
    // Where it would be deepest it mostly is in what stands just then.
    if (early.place) {
      const double t = early.place->t;
      const TurnAnswer then = contact(t, t, t, kWitnessLooks, tolerance_mm_);
      if (then.place) return then;
    }
    if ((to - from) * speed_mm_ <= tolerance_mm_ / 4) {
      // The flutes take off no more than that: 1.5 of these and it are 1.5 tolerances.
      return contact(from, to, to, looks_left_, 5 * tolerance_mm_ / 6);
    }
    const double half = (from + to) / 2;
    const TurnAnswer first = during(from, half);
    return first.place ? first : worse(first, during(half, to));
  }

 private:
  // Against what stands when the flutes have come to time `cut`.
  TurnAnswer contact(double from, double to, double cut, std::size_t most_looks,
                     double tolerance_mm) {
    TurnSearch stretch = search_;
    stretch.from = from, stretch.to = to, stretch.most_looks = std::min(most_looks, looks_left_);
    const auto flutes = cut > 0 ? std::make_shared<const SweepIndex>(until(cut)) : nullptr;
    const Material left = flutes ? search_.solid->after(flutes) : *search_.solid;
    stretch.solid = &left;
    const TurnAnswer answer = deepest_turn_contact(stretch, tolerance_mm, control_);
    looks_left_ -= std::min(looks_left_, answer.looks);
    return answer;
  }

  Pass until(double t) const {
    Toolpath path;
    path.start = motion_.start;
    path.moves = {line_};
    path.moves[0].to = motion_.tip(t);
    Pass pass{pass_.cutter, std::make_shared<const Toolpath>(std::move(path))};
    pass.axes = std::make_shared<const model::ToolAxes>(
        model::ToolAxes{motion_.axis, {t < 1 ? motion_.up(t) : motion_.axis_end}});
    return pass;
  }

  static TurnAnswer worse(const TurnAnswer& a, const TurnAnswer& b) {
    TurnAnswer answer = b.place && (!a.place || b.place->mm > a.place->mm) ? b : a;
    answer.proven = a.proven && b.proven;
    return answer;
  }

  TurnSearch search_;
  const Pass& pass_;
  model::Move line_;
  TurningMove motion_;
  double speed_mm_;  // no place of the flutes is faster, by t
  double tolerance_mm_;
  const model::RunControl& control_;
  std::size_t looks_left_;  // of all stretches
};

}  // namespace

TurnAnswer trailing_contact(const TurnSearch& search, const TurningCut& cut, double tolerance_mm,
                            const model::RunControl& control) {
  return TrailingContact(search, cut, tolerance_mm, control).during(search.from, search.to);
}

}  // namespace limitgauge::simulator
