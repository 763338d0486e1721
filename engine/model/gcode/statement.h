#pragma once

#include <array>
#include <initializer_list>
#include <optional>

#include "engine/model/gcode/codes.h"
#include "engine/model/gcode/lexer.h"

namespace limitgauge::model::gcode {

/// A block whose words have been sorted by what they are: at most one code of each modal group and
/// one word of each other letter. It refers to the block's words and dies with them.
class Statement {
 public:
  struct Code {
    int number = 0;  ///< G codes in tenths
    const Word* word = nullptr;
  };

  /// Throws InputError at the word that is unknown, not supported, repeated or in conflict with
  /// another of its modal group.
  Statement(const Block& block, const Lexer& lexer);

  /// The word of a letter other than G and M; null where there is none.
  const Word* word(char letter) const { return letters_[letter - 'A']; }
  std::optional<int> g(GGroup group) const { return number(g_[static_cast<int>(group)]); }
  std::optional<int> m(MGroup group) const { return number(m_[static_cast<int>(group)]); }
  const Word* g_word(GGroup group) const { return g_[static_cast<int>(group)].word; }
  const Word* m_word(MGroup group) const { return m_[static_cast<int>(group)].word; }
  /// The first word of the block that has one of `letters`; null where there is none.
  const Word* first_of(std::initializer_list<char> letters) const;
  const Block& block() const { return block_; }
  [[noreturn]] void fail(const Word& word, const std::string& wrong,
                         const std::string& expected) const;

 private:
  static std::optional<int> number(const Code& code) {
    return code.word == nullptr ? std::nullopt : std::optional(code.number);
  }
  void add_g(const Word& word);
  void add_m(const Word& word);
  void add_other(const Word& word);
  [[noreturn]] void refuse(const Word& word, std::string_view meaning) const;

  const Block& block_;
  const Lexer& lexer_;
  std::array<const Word*, 26> letters_{};
  std::array<Code, static_cast<int>(GGroup::count)> g_{};
  std::array<Code, static_cast<int>(MGroup::count)> m_{};
};

}  // namespace limitgauge::model::gcode
