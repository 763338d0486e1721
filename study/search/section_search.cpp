#include "study/search/section_search.h"

#include <algorithm>
#include <cmath>

#include "study/search/least_squares.h"
#include "study/tolerance.h"

namespace limitgauge::study {
namespace {

/// A row and where it lies: `cheapness` runs from 0 at the dear end of the axis to 1 at the cheap.
struct Place {
  double cheapness;
  std::size_t row;
};

/// 1 where the cost rises along the axis, -1 where it falls, 0 where the rows do not tell.
int direction_of_cost(const Trials& trials) {
  Pairs pairs;
  for (std::size_t i = 0; i < trials.rows().size(); ++i) {
    if (!trials.is_whole(i)) continue;
    pairs.x.push_back(*trials.axes()[0].coordinate_of(trials.rows()[i].asked.settings[0]));
    pairs.y.push_back(trials.cost(i));
  }
  const std::optional<double> rise = slope(pairs);
  return !rise || *rise == 0 ? 0 : *rise > 0 ? 1 : -1;
}

/// The way along the axis in its direction of falling cost.
class CostDescent {
 public:
  CostDescent(Trials& trials, int direction) : trials_(&trials), direction_(direction) {}

  /// All rows, the dearest setting first.
  std::vector<Place> places() const {
    std::vector<Place> all;
    for (std::size_t i = 0; i < trials_->rows().size(); ++i) {
      const double at = *trials_->axes()[0].coordinate_of(trials_->rows()[i].asked.settings[0]);
      all.push_back({direction_ > 0 ? 1 - at : at, i});
    }
    std::sort(all.begin(), all.end(),
              [](const Place& a, const Place& b) { return a.cheapness < b.cheapness; });
    return all;
  }

  /// Runs `parts` - 1 settings between two; false where none of them is new.
  bool cut(double from, double to, std::size_t parts) {
    std::vector<Spot> spots;
    for (std::size_t i = 1; i < parts; ++i) {
      const double t = from + (to - from) * static_cast<double>(i) / static_cast<double>(parts);
      spots.push_back({direction_ > 0 ? 1 - t : t});
    }
    const std::size_t before = trials_->rows().size();
    trials_->run(spots);
    return trials_->rows().size() > before;
  }

 private:
  Trials* trials_;
  int direction_;
};

std::string named(const Trials& trials, std::size_t row) {
  const Case& asked = trials.rows()[row].asked;
  return "case " + std::to_string(asked.index) + " (" + asked.settings[0].toml + ")";
}

void run_ends(Trials& trials, std::size_t batch) {
  std::size_t count = std::max<std::size_t>(batch, 2);
  if (trials.axes()[0].count() > 0) count = std::min(count, trials.axes()[0].count());
  std::vector<Spot> spots;
  for (std::size_t i = 0; i < count; ++i)
    spots.push_back({count < 2 ? 0 : static_cast<double>(i) / static_cast<double>(count - 1)});
  trials.run(spots);
}

/// Looks closer around the setting that comes nearest to passing.
void look_for_a_pass(Trials& trials, CostDescent& descent, std::size_t batch) {
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds && !trials.passes(*trials.best()); ++round) {
    const std::vector<Place> places = descent.places();
    const auto nearest = std::find_if(places.begin(), places.end(), [&](const Place& place) {
      return place.row == *trials.best();
    });
    const double from = nearest == places.begin() ? nearest->cheapness : (nearest - 1)->cheapness;
    const double to = nearest + 1 == places.end() ? nearest->cheapness : (nearest + 1)->cheapness;
    if (!descent.cut(from, to, batch + 2)) return;
  }
}

/// The last setting of which something holds, and the one after it.
struct Bracket {
  Place last;
  std::optional<Place> beyond;  ///< empty where it holds of the cheap end
};

template <class Holds>
Bracket bracket_of(const std::vector<Place>& places, const Holds& holds) {
  Bracket bracket{places.front(), std::nullopt};
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!holds(places[i].row)) continue;
    bracket.last = places[i];
    bracket.beyond = i + 1 < places.size() ? std::optional(places[i + 1]) : std::nullopt;
  }
  return bracket;
}

