#pragma once

#include <array>
#include <initializer_list>
#include <optional>

#include "engine/model/gcode_codes.h"
#include "engine/model/gcode_lexer.h"

namespace limitgauge::model {

/// A block whose words have been sorted by what they are: at most one code of each modal group and
/// one word of each other letter. It refers to the block's words and dies with them.
class GcodeStatement {
 public:
  struct Code {
    int number = 0;  ///< G codes in tenths
    const GcodeWord* word = nullptr;
  };

  /// Throws InputError at the word that is unknown, not supported, repeated or in conflict with
  /// another of its modal group.
  GcodeStatement(const GcodeBlock& block, const GcodeLexer& lexer);

  /// The word of a letter other than G and M; null where there is none.
  const GcodeWord* word(char letter) const { return letters_[letter - 'A']; }
  std::optional<int> g(GGroup group) const { return number(g_[static_cast<int>(group)]); }
  std::optional<int> m(MGroup group) const { return number(m_[static_cast<int>(group)]); }
  const GcodeWord* g_word(GGroup group) const { return g_[static_cast<int>(group)].word; }
  const GcodeWord* m_word(MGroup group) const { return m_[static_cast<int>(group)].word; }
  /// The first word of the block that has one of `letters`; null where there is none.
  const GcodeWord* first_of(std::initializer_list<char> letters) const;
  const GcodeBlock& block() const { return block_; }
  [[noreturn]] void fail(const GcodeWord& word, const std::string& wrong,
                         const std::string& expected) const;

 private:
  static std::optional<int> number(const Code& code) {
    return code.word == nullptr ? std::nullopt : std::optional(code.number);
  }
  void add_g(const GcodeWord& word);
  void add_m(const GcodeWord& word);
  void add_other(const GcodeWord& word);
  [[noreturn]] void refuse(const GcodeWord& word, std::string_view meaning) const;

  const GcodeBlock& block_;
  const GcodeLexer& lexer_;
  std::array<const GcodeWord*, 26> letters_{};
  std::array<Code, static_cast<int>(GGroup::count)> g_{};
  std::array<Code, static_cast<int>(MGroup::count)> m_{};
};

}  // namespace limitgauge::model
