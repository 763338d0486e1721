#include "model/gcode/text/word_use.h"

#include <array>
#include <limits>
#include <string>

#include "model/gcode/cycles/canned_cycle.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

constexpr std::uint32_t kFreeLetters = letter_bits("ABCFGMSTXYZ@^");
constexpr std::uint32_t kCentreLetters = letter_bits("IJK");
constexpr int kCancelCycle = 800;  // G80, in tenths

bool is_straight(int motion) {
  return motion == 0 || motion == 10;
}

/// Codes of group 0 that take the axis words for themselves.
bool takes_axes(int non_modal) {
  return non_modal == 100 || non_modal == 280 || non_modal == 300 || non_modal == 520 ||
         non_modal == 920;
}

const Word& axis_of(const Statement& statement) {
  return *statement.first_of({'X', 'Y', 'Z', '@', '^', 'A', 'B', 'C'});
}

bool states_plane(const Statement& statement) {
  return statement.g(GGroup::working_plane) == 682;
}

/// The code that takes the axis words for itself, where axes_are_taken().
const Word& taker_of(const Statement& statement) {
  return *statement.g_word(states_plane(statement) ? GGroup::working_plane : GGroup::non_modal);
}

/// One sort of code that may use a letter.
struct User {
  bool present = false;
  const char* name = nullptr;
};

/// Which codes of a block there are, as far as words beside them matter.
class Users {
 public:
  Users(const Statement& statement, std::optional<int> motion, bool by_vector)
      : statement_(statement), motion_(motion.value_or(-1)), by_vector_(by_vector) {}

  void check(const Word& word) const;

 private:
  bool g(GGroup group, int tenths) const { return statement_.g(group) == tenths; }
  bool m(MGroup group, int first, int last) const {
    const int code = statement_.m(group).value_or(-1);
    return code >= first && code <= last;
  }
  bool non_modal(int tenths) const { return g(GGroup::non_modal, tenths); }
  bool side() const { return statement_.g(GGroup::radius_offset).value_or(400) != 400; }
  bool arc() const { return is_arc(motion_); }
  bool turns() const { return arc() && statement_.rules().turns_by_p; }
  bool any_cycle() const { return is_canned_cycle(motion_); }
  bool dwells() const {
    return cycle('P') || (any_cycle() && statement_.rules().dwell_is_optional);
  }
  bool modal() const { return statement_.rules().modal_offset_words; }
  bool cycle(char letter) const { return cycle_takes(motion_, letter); }
  User arcs() const { return {arc(), "an arc"}; }
  User vector() const { return {by_vector_ && is_straight(motion_), "the tool's axis"}; }
  User plane() const { return {states_plane(statement_), "G68.2"}; }
  User setting() const { return {non_modal(100), "G10"}; }
  User blending() const { return {g(GGroup::path_control, 640), "G64"}; }
  User orienting() const { return {m(MGroup::spindle, 19, 19), "M19"}; }
  User input() const { return {m(MGroup::input_output, 66, 66), "M66"}; }

  std::array<User, 6> users_of(char letter) const;
  std::array<User, 6> users_of_p() const;
  std::array<User, 6> users_of_q() const;

  const Statement& statement_;
  int motion_;
  bool by_vector_;
};

std::array<User, 6> Users::users_of_p() const {
  return {
      User{non_modal(40), "G4"},
      setting(),
      blending(),
      User{turns() || dwells(), turns() ? "an arc" : "a canned cycle"},
      User{m(MGroup::overrides, 50, 53) || m(MGroup::input_output, 62, 66) ||
               g(GGroup::coordinate_system, 541) || (non_modal(300) && statement_.rules().macro_b),
           "an M code, G54.1 or G30"},
      orienting()};
}

std::array<User, 6> Users::users_of_q() const {
  return {User{cycle('Q'), "a canned cycle"},
          User{m(MGroup::input_output, 66, 68), "an M code"},
          User{m(MGroup::tool_change, 61, 61), "M61"},
          setting(),
          blending(),
          orienting()};
}

