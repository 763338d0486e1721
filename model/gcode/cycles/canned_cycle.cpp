#include "model/gcode/cycles/canned_cycle.h"

#include <array>
#include <cmath>
#include <string>

#include "model/base/tolerance.h"
#include "model/gcode/cycles/polar_place.h"

namespace limitgauge::model::gcode {
namespace {

constexpr std::array<char, 3> kAxes = {'X', 'Y', 'Z'};

char axis_along_tool(ArcPlane plane) {
  return kAxes[axes_of(plane)[2]];
}

bool is_in_range(double value_mm) {
  return std::abs(value_mm) <= kLargestCoordinateMm;
}

void check_level(const Statement& statement, char letter, double level_mm) {
  if (!is_in_range(level_mm))
    statement.fail(word_or_blamed(statement, letter), "a level beyond any machine",
                   "at most 1e9 mm");
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
                   cycle_name(context.code) +
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

void check_spindle(const Statement& statement, const CycleContext& context) {
  const auto cycle = static_cast<Cycle>(context.code);
  const bool stops_it = cycle == Cycle::left_tapping || cycle == Cycle::tapping ||
                        cycle == Cycle::boring_stop || cycle == Cycle::back_boring ||
                        cycle == Cycle::boring_by_hand;
  if (stops_it && context.spindle == SpindleState::stopped)
    statement.fail(blamed(statement), cycle_name(context.code) + " while the spindle stands still",
                   "M3 or M4 before it");
}

/// The words that say where holes are.
struct PlaceWords {
  const Statement& statement;
  const CycleContext& context;
  std::array<int, 2> axes;
  std::optional<PolarPlace> polar;

  bool is_stated(int i) const {
    if (polar) return polar->is_stated();
    return statement.word(kAxes[axes[i]]) && !context.incremental;
  }
  /// The next hole, from the one before.
  Vec2 from(Vec2 at_mm) const {
    if (polar) return polar_end(statement, *polar, at_mm);
    for (int i = 0; i < 2; ++i)
      if (const Word* const word = statement.word(kAxes[axes[i]]))
        at_mm[i] = word->value * context.unit_mm + (context.incremental ? at_mm[i] : 0);
    return at_mm;
  }
};

void check_count(const Statement& statement, const CycleGeometry& cycle) {
  const double moves =
      static_cast<double>(cycle.holes_mm.size()) * static_cast<double>(most_moves_per_hole(cycle));
  if (moves > static_cast<double>(CannedCycles::kMostMoves))
    statement.fail(word_or_blamed(statement, statement.word('L') ? 'L' : 'Q'),
                   "a canned cycle of more than 100000 moves", "a smaller L or a larger Q");
}

}  // namespace

void CannedCycles::forget() {
  // Every block with a motion code comes here, and rarely is there anything.
  if (code_ != 0) *this = {};
}

CycleMotions CannedCycles::moves(const Statement& statement, const CycleContext& context) {
  check_state(statement, context);
  if (code_ != context.code && !statement.rules().fanuc_cycles) words_ = {};
  code_ = context.code;
  unit_mm_ = context.unit_mm;
  words_.take(statement, code_, axis_along_tool(context.plane), context.incremental);
  words_.check(statement, code_, axis_along_tool(context.plane));
  const int along = axes_of(context.plane)[2];
  if (!initial_level_mm_) initial_level_mm_ = context.position_mm[along];

  const CycleGeometry cycle = geometry(statement, context);
  CycleMotions motions;
  motions.end_mm = context.position_mm;
  if (cycle.holes_mm.empty()) return motions;  // Fanuc's K0 and Haas's L0 only store the words
  motions.moves = cycle_moves(cycle);
  check_moves(statement, motions.moves);
  motions.end_mm = motions.moves.back().to_mm;
  motions.end_mm[along] = cycle.return_mm;
  return motions;
}

void CannedCycles::check_state(const Statement& statement, const CycleContext& context) const {
  if (!statement.has_axes() && !statement.is_polar())
    statement.fail(blamed(statement), cycle_name(context.code) + " without an axis word",
                   "X, Y or Z");
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
  check_spindle(statement, context);
  check_tapping(statement, context);
}

CycleGeometry CannedCycles::geometry(const Statement& statement,
                                     const CycleContext& context) const {
  CycleGeometry cycle;
  cycle.cycle = static_cast<Cycle>(context.code);
  cycle.plane = context.plane;
  cycle.start_mm = context.position_mm;
  cycle.feeds_to_r = statement.rules().separate_cycle_group;
  cycle.goes_across_as_it_stands = statement.rules().fanuc_cycles;
  add_places(statement, context, cycle);
  add_levels(statement, context, cycle);
  add_back_bore(context, cycle);
  add_pecks(statement, context, cycle);
  check_count(statement, cycle);
  return cycle;
}

void CannedCycles::add_places(const Statement& statement, const CycleContext& context,
                              CycleGeometry& cycle) const {
  const auto [first, second, along] = axes_of(context.plane);
  PlaceWords words{statement, context, {first, second}, {}};
  if (statement.is_polar()) words.polar = polar_of(statement, context.unit_mm, context.incremental);
  Vec2 at_mm = {context.position_mm[first], context.position_mm[second]};
  for (int hole = holes_of(statement, static_cast<int>(kMostMoves)); hole > 0; --hole)
    cycle.holes_mm.push_back(at_mm = words.from(at_mm));
  cycle.stated[first] = words.is_stated(0), cycle.stated[second] = words.is_stated(1);
  cycle.stated[along] = !words_.r_is_step && !words_.bottom_is_step;
}

/// LinuxCNC counts R from the initial level, even where the tool stands elsewhere by now.
void CannedCycles::add_levels(const Statement& statement, const CycleContext& context,
                              CycleGeometry& cycle) const {
  const double unit_mm = context.unit_mm, initial_mm = *initial_level_mm_;
  cycle.r_mm = *words_.r * unit_mm + (words_.r_is_step ? initial_mm : 0);
  cycle.bottom_mm = *words_.bottom * unit_mm + (words_.bottom_is_step ? cycle.r_mm : 0);
  const char depth = axis_along_tool(context.plane);
  check_level(statement, 'R', cycle.r_mm);
  check_level(statement, depth, cycle.bottom_mm);
  if (cycle.r_mm < cycle.bottom_mm)
    statement.fail(word_or_blamed(statement, statement.word('R') ? 'R' : depth),
                   std::string("R lies below the bottom of the hole, ") + depth,
                   "R at or above it");
  cycle.lifts_first = initial_mm < cycle.r_mm && !cycle.goes_across_as_it_stands;
  cycle.return_mm = context.return_to_r || cycle.lifts_first ? cycle.r_mm : initial_mm;
}

/// I, J and K are offsets from the hole, but the one along the tool is a level.
void CannedCycles::add_back_bore(const CycleContext& context, CycleGeometry& cycle) const {
  if (cycle.cycle != Cycle::back_boring) return;
  const std::array<double, 3> words = {*words_.i, *words_.j, *words_.k};
  const auto [first, second, along] = axes_of(context.plane);
  cycle.aside_mm = {words[first] * context.unit_mm, words[second] * context.unit_mm};
  cycle.middle_mm = words[along] * context.unit_mm + (context.incremental ? cycle.bottom_mm : 0);
}

/// Subtracts peck by peck in the program's units, so that what rounding makes of the last peck is
/// what LinuxCNC makes of it.
void CannedCycles::add_pecks(const Statement& statement, const CycleContext& context,
                             CycleGeometry& cycle) const {
  if (cycle.cycle != Cycle::chip_breaking && cycle.cycle != Cycle::pecking) return;
  const double unit_mm = context.unit_mm, q = *words_.q;
  const double r = *words_.r + (words_.r_is_step ? *initial_level_mm_ / unit_mm : 0);
  const double bottom = *words_.bottom + (words_.bottom_is_step ? r : 0);
  if (q == 0) return;  // one peck
  for (double level = r - q; level > bottom; level -= q) {
    if (cycle.pecks_mm.size() >= kMostMoves)
      statement.fail(word_or_blamed(statement, 'Q'), "a canned cycle of more than 100000 moves",
                     "a larger Q");
    cycle.pecks_mm.push_back(level * unit_mm);
  }
}

}  // namespace limitgauge::model::gcode