/// Until nothing is left to be learnt between the two.
template <class Holds>
Bracket narrowed(Trials& trials, CostDescent& descent, std::size_t batch, const Holds& holds) {
  for (;;) {
    const Bracket bracket = bracket_of(descent.places(), holds);
    if (!bracket.beyond) return bracket;
    const double from = bracket.last.cheapness, to = bracket.beyond->cheapness;
    const bool narrow_enough = to - from <= trials.axes()[0].finest() + kAlike;
    if (narrow_enough || !descent.cut(from, to, batch + 1)) return bracket;
  }
}

SearchEnd narrow(Trials& trials, CostDescent& descent, std::size_t batch) {
  const Bracket bracket =
      narrowed(trials, descent, batch, [&](std::size_t row) { return trials.passes(row); });
  if (!bracket.beyond)
    return {{},
            std::string("the ") + (trials.seeks_largest() ? "large" : "cheap") +
                " end of the range passes."};
  // Beyond what passes may lie what cannot be decided, and only then what is proven to fail.
  if (trials.seeks_largest() && trials.rows()[bracket.beyond->row].status != Status::fail)
    narrowed(trials, descent, batch,
             [&](std::size_t row) { return trials.rows()[row].status != Status::fail; });
  return {{},
          named(trials, bracket.last.row) + " passes, " + named(trials, bracket.beyond->row) +
              " does not, and nothing is left to tell apart between them."};
}

/// The first row that does not pass though a cheaper setting does.
std::string gap_in_passes(const Trials& trials, const std::vector<Place>& places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (trials.passes(places[i].row)) continue;
    for (std::size_t j = i + 1; j < places.size(); ++j)
      if (trials.passes(places[j].row))
        return named(trials, places[i].row) + " does not pass, but " +
               named(trials, places[j].row) + " beyond it does";
  }
  return {};
}

/// The greatest cost that may be this one but for rounding.
double dearest_alike(double cost) {
  return cost + kAlike * std::abs(cost);
}

std::string rise_in_cost(const Trials& trials, const std::vector<Place>& places) {
  const Place* last = nullptr;
  for (const Place& place : places) {
    if (!trials.is_whole(place.row)) continue;
    if (last != nullptr && trials.cost(place.row) > dearest_alike(trials.cost(last->row)))
      return named(trials, place.row) + " costs more than " + named(trials, last->row) +
             ", against the trend";
    last = &place;
  }
  return {};
}

}  // namespace

std::optional<SearchEnd> section_search(Trials& trials, std::size_t batch) {
  run_ends(trials, batch);
  const int direction = direction_of_cost(trials);
  if (direction == 0) return std::nullopt;
  CostDescent descent(trials, direction);
  look_for_a_pass(trials, descent, batch);
  if (!trials.passes(*trials.best()))
    return SearchEnd{SearchEnding::nothing_passes,
                     "nothing that was run passes, nor does it get near enough to look closer."};
  return narrow(trials, descent, batch);
}

std::string contradiction(const Trials& trials) {
  if (trials.axes().size() != 1 || !trials.axes()[0].ordered()) return {};
  const int direction = direction_of_cost(trials);
  if (direction == 0) return {};
  Trials copy = trials;
  const std::vector<Place> places = CostDescent(copy, direction).places();
  std::string found = gap_in_passes(trials, places);
  if (found.empty()) found = rise_in_cost(trials, places);
  if (found.empty()) return found;
  if (trials.seeks_largest())
    return "That every setting up to some value passes, and none beyond it, does not hold: " +
           found +
           ". The answer is the largest that was run and passes; there may be a larger one.";
  return "That settings get cheaper in one direction, and fail from some setting on, does not "
         "hold: " +
         found + ". The answer is the cheapest of what was run; there may be a cheaper one.";
}

std::string proven_bounds(const Trials& trials) {
  std::optional<std::size_t> pass, fail;
  const auto number = [&](std::size_t row) { return *trials.rows()[row].asked.settings[0].number; };
  for (std::size_t i = 0; i < trials.rows().size(); ++i) {
    if (trials.passes(i) && (!pass || number(i) > number(*pass))) pass = i;
    if (trials.rows()[i].status == Status::fail && (!fail || number(i) < number(*fail))) fail = i;
  }
  const auto told = [&](const std::optional<std::size_t>& row) {
    return row ? named(trials, *row) : std::string("none");
  };
  return "Largest that is proven to pass: " + told(pass) +
         "; smallest that is proven to fail: " + told(fail) + ".";
}

}  // namespace limitgauge::study
