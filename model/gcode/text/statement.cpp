#include "model/gcode/text/statement.h"

#include <cmath>
#include <limits>

#include "model/text/message_text.h"

namespace limitgauge::model::gcode {
namespace {

constexpr int kG80 = 800;
constexpr std::uint32_t kUsed = letter_bits("DEFHIJKLPQRSTXYZ");
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
    present_ |= letter_bit(word.letter);
  }
}

void Statement::add_g(const Word& word, Index index) {
  const std::optional<int> tenths = whole(word.value * 10);
  const std::optional<GGroup> group = tenths ? g_group(*tenths) : std::nullopt;
  if (!group) refuse(word, tenths ? g_refusal(*tenths) : Refusal{});
  Code& code = g_[static_cast<int>(*group)];
  // RS274/NGC lets G80 stand beside the motion code that follows it.
  if (code.index != 0 && *tenths == kG80) return;
  if (code.index != 0 && code.number == kG80) code = {};
  put(code, *tenths, word, index);
}

void Statement::add_m(const Word& word, Index index) {
  const std::optional<int> number = whole(word.value);
  const std::optional<MGroup> group = number ? m_group(*number) : std::nullopt;
  if (!group) refuse(word, number ? m_refusal(*number) : Refusal{});
  put(m_[static_cast<int>(*group)], *number, word, index);
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
  if ((kOtherAxes & bit) != 0)
    fail(word, "axis word " + in_quotes(word.text) + " of an axis that is not carried out",
         "X, Y and Z only");
  if ((kUsed & bit) == 0)
    fail(word, in_quotes(word.text) + " belongs to no code that is carried out",
         "a word of RS274/NGC");
  if ((present_ & bit) != 0)
    fail(word,
         in_quotes(word.text) + " after " + in_quotes(this->word(word.letter)->text) +
             " in one block",
         "each letter once");
  letters_[word.letter - 'A'] = index;
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
    fail(word, "unknown code " + in_quotes(word.text), "a code of RS274/NGC");
  fail(word, in_quotes(word.text) + " is not carried out: " + std::string(refusal.wrong),
       std::string(refusal.expected));
}

void Statement::fail(const Word& word, const std::string& wrong,
                     const std::string& expected) const {
  throw InputError(lexer_.place(block_.line, word.column), wrong, expected);
}

}  // namespace limitgauge::model::gcode
