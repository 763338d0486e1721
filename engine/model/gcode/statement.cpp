#include "engine/model/gcode/statement.h"

#include <cmath>
#include <limits>

#include "engine/model/words.h"

namespace limitgauge::model::gcode {
namespace {

constexpr int kG80 = 800;
constexpr std::string_view kCarriedOut = "FIJKLPQRSTXYZ";

/// `value` as a whole number, where it is one within RS274/NGC's 0.001.
std::optional<int> whole(double value) {
  const double nearest = std::round(value);
  if (std::abs(value - nearest) > 0.001 || std::abs(nearest) > std::numeric_limits<int>::max())
    return std::nullopt;
  return static_cast<int>(nearest);
}

}  // namespace

Statement::Statement(const Block& block, const Lexer& lexer) : block_(block), lexer_(lexer) {
  for (const Word& word : block.words) {
    if (word.letter == 'G') {
      add_g(word);
    } else if (word.letter == 'M') {
      add_m(word);
    } else {
      add_other(word);
    }
  }
}

void Statement::add_g(const Word& word) {
  const std::optional<int> tenths = whole(word.value * 10);
  const std::optional<GGroup> group = tenths ? g_group(*tenths) : std::nullopt;
  if (!group) refuse(word, tenths ? refused_g_meaning(*tenths) : std::string_view());
  Code& code = g_[static_cast<int>(*group)];
  // RS274/NGC lets G80 stand beside the motion code that follows it.
  if (code.word != nullptr && *tenths == kG80) return;
  if (code.word != nullptr && code.number != kG80)
    fail(word,
         in_quotes(word.text) + " after " + in_quotes(code.word->text) + " of the same modal group",
         "one of them");
  code = {*tenths, &word};
}

void Statement::add_m(const Word& word) {
  const std::optional<int> number = whole(word.value);
  const std::optional<MGroup> group = number ? m_group(*number) : std::nullopt;
  if (!group) refuse(word, number ? refused_m_meaning(*number) : std::string_view());
  Code& code = m_[static_cast<int>(*group)];
  if (code.word != nullptr)
    fail(word,
         in_quotes(word.text) + " after " + in_quotes(code.word->text) + " of the same modal group",
         "one of them");
  code = {*number, &word};
}

void Statement::add_other(const Word& word) {
  if (kCarriedOut.find(word.letter) == std::string_view::npos) {
    const bool axis = std::string_view("ABCUVW").find(word.letter) != std::string_view::npos;
    fail(word,
         axis ? "axis word " + in_quotes(word.text) + " is not supported in this release"
              : in_quotes(word.text) + " belongs to no code that this release carries out",
         axis ? "X, Y and Z only" : "words of G0 to G4 and auxiliaries");
  }
  const Word*& place = letters_[word.letter - 'A'];
  if (place != nullptr)
    fail(word, in_quotes(word.text) + " after " + in_quotes(place->text) + " in one block",
         "each letter once");
  place = &word;
}

const Word* Statement::first_of(std::initializer_list<char> letters) const {
  for (const Word& candidate : block_.words) {
    for (const char letter : letters) {
      if (candidate.letter == letter) return &candidate;
    }
  }
  return nullptr;
}

void Statement::refuse(const Word& word, std::string_view meaning) const {
  if (meaning.empty()) fail(word, "unknown code " + in_quotes(word.text), "a code of RS274/NGC");
  fail(word,
       in_quotes(word.text) + " (" + std::string(meaning) + ") is not supported in this release",
       "a program without it");
}

void Statement::fail(const Word& word, const std::string& wrong,
                     const std::string& expected) const {
  throw InputError(lexer_.place(block_.line, word.column), wrong, expected);
}

}  // namespace limitgauge::model::gcode
