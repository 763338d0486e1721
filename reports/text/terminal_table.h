#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace limitgauge::reports {

/// How text stands out on a terminal with colours.
enum class Tone { plain, good, bad, doubtful, faint };
/// `text` in the colour of `tone` where there are colours.
std::string painted(const std::string& text, Tone tone, bool colour);

/// Rows of text in columns for a terminal; all widths in characters.
class TerminalTable {
 public:
  struct Column {
    bool right = false;      ///< its cells end below each other
    bool gives_way = false;  ///< its cells may be shortened where the terminal is narrow
    std::size_t gap = 2;     ///< spaces before it
  };
  struct Cell {
    std::string text;
    Tone tone = Tone::plain;
  };

  explicit TerminalTable(std::vector<Column> columns);
  /// One cell a column; control characters in it are replaced.
  void add_row(std::vector<Cell> row);
  /// Leaves a column out.
  void hide(std::size_t column);
  /// Shortens the columns that give way, the widest first, as far as five characters, until a line
  /// is no longer than `width`.
  void fit(std::size_t width);

  std::size_t rows() const { return rows_.size(); }
  /// Of a line.
  std::size_t width() const;
  /// One row with its line feed, without spaces at its end.
  std::string line(std::size_t row, bool colour) const;

 private:
  std::vector<Column> columns_;
  std::vector<bool> hidden_;
  std::vector<std::vector<Cell>> rows_;
  std::vector<std::size_t> natural_, widths_;  ///< of the columns: unshortened and as shown
};

}  // namespace limitgauge::reports
