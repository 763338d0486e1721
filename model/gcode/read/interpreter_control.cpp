// The interpreter's part for what controls read otherwise than LinuxCNC.
#include <cmath>

#include "model/base/tolerance.h"
#include "model/gcode/read/auxiliaries.h"
#include "model/gcode/read/interpreter.h"
#include "model/gcode/text/word_use.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {

/// What the reader has taken for granted in the block, and lines that are for the control itself.
/// False where that is all.
bool Interpreter::listen(const Statement& statement) {
  const Block& block = statement.block();
  for (const std::string& note : block.notes) assumed_.add(statement.line(), note);
  if (doubts_lengths_) note_doubtful_lengths(statement);
  if (block.dollar.empty()) return true;
  list_dollar(statement, program_, motions_so_far() > 0, assumed_);
  return false;
}

/// Fanuc's parameter 3401#0 (DPI) and Haas's setting 162 say what X10 is.
void Interpreter::note_doubtful_lengths(const Statement& statement) {
  for (const Word& word : statement.block().words) {
    const bool is_length = (letter_bit(word.letter) & letter_bits("XYZIJKRQ")) != 0;
    if (!is_length || !word.lacks_point() || statement.is_set_aside(word)) continue;
    doubts_lengths_ = false;
    assumed_.add(
        statement.line(),
        in_quotes(word.text) +
            " and other lengths without a decimal point are taken to be "
            "millimetres or inches; a control that is set otherwise counts its increments, "
            "thousandths or less");
    return;
  }
}

/// After `statement`, before which the tool stood at `from_mm`. A motion that leads nowhere counts
/// as more blocks than are read over (B-63664EN, "Tool movement in the offset mode"), and so does a
/// stop, behind which nothing is read ahead.
void Interpreter::watch_still_blocks(const Statement& statement, const Vec3& from_mm) {
  if (!compensation_.shifts()) return still_blocks_.reset();
  const auto [first, second, along] = axes_of(state_.modal.plane);
  const bool moves = state_.position_mm[first] != from_mm[first] ||
                     state_.position_mm[second] != from_mm[second] ||
                     statement.first_of({'I', 'J', 'K'}) != nullptr;
  const int most = *statement.rules().most_still_blocks;
  const bool ends_it = names_place(statement, state_.modal.plane) || statement.m(MGroup::stopping);
  if (!moves && still_blocks_) *still_blocks_ += ends_it ? most + 1 : 1;
  if (!moves) return;
  if (still_blocks_.value_or(0) > most)
    statement.fail(statement.blamed(),
                   "a motion under G41 or G42 behind more blocks without one in its plane than the "
                   "control surely reads over (its parameter 19625), or behind a stop or a motion "
                   "of no length: it leaves the contour's corner before them as it is",
                   "one such block at most between two motions beside a contour");
  still_blocks_ = 0;
}

namespace {

/// Of the block that a word stands in: G20 and G21 in it count.
double unit_in(const Block& block, double modal_unit_mm) {
  const auto stated = inches_stated(block);
  return !stated ? modal_unit_mm : *stated ? kInchMm : 1;
}

}  // namespace

/// A number that is written out stays as it is, and is told of. What is whole steps but for the
/// last bits of a sum is not listed.
void Interpreter::round_calculated(Block& block) {
  for (Word& word : block.words) {
    const bool calculated = word.is_calculated();
    if (!calculated && !doubts_decimals_) continue;
    const double steps = steps_in_unit(word.letter, unit_in(block, state_.modal.unit_mm) != 1);
    if (steps == 0) continue;
    const double rounded = std::round(word.value * steps) / steps;
    constexpr double kSumOfSteps = 1e-9;
    const bool tells = std::abs(rounded - word.value) > kSumOfSteps;
    if (calculated) word.value = rounded;
    if (tells) note_least_increments(block.main_line, calculated);
  }
}

void Interpreter::note_least_increments(std::uint32_t line, bool calculated) {
  doubts_decimals_ = doubts_decimals_ && calculated;
  assumed_.add(line, calculated
                         ? "lengths and angles from variables and expressions are rounded to 0.001 "
                           "mm, 0.0001 inch and 0.001 degrees, the control's least increments"
                         : "lengths and angles with more decimals than 0.001 mm, 0.0001 inch and "
                           "0.001 degrees, a control's usual least increments, are taken as they "
                           "are written");
}

/// G80, and on controls that let G0 and G1 stand beside codes that take the axis words, these.
void Interpreter::cancel_cycle(const Statement& statement) {
  const int code = *statement.g(GGroup::motion);
  const bool separate = statement.rules().separate_cycle_group;
  if (code == 800) {
    state_.modal.motion = separate ? state_.modal.beside_cycles : std::nullopt;
    cycles_.forget();
  } else if (axes_are_taken(statement) && statement.rules().motion_beside_reference) {
    state_.modal.motion = code;
    cycles_.forget();
  }
  if (separate && code <= 30) state_.modal.beside_cycles = code;
}

/// A cycle; a tap turns the spindle by itself where the control is Fanuc's or like it.
void Interpreter::tap(const Statement& statement, int code) {
  note_return_level(statement);
  note_hole_axis(statement);
  note_pecks(statement, code);
  if (!statement.rules().tap_turns_spindle || (code != 740 && code != 840))
    return cycle(statement, code);
  const Spindle before = state_.spindle;
  if (before.on) state_.spindle.on = true, state_.spindle.clockwise = code == 840;
  cycle(statement, code);
  state_.spindle = before;
}

/// How far a cycle withdraws between pecks is a parameter's to say too; Q0 leaves them out.
void Interpreter::note_pecks(const Statement& statement, int code) {
  if (statement.rules().control == Control::linuxcnc || (code != 730 && code != 830)) return;
  const Word* const q = statement.word('Q');
  if (q && q->value == 0) {
    assumed_.add(statement.line(), "Q0 of a pecking cycle is taken to mean one peck to the bottom");
  } else {
    assumed_.add(statement.line(),
                 "G73 and G83 are taken to withdraw by LinuxCNC's 0.254 mm "
                 "between pecks, which a parameter of the control says");
  }
}

void Interpreter::note_hole_axis(const Statement& statement) {
  if (statement.rules().control != Control::fanuc || state_.modal.plane == ArcPlane::xy) return;
  assumed_.add(
      statement.line(),
      "canned cycles are taken to drill across the plane of G18 and G19 (parameter 5101#0)");
}

/// Where the tool goes between holes is a parameter's to say until G98 or G99 does.
void Interpreter::note_return_level(const Statement& statement) {
  if (statement.rules().control == Control::linuxcnc || state_.modal.return_is_stated) return;
  state_.modal.return_is_stated = true;
  assumed_.add(statement.line(), std::string("the control is taken to have begun in ") +
                                     (state_.modal.return_to_r ? "G99" : "G98") +
                                     ": nothing before this canned cycle says which");
}

}  // namespace limitgauge::model::gcode
