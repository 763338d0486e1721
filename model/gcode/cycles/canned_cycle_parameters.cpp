#include "model/gcode/cycles/canned_cycle_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "model/base/tolerance.h"
#include "model/gcode/cycles/canned_cycle_path.h"
#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

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

std::string meaning_of(char letter) {
  if (letter == 'P') return "P, the dwell in seconds";
  if (letter == 'Q') return "Q, the depth of a peck";
  return "I, J and K";
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

const std::optional<double>& CycleParameters::of(char letter) const {
  if (letter == 'Q') return q;
  if (letter == 'P') return p;
  if (letter == 'I') return i;
  return letter == 'J' ? j : k;
}

void CycleParameters::take(const Statement& statement, int code, char along, bool incremental) {
  const bool rereads = !statement.rules().fanuc_cycles;
  if (rereads || statement.word('R')) r_is_step = incremental;
  if (rereads || statement.word(along)) bottom_is_step = incremental;
  const auto read = [&](std::optional<double>& slot, char letter) {
    if (const Word* word = statement.word(letter)) slot = word->value;
  };
  read(r, 'R');
  read(bottom, along);
  if (cycle_takes(code, 'P') || statement.rules().dwell_is_optional) read(p, 'P');
  if (cycle_takes(code, 'Q')) read(q, 'Q');
  if (!cycle_takes(code, 'I')) return;
  read(i, 'I');
  read(j, 'J');
  read(k, 'K');
}

void CycleParameters::check(const Statement& statement, int code, char along) const {
  const auto need = [&](const std::optional<double>& slot, char letter, const std::string& what) {
    if (!slot)
      statement.fail(blamed(statement),
                     "the first " + cycle_name(code) + " of a run has no " + letter, what);
  };
  need(r, 'R', "R, the level where the rapid ends");
  need(bottom, along, "the depth");
  const ControlRules& rules = statement.rules();
  for (const char letter : find(code)->needs) {
    if (letter == 'P' && rules.dwell_is_optional) continue;
    need(of(letter), letter, meaning_of(letter));
  }
  if (p && *p < 0)
    statement.fail(word_or_blamed(statement, 'P'), "a negative dwell", "0 or more seconds");
  if (q && !(*q > 0) && !(*q == 0 && rules.whole_peck))
    statement.fail(word_or_blamed(statement, 'Q'), "a peck that is not above 0",
                   "Q above 0, whichever way the tool goes");
}

int holes_of(const Statement& statement, int most) {
  const Word* l = statement.word('L');
  const Word* const k = statement.rules().repeats_by_k ? statement.word('K') : nullptr;
  if (l && k) statement.fail(*k, "K and L both count repeats", "one of them");
  if (k) l = k;
  if (!l) return 1;
  const double count = std::round(l->value);
  const int least = statement.rules().separate_cycle_group ? 0 : 1;
  if (!(std::abs(l->value - count) <= kWholeCount) || count < least)
    statement.fail(*l, in_quotes(l->text) + " repeats of a canned cycle",
                   "an integer from " + std::to_string(least));
  if (count > most)
    statement.fail(*l, in_quotes(l->text) + " repeats of a canned cycle",
                   "at most " + std::to_string(most));
  return static_cast<int>(count);
}

const Word& blamed(const Statement& statement) {
  const Word* const code = statement.g_word(GGroup::motion);
  return code ? *code : *statement.first_of({'X', 'Y', 'Z', '@', '^'});
}

const Word& word_or_blamed(const Statement& statement, char letter) {
  const Word* const word = statement.word(letter);
  return word ? *word : blamed(statement);
}

std::string cycle_name(int code) {
  return "G" + std::to_string(code / 10);
}

}  // namespace limitgauge::model::gcode
