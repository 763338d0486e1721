#include "model/machine/machine_setup.h"

#include <cmath>
#include <limits>

#include "model/base/coordinate_limit.h"
#include "model/base/error.h"
#include "model/base/tolerance.h"
#include "model/text/characters.h"
#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

constexpr std::size_t kMostTools = 1000;

/// One line of the table, word by word.
class ToolLine {
 public:
  ToolLine(std::string_view text, SourcePlace place, double unit_mm)
      : text_(text.substr(0, text.find(';'))), place_(std::move(place)), unit_mm_(unit_mm) {}

  /// Nothing where the line has no words.
  std::optional<ToolEntry> read();

 private:
  [[noreturn]] void fail(std::size_t at, const std::string& wrong, const std::string& expected) {
    place_.column = static_cast<int>(at) + 1;
    throw InputError(place_, wrong, expected);
  }
  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }
  double number(std::size_t begin, char letter);
  void take(ToolEntry& entry, char letter, std::size_t begin);
  int tool_number(double value, std::size_t begin);
  double length(double value, std::size_t begin);

  std::string_view text_;
  SourcePlace place_;
  double unit_mm_;
  std::size_t at_ = 0;
  std::string seen_;
};

std::optional<ToolEntry> ToolLine::read() {
  skip_blanks();
  if (at_ >= text_.size()) return std::nullopt;
  ToolEntry entry;
  for (; at_ < text_.size(); skip_blanks()) {
    const std::size_t begin = at_;
    const char letter = upper(text_[at_++]);
    if (letter < 'A' || letter > 'Z')
      fail(begin, "a tool table's line has a word that begins with no letter",
           "T1 P1 Z25.4 D6 ;remark");
    if (seen_.find(letter) != std::string::npos)
      fail(begin, std::string(1, letter) + " twice in one line", "each letter once");
    seen_ += letter;
    take(entry, letter, begin);
  }
  if (seen_.find('T') == std::string::npos) fail(0, "a line without a tool's number", "T");
  return entry;
}

double ToolLine::number(std::size_t begin, char letter) {
  skip_blanks();
  std::size_t end = at_;
  while (end < text_.size() && !is_blank(text_[end])) ++end;
  const std::optional<double> value = parse_number(text_.substr(at_, end - at_));
  if (!value)
    fail(begin, std::string("the number of ") + letter + " is missing or malformed", "a number");
  at_ = end;
  return *value;
}

int ToolLine::tool_number(double value, std::size_t begin) {
  if (value != std::floor(value) || value < 0 || value > std::numeric_limits<int>::max())
    fail(begin, "a tool number that is no integer from 0", "T1");
  return static_cast<int>(value);
}

double ToolLine::length(double value, std::size_t begin) {
  const double length_mm = value * unit_mm_;
  if (!is_near(length_mm))
    fail(begin, "a length beyond any tool: " + shortest(length_mm) + " mm", kFarthestExpected);
  return length_mm;
}

void ToolLine::take(ToolEntry& entry, char letter, std::size_t begin) {
  const double value = number(begin, letter);
  if (letter == 'T') entry.number = tool_number(value, begin);
  if (letter == 'Z') entry.length_mm = length(value, begin);
  if (letter == 'D') entry.diameter_mm = length(value, begin);
  if ((letter == 'X' || letter == 'Y') && value != 0)
    fail(begin, std::string("a tool offset along ") + letter + " is not carried out",
         "0, or Z only");
}

}  // namespace

std::string work_offset_name(std::size_t index) {
  if (index < 6) return "G" + std::to_string(54 + index);
  if (index >= kWorkOffsets) return "G54.1 P" + std::to_string(index - kWorkOffsets + 1);
  return "G59." + std::to_string(index - 5);
}

std::vector<ToolEntry> parse_tool_table(const std::string& text, const std::string& name,
                                        bool inch) {
  std::vector<ToolEntry> tools;
  std::string_view rest = text;
  for (int line = 1; !rest.empty(); ++line) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const SourcePlace place{name, line, 1};
    if (const auto entry = ToolLine(rest.substr(0, end), place, inch ? kInchMm : 1).read()) {
      for (const ToolEntry& other : tools) {
        if (other.number == entry->number)
          throw InputError(place, "tool " + std::to_string(entry->number) + " twice", "each once");
      }
      if (tools.size() >= kMostTools) throw InputError(place, "more than 1000 tools", "fewer");
      tools.push_back(*entry);
    }
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return tools;
}

}  // namespace limitgauge::model
