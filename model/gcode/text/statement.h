#pragma once

#include <array>
#include <initializer_list>
#include <optional>

#include "model/gcode/text/codes.h"
#include "model/gcode/text/lexer.h"

namespace limitgauge::model::gcode {

/// Letters as a set: bit 0 is A.
constexpr std::uint32_t letter_bit(char letter) {
  return std::uint32_t{1} << (letter - 'A');
}
constexpr std::uint32_t letter_bits(std::string_view letters) {
  std::uint32_t bits = 0;
  for (const char letter : letters) bits |= letter_bit(letter);
  return bits;
}
inline constexpr std::uint32_t kAxisLetters = letter_bits("XYZ");

/// A block whose words have been sorted by what they are: at most one code of each modal group and
/// one word of each other letter. It refers to the block's words and dies with them.
class Statement {
 public:
  /// Throws InputError at the word that is unknown, not supported, repeated or in conflict with
  /// another of its modal group.
  Statement(const Block& block, const Lexer& lexer);

  /// The word of a letter other than G and M; null where there is none.
  const Word* word(char letter) const { return at(letters_[letter - 'A']); }
  /// Every letter of the block, G and M too.
  std::uint32_t letters() const { return present_; }
  bool has_axes() const { return (present_ & kAxisLetters) != 0; }
  std::optional<int> g(GGroup group) const { return number(g_[static_cast<int>(group)]); }
  std::optional<int> m(MGroup group) const { return number(m_[static_cast<int>(group)]); }
  const Word* g_word(GGroup group) const { return at(g_[static_cast<int>(group)].index); }
  const Word* m_word(MGroup group) const { return at(m_[static_cast<int>(group)].index); }
  /// The first word of the block that has one of `letters`; null where there is none.
  const Word* first_of(std::initializer_list<char> letters) const;
  /// A word of the block to blame where none is missing or wrong by itself.
  const Word& blamed() const;
  const Block& block() const { return block_; }
  std::uint32_t line() const { return block_.line; }
  [[noreturn]] void fail(const Word& word, const std::string& wrong,
                         const std::string& expected) const;

 private:
  /// Place of a word in its block, counted from 1; 0: there is none.
  using Index = std::uint8_t;
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
  [[noreturn]] void refuse(const Word& word, const Refusal& refusal) const;

  const Block& block_;
  const Lexer& lexer_;
  std::uint32_t present_ = 0;
  std::array<Index, 26> letters_{};
  std::array<Code, static_cast<int>(GGroup::count)> g_{};
  std::array<Code, static_cast<int>(MGroup::count)> m_{};
};

/// `value` as a whole number, where it is one within `tolerance`.
std::optional<int> whole(double value, double tolerance = 0.001);

}  // namespace limitgauge::model::gcode
