#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>

#include "model/base/error.h"

namespace limitgauge::model {

/// Hands text to a stream in blocks and counts its lines.
class TextBlocks {
 public:
  explicit TextBlocks(std::ostream& out) : out_(out) {}

  void append(std::string_view text) { text_.append(text); }
  bool at_line_begin() const { return text_.size() == line_begin_; }
  void end_line() {
    text_.push_back('\n');
    ++line_;
    if (text_.size() >= kBlockBytes) flush();
    line_begin_ = text_.size();
  }
  void line(std::string_view text) {
    append(text);
    end_line();
  }
  /// Throws ResourceError where the stream takes no more.
  void flush() {
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
    if (!out_) throw ResourceError("the program cannot be written; is the disk full?");
  }
  /// Of the line that is being written, from 1.
  std::uint32_t line_number() const { return line_; }

 private:
  static constexpr std::size_t kBlockBytes = 1 << 16;

  std::ostream& out_;
  std::string text_;
  std::size_t line_begin_ = 0;
  std::uint32_t line_ = 1;
};

}  // namespace limitgauge::model
