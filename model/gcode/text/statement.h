#pragma once

#include <array>
#include <bitset>
#include <initializer_list>
#include <optional>

#include "model/gcode/control/control_codes.h"
#include "model/gcode/text/codes.h"
#include "model/gcode/text/lexer.h"

namespace limitgauge::model::gcode {

/// Letters, and the two words of polar coordinates behind them.
inline constexpr int kLetters = 28;
constexpr int letter_index(char letter) {
  return letter == '@' ? 26 : letter == '^' ? 27 : letter - 'A';
}
/// Letters as a set: bit 0 is A.
constexpr std::uint32_t letter_bit(char letter) {
  return std::uint32_t{1} << letter_index(letter);
}
constexpr std::uint32_t letter_bits(std::string_view letters) {
  std::uint32_t bits = 0;
  for (const char letter : letters) bits |= letter_bit(letter);
  return bits;
}
inline constexpr std::uint32_t kAxisLetters = letter_bits("XYZ");
inline constexpr std::uint32_t kRotaryLetters = letter_bits("ABC");
inline constexpr std::uint32_t kPolarLetters = letter_bits("@^");

/// A block whose words have been sorted by what they are: at most one code of each modal group and
/// one word of each other letter. It refers to the block's words and dies with them.
class Statement {
 public:
  /// Throws InputError at the word that is unknown, not supported, repeated or in conflict with
  /// another of its modal group.
  Statement(const Block& block, const Lexer& lexer);

  /// The word of a letter other than G and M; null where there is none.
  const Word* word(char letter) const { return at(letters_[letter_index(letter)]); }
  /// Every letter of the block, G and M too.
  std::uint32_t letters() const { return present_; }
  bool has_axes() const { return (present_ & kAxisLetters) != 0; }
  /// `@` or `^`.
  bool is_polar() const { return (present_ & kPolarLetters) != 0; }
  /// A word of a rotary axis: one that the machine has, or one that stays where it is.
  bool has_rotary() const { return has_rotary_; }
  /// Settings of the control that move nothing, and words that belong to them or to no axis here.
  bool is_set_aside(const Word& word) const { return aside_[index_of(word)]; }
  bool any_set_aside() const { return aside_.any(); }
  const ControlRules& rules() const { return lexer_.rules(); }
  std::optional<int> g(GGroup group) const { return number(g_[static_cast<int>(group)]); }
  std::optional<int> m(MGroup group) const { return number(m_[static_cast<int>(group)]); }
  const Word* g_word(GGroup group) const { return at(g_[static_cast<int>(group)].index); }
  const Word* m_word(MGroup group) const { return at(m_[static_cast<int>(group)].index); }
  /// The first word of the block that has one of `letters`; null where there is none.
  const Word* first_of(std::initializer_list<char> letters) const;
  /// A word of the block to blame where none is missing or wrong by itself.
  const Word& blamed() const;
  const Block& block() const { return block_; }
  /// Of the main program: a subprogram from another file counts as the line that called it.
  std::uint32_t line() const { return block_.main_line; }
  [[noreturn]] void fail(const Word& word, const std::string& wrong,
                         const std::string& expected) const;
  [[noreturn]] void fail_line(const std::string& wrong, const std::string& expected) const;

 private:
  /// Place of a word in its block, counted from 1; 0: there is none.
  using Index = std::uint8_t;
  static constexpr std::size_t kMostWords = 128;
  struct Code {
    std::int16_t number = 0;  ///< G codes in tenths
    Index index = 0;
  };

  const Word* at(Index index) const { return index == 0 ? nullptr : &block_.words[index - 1]; }
  static std::optional<int> number(Code code) {
    return code.index == 0 ? std::nullopt : std::optional<int>(code.number);
  }
  void add_g(const Word& word, Index index);
  void add_m(const Word& word, Index index);
  void add_other(const Word& word, Index index);
  void put(Code& code, int number, const Word& word, Index index);
  void add(const CodeRule& rule, const Word& word, Index index);
  void set_aside(std::string_view letters);
  void take_dwell();
  std::size_t index_of(const Word& word) const {
    return static_cast<std::size_t>(&word - block_.words.data());
  }
  [[noreturn]] void refuse(const Word& word, const Refusal& refusal) const;
  [[noreturn]] void refuse_axis(const Word& word) const;

  const Block& block_;
  const Lexer& lexer_;
  std::uint32_t present_ = 0;
  bool has_rotary_ = false;
  std::array<Index, kLetters> letters_{};
  std::bitset<kMostWords> aside_;
  std::array<Code, static_cast<int>(GGroup::count)> g_{};
  std::array<Code, static_cast<int>(MGroup::count)> m_{};
};

/// `value` as a whole number, where it is one within `tolerance`.
std::optional<int> whole(double value, double tolerance = 0.001);

}  // namespace limitgauge::model::gcode
