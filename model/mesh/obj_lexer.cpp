#include "model/mesh/obj_lexer.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

}  // namespace

ObjLexer::ObjLexer(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {
  if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
}

/// Length of a continuation (backslash and line end) at the current place, 0 where there is none.
std::size_t ObjLexer::continuation_length() const {
  const std::string_view rest = text_.substr(at_, 3);
  if (rest.starts_with("\\\r\n")) return 3;
  return rest.starts_with("\\\n") ? 2 : 0;
}

void ObjLexer::start_line() {
  ++line_;
  line_begin_ = at_;
}

void ObjLexer::skip_blanks() {
  while (!at_end()) {
    if (is_blank(text_[at_])) {
      ++at_;
    } else if (const std::size_t length = continuation_length(); length > 0) {
      at_ += length;
      start_line();
    } else if (text_[at_] == '#') {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else {
      return;
    }
  }
}

bool ObjLexer::next_statement() {
  skip_blanks();
  while (!at_end() && text_[at_] == '\n') {
    ++at_;
    start_line();
    skip_blanks();
  }
  return !at_end();
}

ObjWord ObjLexer::word() {
  skip_blanks();
  const std::size_t begin = at_;
  while (!at_end() && !is_blank(text_[at_]) && text_[at_] != '\n' && text_[at_] != '#' &&
         (text_[at_] != '\\' || continuation_length() == 0))
    ++at_;
  return {text_.substr(begin, at_ - begin), line_,
          static_cast<std::uint32_t>(begin - line_begin_ + 1)};
}

void ObjLexer::skip_statement() {
  while (!word().text.empty()) continue;
}

Vec3 ObjLexer::vertex(const ObjWord& statement) {
  constexpr std::size_t kColoured = 6;
  std::array<double, kColoured> values{};
  std::size_t count = 0;
  ObjWord next = word();
  for (; !next.text.empty() && count < kColoured; next = word()) {
    const std::optional<double> value = parse_number(next.text);
    if (!value) fail(next, in_quotes(next.text) + " is not a finite number", "a coordinate");
    values[count++] = *value;
  }
  if (!next.text.empty()) fail(next, "too many values for a vertex", "x y z");
  const bool plain = count == 3 || count == kColoured || (count == 4 && values[3] == 1);
  if (!plain) fail(statement, "a vertex with " + std::to_string(count) + " values", "x y z");
  return {values[0], values[1], values[2]};
}

void ObjLexer::fail(const ObjWord& word, const std::string& wrong,
                    const std::string& expected) const {
  throw InputError(place(word), wrong, expected);
}

SourcePlace ObjLexer::place(const ObjWord& word) const {
  return {name_, static_cast<int>(word.line), static_cast<int>(word.column)};
}

}  // namespace limitgauge::model
