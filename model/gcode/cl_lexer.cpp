#include "model/gcode/cl_lexer.h"

#include <algorithm>
#include <utility>

#include "model/text/characters.h"
#include "model/text/message_text.h"

namespace limitgauge::model {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
/// No statement of this vocabulary has more; one endless statement must not fill the memory.
constexpr std::size_t kMostFigures = 20;

bool is_word(char c) {
  const char u = upper(c);
  return (u >= 'A' && u <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+';
}
bool takes_text(const std::string& major) {
  return major == "PARTNO" || major == "PPRINT" || major == "REMARK";
}

}  // namespace

ClLexer::ClLexer(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {
  if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
}

void ClLexer::fail(const ClWord& word, const std::string& wrong,
                   const std::string& expected) const {
  throw InputError({name_, static_cast<int>(word.line), static_cast<int>(word.column)}, wrong,
                   expected);
}

void ClLexer::end_line() {
  if (at_ < text_.size()) ++at_;
  ++line_;
  line_begin_ = at_;
}

/// Blanks, a remark, and the line end that `$` continues.
void ClLexer::skip_blanks() {
  while (at_ < text_.size()) {
    const std::size_t line_end = std::min(text_.find('\n', at_), text_.size());
    if (is_blank(text_[at_])) {
      ++at_;
    } else if (text_.substr(at_).starts_with("$$")) {
      at_ = line_end;
      return;
    } else if (text_[at_] == '$' &&
               std::all_of(text_.begin() + static_cast<std::ptrdiff_t>(at_) + 1,
                           text_.begin() + static_cast<std::ptrdiff_t>(line_end), is_blank)) {
      at_ = line_end;
      end_line();
    } else {
      return;
    }
  }
}

/// On to the next statement; false where there is none.
bool ClLexer::skip_lines() {
  for (skip_blanks(); at_ < text_.size() && text_[at_] == '\n'; skip_blanks()) end_line();
  return at_ < text_.size();
}

ClWord ClLexer::read_word() {
  skip_blanks();
  ClWord word{{}, line_, static_cast<std::uint32_t>(at_ - line_begin_ + 1)};
  while (at_ < text_.size() && is_word(text_[at_])) word.text += upper(text_[at_++]);
  if (word.text.empty()) {
    const bool ends = peek() == '\n';
    fail(word, ends ? "the statement ends too soon" : in_quotes(text_[at_]) + " begins no word",
         "a word or a number");
  }
  return word;
}

void ClLexer::read_text(ClStatement& statement) {
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  statement.text = text_.substr(at_, end - at_);
  at_ = end;
  while (!statement.text.empty() && is_blank(statement.text.back())) statement.text.pop_back();
  const std::size_t begin = statement.text.find_first_not_of(" \t/");
  statement.text.erase(0, std::min(begin, statement.text.size()));
}

void ClLexer::read_figures(ClStatement& statement) {
  do {
    ++at_;
    statement.figures.push_back(read_word());
    if (statement.figures.size() > kMostFigures)
      fail(statement.figures.back(), "more than 20 figures in one statement",
           "a statement that ends sooner");
    skip_blanks();
  } while (peek() == ',');
}

bool ClLexer::next(ClStatement& statement) {
  statement = {};
  if (!skip_lines()) return false;
  statement.major = read_word();
  if (takes_text(statement.major.text)) {
    read_text(statement);
  } else {
    skip_blanks();
    if (peek() == '/') read_figures(statement);
    if (peek() != '\n') {
      const ClWord here{{}, line_, static_cast<std::uint32_t>(at_ - line_begin_ + 1)};
      fail(here, in_quotes(text_[at_]) + " after a whole statement", "',' or the line's end");
    }
  }
  end_line();
  return true;
}

}  // namespace limitgauge::model
