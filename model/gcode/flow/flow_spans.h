#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "model/gcode/flow/flow_keyword.h"
#include "model/gcode/text/lexer.h"

namespace limitgauge::model::gcode {

/// The lines from an O word that opens something (sub, do, while, if, repeat) to the one that ends
/// it.
struct FlowSpan {
  FlowKeyword kind = FlowKeyword::sub;
  OWord o_word;                           ///< of the first line
  std::uint32_t line = 0;                 ///< the first
  Lexer::Bookmark open, body;             ///< before and behind the first line
  Lexer::Bookmark last, behind;           ///< before and behind the last line
  std::vector<Lexer::Bookmark> branches;  ///< before the lines of elseif and else
  bool has_else = false;
  std::uint32_t last_break = 0;  ///< line of the last break out of a loop; or 0
  bool label_is_known = false;   ///< Flow has entered the label as used here
  /// Of a repeat: LinuxCNC's count, which it keeps where a return, break or continue leaves the
  /// repeat, and shares with calls in it.
  std::optional<double> count;
};

/// The spans of a program, found when they are first asked for: the text of each span is looked
/// through once, however often it is carried out.
class FlowSpans {
 public:
  FlowSpans(Lexer& lexer, std::size_t most_depth) : lexer_(lexer), most_depth_(most_depth) {}

  /// The span that `block`, the line read last, opens. The lexer stays where it is. Throws
  /// InputError for spans that are not ended, that overlap, or that stand too deep within others.
  FlowSpan& opened_by(const Block& block, FlowKeyword kind);

 private:
  void look_through();
  void open(const Block& block, FlowKeyword kind);
  void take(const Block& block, FlowKeyword keyword);
  void branch(const Block& block, FlowKeyword keyword);
  void close(const Block& block, FlowKeyword keyword);
  void note_break(const Block& block);
  FlowSpan& innermost(const Block& block, FlowKeyword keyword);
  void check_opening(const Block& block, FlowKeyword kind) const;
  [[noreturn]] void fail(const Block& block, const std::string& wrong,
                         const std::string& expected) const;

  Lexer& lexer_;
  std::size_t most_depth_;
  std::deque<FlowSpan> spans_;  // addresses stay
  std::unordered_map<std::uint32_t, FlowSpan*> by_line_;
  std::vector<FlowSpan*> open_;
  Block block_;
};

/// The keyword that ends a span.
FlowKeyword end_of(FlowKeyword kind);

}  // namespace limitgauge::model::gcode