std::array<User, 6> Users::users_of(char letter) const {
  switch (letter) {
    case 'D':
      if (modal() || statement_.rules().length_by_d) return {User{true, "a tool offset"}};
      return {User{side(), "cutter compensation"}, User{g(GGroup::spindle_mode, 960), "G96"}};
    case 'E':
      return {User{m(MGroup::input_output, 66, 68), "M66 to M68"}};
    case 'H':
      if (modal()) return {User{true, "a tool offset"}};
      return {User{g(GGroup::length_offset, 430) || g(GGroup::length_offset, 432), "G43"}};
    case 'I':
    case 'J':
      return {arcs(), User{cycle(letter), "G87"}, setting(), plane(), vector()};
    case 'K':
      return {arcs(), User{cycle(letter), "G87"}, plane(),
              User{any_cycle() && statement_.rules().repeats_by_k, "a canned cycle"}, vector()};
    case 'L':
      return {User{cycle('L'), "a canned cycle"}, setting(), input()};
    case 'P':
      return users_of_p();
    case 'Q':
      return users_of_q();
    default:  // R
      return {arcs(), User{cycle(letter), "a canned cycle"}, setting(), orienting()};
  }
}

/// What to write in a message about a letter that nothing uses.
const char* all_users_of(char letter) {
  switch (letter) {
    case 'D':
      return "G41, G42 or G96";
    case 'E':
      return "M66, M67 or M68";
    case 'H':
      return "G43 or G43.2";
    case 'I':
    case 'J':
    case 'K':
      return "G2, G3 or G87";
    case 'L':
      return "G10, M66 or a canned cycle";
    case 'P':
      return "G2, G3, G4, G10, G64, a canned cycle that dwells, M19, M50 to M53 or M62 to M66";
    case 'Q':
      return "G64, G73, G83, M19, M61 or M66 to M68";
    default:
      return "G2, G3, G10, a canned cycle or M19";
  }
}

void Users::check(const Word& word) const {
  const char* first = nullptr;
  for (const User& user : users_of(word.letter)) {
    if (!user.present) continue;
    if (first)
      statement_.fail(word,
                      in_quotes(word.text) + " would be used by " + first + " and by " + user.name,
                      "one of them in a block of its own");
    first = user.name;
  }
  if (!first)
    statement_.fail(word, in_quotes(word.text) + " beside no code that uses it",
                    all_users_of(word.letter));
}

void check_dwell(const Statement& statement, std::optional<int> motion) {
  if (statement.g(GGroup::non_modal) != 40) return;
  const Word& code = *statement.g_word(GGroup::non_modal);
  if (motion && is_arc(*motion))
    statement.fail(code, "G4 beside an arc, which may use P too", "a block of its own");
  const Word* p = statement.word('P');
  for (const Word& word : statement.block().words) {
    if (statement.is_set_aside(word) && word.letter != 'G' && word.letter != 'M' &&
        statement.rules().dwell_letters.find(word.letter) != std::string_view::npos)
      p = &word;
  }
  if (!p || !(p->value >= 0))
    statement.fail(code, "a dwell without its time", "P with 0 or more seconds");
}

void require(const Statement& statement, const Word& code, bool there, const char* expected) {
  if (!there) statement.fail(code, in_quotes(code.text) + " lacks a word", expected);
}

void check_range(const Statement& statement, char letter, double least, double most) {
  const Word* const word = statement.word(letter);
  if (word && !(word->value >= least && word->value <= most))
    statement.fail(*word, in_quotes(word->text) + " beside M19 is out of range",
                   "R from 0 to 360 degrees, P 0, 1 or 2, Q above 0");
}

void check_auxiliaries(const Statement& statement) {
  if (const auto code = statement.m(MGroup::input_output)) {
    const Word& word = *statement.m_word(MGroup::input_output);
    const bool p = statement.word('P'), e = statement.word('E');
    if (*code <= 65) require(statement, word, p, "P with the output's number");
    if (*code == 66) require(statement, word, p != e, "P or E with the input's number");
    if (*code >= 67) require(statement, word, e, "E with the output's number");
  }
  if (statement.m(MGroup::spindle) == 19) {
    check_range(statement, 'R', 0, 360);
    check_range(statement, 'P', 0, 2);
    check_range(statement, 'Q', std::numeric_limits<double>::min(), 1e9);
  }
}

