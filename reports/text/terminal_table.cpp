#include "reports/text/terminal_table.h"

#include <algorithm>
#include <utility>

#include "reports/text/text.h"

namespace limitgauge::reports {
namespace {

constexpr std::size_t kShortest = 5;

const char* code_of(Tone tone) {
  switch (tone) {
    case Tone::good:
      return "\x1b[32m";
    case Tone::bad:
      return "\x1b[1;31m";
    case Tone::doubtful:
      return "\x1b[1;33m";
    case Tone::faint:
      return "\x1b[2m";
    case Tone::plain:
      break;
  }
  return "";
}

}  // namespace

std::string painted(const std::string& text, Tone tone, bool colour) {
  return colour && tone != Tone::plain && !text.empty() ? code_of(tone) + text + "\x1b[0m" : text;
}

TerminalTable::TerminalTable(std::vector<Column> columns)
    : columns_(std::move(columns)),
      hidden_(columns_.size()),
      natural_(columns_.size()),
      widths_(columns_.size()) {}

void TerminalTable::add_row(std::vector<Cell> row) {
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    row[c].text = clean_text(row[c].text);
    natural_[c] = std::max(natural_[c], code_points(row[c].text));
  }
  widths_ = natural_;
  rows_.push_back(std::move(row));
}

void TerminalTable::hide(std::size_t column) {
  hidden_[column] = true;
}

std::size_t TerminalTable::width() const {
  std::size_t sum = 0;
  for (std::size_t c = 0; c < columns_.size(); ++c)
    if (!hidden_[c]) sum += widths_[c] + (sum > 0 ? columns_[c].gap : 0);
  return sum;
}

void TerminalTable::fit(std::size_t width) {
  widths_ = natural_;
  while (this->width() > width) {
    std::size_t* widest = nullptr;
    for (std::size_t c = 0; c < columns_.size(); ++c)
      if (columns_[c].gives_way && !hidden_[c] && (widest == nullptr || widths_[c] > *widest))
        widest = &widths_[c];
    if (widest == nullptr || *widest <= kShortest) return;
    --*widest;
  }
}

std::string TerminalTable::line(std::size_t row, bool colour) const {
  std::string line;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    if (hidden_[c]) continue;
    const Cell& cell = rows_[row][c];
    const std::string text = shortened(cell.text, widths_[c]);
    const std::string padding(widths_[c] - code_points(text), ' ');
    const std::string shown = painted(text, cell.tone, colour);
    if (!line.empty()) line += std::string(columns_[c].gap, ' ');
    line += columns_[c].right ? padding + shown : shown + padding;
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

}  // namespace limitgauge::reports
