#include "engine/model/gcode/canned_cycle.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "engine/model/words.h"

namespace limitgauge::model::gcode {
namespace {

/// A thousand kilometres: beyond any machine.
constexpr double kLargestCoordinateMm = 1e9;
/// LinuxCNC takes a count for whole within this.
constexpr double kWhole = 1e-4;
constexpr std::array<char, 3> kAxes = {'X', 'Y', 'Z'};

struct Takes {
  Cycle cycle;
  std::string_view letters;  ///< beside R, L and the axes
  std::string_view needs;    ///< in the first block of a run
};
constexpr std::array kCycles = {
    Takes{Cycle::chip_breaking, "Q", "Q"},
    Takes{Cycle::left_tapping, "P", ""},
    Takes{Cycle::drilling, "", ""},
    Takes{Cycle::drilling_dwell, "P", "P"},
    Takes{Cycle::pecking, "Q", "Q"},
    Takes{Cycle::tapping, "P", ""},
    Takes{Cycle::boring, "", ""},
    Takes{Cycle::boring_stop, "P", "P"},
    Takes{Cycle::back_boring, "IJK", "IJK"},
    Takes{Cycle::boring_by_hand, "P", "P"},
    Takes{Cycle::boring_dwell, "P", "P"},
};

const Takes* find(int code) {
  const auto found = std::find_if(kCycles.begin(), kCycles.end(), [code](const Takes& entry) {
    return static_cast<int>(entry.cycle) == code;
  });
  return found == kCycles.end() ? nullptr : &*found;
}

std::string name_of(int code) {
  return "G" + std::to_string(code / 10);
}

/// The word to show where one is missing.
const Word& blamed(const Statement& statement) {
  const Word* const code = statement.g_word(GGroup::motion);
  return code ? *code : *statement.first_of({'X', 'Y', 'Z'});
}

const Word& word_or_blamed(const Statement& statement, char letter) {
  const Word* const word = statement.word(letter);
  return word ? *word : blamed(statement);
}

bool is_in_range(double value_mm) {
  return std::abs(value_mm) <= kLargestCoordinateMm;
}

void check_level(const Statement& statement, char letter, double level_mm) {
  if (!is_in_range(level_mm))
    statement.fail(word_or_blamed(statement, letter), "a level beyond any machine",
                   "at most 1e9 mm");
}

std::string meaning_of(char letter) {
  if (letter == 'P') return "P, the dwell in seconds";
  if (letter == 'Q') return "Q, the depth of a peck";
  return "I, J and K";
}

int holes_of(const Statement& statement) {
  const Word* const l = statement.word('L');
  if (!l) return 1;
  const double count = std::round(l->value);
  if (!(std::abs(l->value - count) <= kWhole) || count < 1)
    statement.fail(*l, in_quotes(l->text) + " repeats of a canned cycle", "an integer from 1");
  if (count > static_cast<double>(CannedCycles::kMostMoves))
    statement.fail(*l, "a canned cycle of more than 100000 moves", "a smaller L");
  return static_cast<int>(count);
}

void check_moves(const Statement& statement, const std::vector<CycleMove>& moves) {
  for (const CycleMove& move : moves) {
    if (is_in_range(move.to_mm.x) && is_in_range(move.to_mm.y) && is_in_range(move.to_mm.z))
      continue;
    statement.fail(blamed(statement), "a canned cycle that goes beyond any machine",
                   "at most 1e9 mm");
  }
}

void check_tapping(const Statement& statement, const CycleContext& context) {
  const auto cycle = static_cast<Cycle>(context.code);
  if (cycle != Cycle::tapping && cycle != Cycle::left_tapping) return;
  if (context.plane != ArcPlane::xy)
    statement.fail(blamed(statement),
                   name_of(context.code) +
                       " outside G17 is not carried out: LinuxCNC exchanges the axes of its feed "
                       "there, against its own documentation",
                   "G17, or feed moves");
  if (cycle == Cycle::tapping && context.spindle == SpindleState::counter_clockwise)
    statement.fail(blamed(statement), "G84 while the spindle turns counter-clockwise",
                   "M3 before it, or G74");
  if (cycle == Cycle::left_tapping && context.spindle == SpindleState::clockwise)
    statement.fail(blamed(statement), "G74 while the spindle turns clockwise",
                   "M4 before it, or G84");
}

bool needs_spindle(Cycle cycle) {
  return cycle == Cycle::left_tapping || cycle == Cycle::tapping || cycle == Cycle::boring_stop ||
         cycle == Cycle::back_boring || cycle == Cycle::boring_by_hand;
}

}  // namespace

bool is_canned_cycle(int code) {
  return find(code) != nullptr;
}

bool cycle_takes(int code, char letter) {
  const Takes* const entry = find(code);
  if (!entry) return false;
  return letter == 'R' || letter == 'L' || entry->letters.find(letter) != std::string_view::npos;
}

void CannedCycles::forget() {
  *this = {};
}

CycleMotions CannedCycles::moves(const Statement& statement, const CycleContext& context) {
  check_state(statement, context);
  if (code_ != context.code) sticky_ = {};
  code_ = context.code;
  unit_mm_ = context.unit_mm;
  take_words(statement, context);
  require_words(statement, context);
  const int along = axes_of(context.plane)[2];
  if (!initial_level_mm_) initial_level_mm_ = context.position_mm[along];

  const CycleGeometry cycle = geometry(statement, context);
  CycleMotions motions;
  motions.moves = cycle_moves(cycle);
  check_moves(statement, motions.moves);
  motions.end_mm = motions.moves.back().to_mm;
  motions.end_mm[along] = cycle.return_mm;
  return motions;
}

void CannedCycles::check_state(const Statement& statement, const CycleContext& context) const {
  if (!statement.first_of({'X', 'Y', 'Z'}))
    statement.fail(blamed(statement), name_of(context.code) + " without an axis word", "X, Y or Z");
  if (context.inverse_time)
    statement.fail(blamed(statement), "a canned cycle in inverse time feed", "G94 before it");
  if (context.compensated)
    statement.fail(blamed(statement), "a canned cycle with cutter radius compensation on",
                   "G40 before it");
  // LinuxCNC would read levels of the old unit as numbers of the new one.
  if (initial_level_mm_ && unit_mm_ != context.unit_mm) {
    const Word* const unit = statement.g_word(GGroup::units);
    statement.fail(unit ? *unit : blamed(statement), "a change of units in a run of canned cycles",
                   "G80 before it");
  }
  if (needs_spindle(static_cast<Cycle>(context.code)) && context.spindle == SpindleState::stopped)
    statement.fail(blamed(statement), name_of(context.code) + " while the spindle stands still",
                   "M3 or M4 before it");
  check_tapping(statement, context);
}

void CannedCycles::take_words(const Statement& statement, const CycleContext& context) {
  const auto take = [&](std::optional<double>& slot, char letter) {
    if (const Word* word = statement.word(letter)) slot = word->value;
  };
  take(sticky_.r, 'R');
  take(sticky_.bottom, kAxes[axes_of(context.plane)[2]]);
  if (cycle_takes(context.code, 'P')) take(sticky_.p, 'P');
  if (cycle_takes(context.code, 'Q')) take(sticky_.q, 'Q');
  if (!cycle_takes(context.code, 'I')) return;
  take(sticky_.i, 'I');
  take(sticky_.j, 'J');
  take(sticky_.k, 'K');
}

void CannedCycles::require_words(const Statement& statement, const CycleContext& context) const {
  const auto need = [&](const std::optional<double>& slot, char letter, const std::string& what) {
    if (!slot)
      statement.fail(blamed(statement),
                     "the first " + name_of(context.code) + " of a run has no " + letter, what);
  };
  need(sticky_.r, 'R', "R, the level where the rapid ends");
  need(sticky_.bottom, kAxes[axes_of(context.plane)[2]], "the depth");
  for (const char letter : find(context.code)->needs) {
    const std::optional<double>& slot = letter == 'P'   ? sticky_.p
                                        : letter == 'Q' ? sticky_.q
                                        : letter == 'I' ? sticky_.i
                                        : letter == 'J' ? sticky_.j
                                                        : sticky_.k;
    need(slot, letter, meaning_of(letter));
  }
  if (sticky_.p && *sticky_.p < 0)
    statement.fail(word_or_blamed(statement, 'P'), "a negative dwell", "0 or more seconds");
  if (sticky_.q && !(*sticky_.q > 0))
    statement.fail(word_or_blamed(statement, 'Q'), "a peck that is not above 0",
                   "Q above 0, whichever way the tool goes");
}

CycleGeometry CannedCycles::geometry(const Statement& statement,
                                     const CycleContext& context) const {
  const auto axes = axes_of(context.plane);
  const double unit_mm = context.unit_mm;
  CycleGeometry cycle;
  cycle.cycle = static_cast<Cycle>(context.code);
  cycle.plane = context.plane;
  cycle.start_mm = context.position_mm;
  cycle.stated[axes[2]] = !context.incremental;
  for (int i = 0; i < 2; ++i) {
    cycle.hole_mm[i] = context.position_mm[axes[i]];
    const Word* const word = statement.word(kAxes[axes[i]]);
    if (!word) continue;
    (context.incremental ? cycle.step_mm : cycle.hole_mm)[i] = word->value * unit_mm;
    cycle.stated[axes[i]] = !context.incremental;
  }
  // LinuxCNC counts R from the initial level, even where the tool stands elsewhere by now.
  cycle.r_mm = *sticky_.r * unit_mm + (context.incremental ? *initial_level_mm_ : 0);
  cycle.bottom_mm = *sticky_.bottom * unit_mm + (context.incremental ? cycle.r_mm : 0);
  const char depth = kAxes[axes[2]];
  check_level(statement, 'R', cycle.r_mm);
  check_level(statement, depth, cycle.bottom_mm);
  if (cycle.r_mm < cycle.bottom_mm)
    statement.fail(word_or_blamed(statement, statement.word('R') ? 'R' : depth),
                   std::string("R lies below the bottom of the hole, ") + depth,
                   "R at or above it");
  cycle.lifts_first = *initial_level_mm_ < cycle.r_mm;
  cycle.return_mm = context.return_to_r || cycle.lifts_first ? cycle.r_mm : *initial_level_mm_;
  add_back_bore(cycle, context);
  add_pecks(statement, context, cycle);
  cycle.holes = holes_of(statement);
  if (static_cast<double>(cycle.holes) * static_cast<double>(most_moves_per_hole(cycle)) >
      static_cast<double>(kMostMoves))
    statement.fail(word_or_blamed(statement, statement.word('L') ? 'L' : 'Q'),
                   "a canned cycle of more than 100000 moves", "a smaller L or a larger Q");
  return cycle;
}

/// I, J and K are offsets from the hole, but the one along the tool is a level.
void CannedCycles::add_back_bore(CycleGeometry& cycle, const CycleContext& context) const {
  if (cycle.cycle != Cycle::back_boring) return;
  const std::array<double, 3> words = {*sticky_.i, *sticky_.j, *sticky_.k};
  const auto [first, second, along] = axes_of(context.plane);
  cycle.aside_mm = {words[first] * context.unit_mm, words[second] * context.unit_mm};
  cycle.middle_mm = words[along] * context.unit_mm + (context.incremental ? cycle.bottom_mm : 0);
}

/// Subtracts peck by peck in the program's units, so that what rounding makes of the last peck is
/// what LinuxCNC makes of it.
void CannedCycles::add_pecks(const Statement& statement, const CycleContext& context,
                             CycleGeometry& cycle) const {
  if (cycle.cycle != Cycle::chip_breaking && cycle.cycle != Cycle::pecking) return;
  const double unit_mm = context.unit_mm, q = *sticky_.q;
  const double r = *sticky_.r + (context.incremental ? *initial_level_mm_ / unit_mm : 0);
  const double bottom = *sticky_.bottom + (context.incremental ? r : 0);
  for (double level = r - q; level > bottom; level -= q) {
    if (cycle.pecks_mm.size() >= kMostMoves)
      statement.fail(word_or_blamed(statement, 'Q'), "a canned cycle of more than 100000 moves",
                     "a larger Q");
    cycle.pecks_mm.push_back(level * unit_mm);
  }
}

}  // namespace limitgauge::model::gcode
