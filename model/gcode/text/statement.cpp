#include "model/gcode/text/statement.h"

#include <cmath>
#include <limits>

#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

constexpr int kG80 = 800;
constexpr std::uint32_t kUsed = letter_bits("DEFHIJKLPQRSTXYZ@^");
constexpr std::uint32_t kOtherAxes = letter_bits("ABCUVW");

}  // namespace

std::optional<int> whole(double value, double tolerance) {
  const double nearest = std::round(value);
  if (!(std::abs(value - nearest) <= tolerance) ||
      std::abs(nearest) > std::numeric_limits<int>::max())
    return std::nullopt;
  return static_cast<int>(nearest);
}

Statement::Statement(const Block& block, const Lexer& lexer) : block_(block), lexer_(lexer) {
  Index index = 0;
  for (const Word& word : block.words) {
    ++index;
    if (word.letter == 'G') {
      add_g(word, index);
    } else if (word.letter == 'M') {
      add_m(word, index);
    } else {
      add_other(word, index);
    }
    if (!aside_[index - 1]) present_ |= letter_bit(word.letter);
  }
  for (const Word& word : block.words) {
    if (!aside_.any()) break;
    if (!is_set_aside(word) || (word.letter != 'G' && word.letter != 'M')) continue;
    const int number = whole(word.value * (word.letter == 'G' ? 10 : 1)).value_or(-1);
    const CodeRule* const rule =
        word.letter == 'G' ? g_rule(rules().control, number) : m_rule(rules().control, number);
    set_aside(rule->text);
  }
  take_dwell();
}

void Statement::refuse_axis(const Word& word) const {
  if ((kRotaryLetters & letter_bit(word.letter)) == 0)
    fail(word, "axis word " + in_quotes(word.text) + " of an axis that is not carried out",
         "X, Y and Z only");
  fail(word, "axis word " + in_quotes(word.text) + " of a rotary axis that the machine lacks",
       "[machine] kinematics and a [[machine.axis]] with word = \"" + std::string(1, word.letter) +
           "\" in the job, or axes that stay at 0");
}

/// Words that belong to a setting go with it.
void Statement::set_aside(std::string_view letters) {
  for (const char letter : letters) {
    Index& index = letters_[letter_index(letter)];
    if (index == 0) continue;
    aside_.set(index - 1U);
    index = 0;
    present_ &= ~letter_bit(letter);
  }
}

/// The time of G4 by other letters than P: none of them moves anything then.
void Statement::take_dwell() {
  if (rules().dwell_letters == "P" || g(GGroup::non_modal) != 40) return;
  set_aside(rules().dwell_letters);
}

void Statement::add_g(const Word& word, Index index) {
  std::optional<int> tenths = whole(word.value * 10);
  if (const auto code =
          lexer_.rotary() != 0 && tenths ? rotary_code(rules().control, *tenths) : std::nullopt)
    return put(g_[static_cast<int>(code->group)], code->tenths, word, index);
  if (const CodeRule* rule = tenths ? g_rule(rules().control, *tenths) : nullptr) {
    if (rule->use == CodeUse::work_frame) {
      if (*tenths % 10 != 0) refuse(word, {});
      return put(g_[static_cast<int>(GGroup::coordinate_system)], *tenths, word, index);
    }
    if (rule->use != CodeUse::same_as) return add(*rule, word, index);
    tenths = rule->other;
  }
  const bool extended = tenths == 541 && rules().extended_systems == 0;
  const std::optional<GGroup> group = tenths && !extended ? g_group(*tenths) : std::nullopt;
  if (!group) refuse(word, tenths ? g_refusal(*tenths) : Refusal{});
  Code& code = g_[static_cast<int>(*group)];
  // RS274/NGC lets G80 stand beside the motion code that follows it.
  if (code.index != 0 && *tenths == kG80) return;
  if (code.index != 0 && code.number == kG80) code = {};
  put(code, *tenths, word, index);
}

void Statement::add_m(const Word& word, Index index) {
  std::optional<int> number = whole(word.value);
  if (lexer_.rotary() != 0 && number && is_kinematics_switch(rules().control, *number))
    return put(m_[static_cast<int>(MGroup::kinematics)], *number, word, index);
  if (const CodeRule* rule = number ? m_rule(rules().control, *number) : nullptr) {
    if (rule->use != CodeUse::same_as) return add(*rule, word, index);
    number = rule->other;
  }
  const std::optional<MGroup> group = number ? m_group(*number) : std::nullopt;
  if (!group) refuse(word, number ? m_refusal(*number) : Refusal{});
  put(m_[static_cast<int>(*group)], *number, word, index);
}

/// A code that the control reads in a way of its own.
void Statement::add(const CodeRule& rule, const Word& word, Index index) {
  if (rule.use == CodeUse::refused) refuse(word, {rule.text, rule.expected});
  aside_.set(index - 1U);
}

void Statement::put(Code& code, int number, const Word& word, Index index) {
  if (code.index != 0)
    fail(word,
         in_quotes(word.text) + " after " + in_quotes(at(code.index)->text) +
             " of the same modal group",
         "one of them");
  code = {static_cast<std::int16_t>(number), index};
}

void Statement::add_other(const Word& word, Index index) {
  const std::uint32_t bit = letter_bit(word.letter);
  const bool turns = (lexer_.rotary() & bit) != 0;
  if (turns) has_rotary_ = true;
  if (!turns && (kRotaryLetters & bit) != 0 && rules().rotary_zero && word.value == 0) {
    has_rotary_ = true;
    return aside_.set(index - 1U), void();
  }
  if (!turns && (kOtherAxes & bit) != 0) refuse_axis(word);
  if (!turns && (kUsed & bit) == 0)
    fail(word, in_quotes(word.text) + " belongs to no code that is carried out",
         "a word of RS274/NGC");
  if ((present_ & bit) != 0)
    fail(word,
         in_quotes(word.text) + " after " + in_quotes(this->word(word.letter)->text) +
             " in one block",
         "each letter once");
  letters_[letter_index(word.letter)] = index;
}

const Word* Statement::first_of(std::initializer_list<char> letters) const {
  for (const Word& candidate : block_.words) {
    for (const char letter : letters) {
      if (candidate.letter == letter) return &candidate;
    }
  }
  return nullptr;
}

const Word& Statement::blamed() const {
  if (const Word* motion = g_word(GGroup::motion)) return *motion;
  if (const Word* axis = first_of({'X', 'Y', 'Z', 'I', 'J', 'K', 'R'})) return *axis;
  return block_.words.front();
}

void Statement::refuse(const Word& word, const Refusal& refusal) const {
  if (refusal.wrong.empty())
    fail(word, "unknown code " + in_quotes(word.text),
         rules().control == Control::linuxcnc ? "a code of RS274/NGC"
                                              : "a code of " + std::string(rules().title));
  fail(word, in_quotes(word.text) + " is not carried out: " + std::string(refusal.wrong),
       std::string(refusal.expected));
}

void Statement::fail(const Word& word, const std::string& wrong,
                     const std::string& expected) const {
  throw InputError(lexer_.place(block_.line, word.column), wrong, expected);
}

void Statement::fail_line(const std::string& wrong, const std::string& expected) const {
  throw InputError(lexer_.place(block_.line, 1), wrong, expected);
}

}  // namespace limitgauge::model::gcode