/// LinuxCNC, "Polar Coordinates".
void check_polar(const Statement& statement) {
  const Word& polar = *statement.first_of({'@', '^'});
  if (const Word* word = statement.first_of({'X', 'Y'}))
    statement.fail(*word, in_quotes(word->text) + " beside polar coordinates",
                   "@ and ^, or X and Y");
  if (axes_are_taken(statement) || statement.g(GGroup::non_modal) == 530 ||
      statement.g(GGroup::length_offset) == 431 || statement.g(GGroup::motion) == kCancelCycle)
    statement.fail(polar, "polar coordinates of a code that takes its axis words as they are",
                   "X and Y");
}

std::optional<int> stated_motion(const Statement& statement, int code,
                                 std::optional<int> beside_cycles) {
  const Word& word = *statement.g_word(GGroup::motion);
  const auto non_modal = statement.g(GGroup::non_modal);
  const bool taken = axes_are_taken(statement);
  if (code == kCancelCycle) {
    const bool turns = statement.has_rotary() && statement.first_of({'A', 'B', 'C'});
    if ((!statement.has_axes() && !(turns && beside_cycles)) || taken) return std::nullopt;
    if (beside_cycles) return beside_cycles;
    statement.fail(axis_of(statement), "an axis word beside G80", "G0, G1, G2 or G3");
  }
  const bool by_reference = non_modal == 280 || non_modal == 300;
  if (by_reference && code <= 10 && statement.rules().motion_beside_reference) return std::nullopt;
  if (taken)
    statement.fail(taker_of(statement),
                   in_quotes(taker_of(statement).text) + " and " + in_quotes(word.text) +
                       " would both use axis words",
                   "one of them in a block of its own");
  if (statement.g(GGroup::length_offset) == 431)
    statement.fail(*statement.g_word(GGroup::length_offset),
                   "G43.1 and " + in_quotes(word.text) + " would both use axis words",
                   "one of them in a block of its own");
  if (is_canned_cycle(code) && !statement.has_axes() && !statement.is_polar())
    statement.fail(word, std::string(word.text) + " without an axis word", "X, Y or Z");
  return code;
}

}  // namespace

bool is_rapid_in_machine_frame(const Statement& statement) {
  return statement.g(GGroup::non_modal) == 530 && statement.rules().rapid_in_machine_frame &&
         (statement.has_axes() || statement.has_rotary());
}

bool axes_are_taken(const Statement& statement) {
  const auto code = statement.g(GGroup::non_modal);
  return (code && takes_axes(*code)) || states_plane(statement);
}

std::optional<int> motion_of(const Statement& statement, std::optional<int> modal_motion,
                             std::optional<int> beside_cycles, bool by_vector) {
  if (statement.is_polar()) check_polar(statement);
  const auto stated = statement.g(GGroup::motion);
  const bool leaves_straight = !stated || is_straight(*stated) || *stated == kCancelCycle;
  if (leaves_straight && is_rapid_in_machine_frame(statement)) return 0;
  if (stated) return stated_motion(statement, *stated, beside_cycles);
  if (axes_are_taken(statement)) return std::nullopt;
  // As LinuxCNC, a rotary word that turns nothing is a motion of no length.
  const bool stays = statement.has_rotary() && (modal_motion == 0 || modal_motion == 10);
  const bool turns = (statement.letters() & kRotaryLetters) != 0;
  if (statement.has_axes() || statement.is_polar() || stays || turns) {
    if (statement.g(GGroup::length_offset) == 431) return std::nullopt;
    if (!modal_motion)
      statement.fail(axis_of(statement), "an axis word without a motion mode", "G0, G1, G2 or G3");
    return modal_motion;
  }
  const bool centres = (statement.letters() & kCentreLetters) != 0;
  const bool use_centres =
      modal_motion && (is_arc(*modal_motion) || (by_vector && is_straight(*modal_motion)));
  return centres && use_centres ? modal_motion : std::nullopt;
}

void check_word_use(const Statement& statement, std::optional<int> motion, bool by_vector) {
  check_dwell(statement, motion);
  if ((statement.letters() & letter_bit('M')) != 0) check_auxiliaries(statement);
  if ((statement.letters() & ~kFreeLetters) == 0) return;
  const Users users(statement, motion, by_vector);
  for (const Word& word : statement.block().words) {
    if ((letter_bit(word.letter) & kFreeLetters) == 0 && !statement.is_set_aside(word))
      users.check(word);
  }
}

}  // namespace limitgauge::model::gcode
