#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "model/base/error.h"
#include "model/geometry/vec3.h"

namespace limitgauge::model {

/// A word of an OBJ text and where it stands; line and column count from 1.
struct ObjWord {
  std::string_view text;
  std::uint32_t line = 0, column = 0;
};

/// Cuts OBJ text into statements and words. Comments, carriage returns, a byte order mark and line
/// continuations (`\` at the end of a line) never reach the caller.
class ObjLexer {
 public:
  /// `text` must outlive the lexer and its words.
  ObjLexer(std::string_view text, std::string name);

  /// Moves on to the next word, over line ends; false at the end of the text. Words that the caller
  /// left unread in its statement would begin the next one.
  bool next_statement();
  /// The next word of this statement; its text is empty at the end of the statement.
  ObjWord word();
  /// What follows `v`: x y z, with a weight of 1 or a colour behind it, which are dropped. An
  /// InputError for anything else; a rational weight is neither a cage's nor a facet's.
  Vec3 vertex(const ObjWord& statement);
  /// Drops what is left of this statement.
  void skip_statement();

  SourcePlace place(const ObjWord& word) const;
  /// Throws the InputError about a word.
  [[noreturn]] void fail(const ObjWord& word, const std::string& wrong,
                         const std::string& expected) const;
  const std::string& name() const { return name_; }

 private:
  void skip_blanks();
  void start_line();
  std::size_t continuation_length() const;
  bool at_end() const { return at_ >= text_.size(); }

  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0, line_begin_ = 0;
  std::uint32_t line_ = 1;
};

}  // namespace limitgauge::model
