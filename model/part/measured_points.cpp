#include "model/part/measured_points.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "model/base/coordinate_limit.h"
#include "model/base/error.h"
#include "model/base/text_file.h"
#include "model/text/characters.h"
#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr const char* kHeaderExpected =
    "a header line with the columns x, y, z and optionally u_mm";
/// Columns by what they mean; the fourth may be missing.
constexpr std::size_t kMeanings = 4, kUncertainty = 3;
constexpr std::array<std::string_view, kMeanings> kNames = {"x", "y", "z", "u_mm"};
constexpr int kMostLines = std::numeric_limits<int>::max() - 1;

/// A piece of a line and where it begins, in bytes from 0.
struct Cell {
  std::string_view text;
  std::size_t begin = 0;
};

std::string_view trimmed(std::string_view text, std::size_t& begin) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1), ++begin;
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

Cell cell_of(std::string_view text, std::size_t begin) {
  text = trimmed(text, begin);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    text = text.substr(1, text.size() - 2);
    ++begin;
    text = trimmed(text, begin);
  }
  return {text, begin};
}

/// Parted by `separator`, where a blank stands for any number of blanks.
void split(std::string_view line, char separator, std::vector<Cell>& out) {
  out.clear();
  std::size_t at = 0;
  while (at <= line.size()) {
    if (separator == ' ') {
      while (at < line.size() && is_blank(line[at])) ++at;
      if (at == line.size()) break;
    }
    std::size_t end = at;
    bool quoted = false;
    const auto parts = [&](char c) { return separator == ' ' ? is_blank(c) : c == separator; };
    for (; end < line.size() && (quoted || !parts(line[end])); ++end)
      if (line[end] == '"') quoted = !quoted;
    out.push_back(cell_of(line.substr(at, end - at), at));
    at = end + 1;
  }
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), lower);
  return out;
}

std::optional<std::size_t> meaning_of(std::string_view name) {
  const std::string word = lower_case(name);
  for (std::size_t k = 0; k < kMeanings; ++k)
    if (word == kNames[k] || (k != kUncertainty && word == std::string(kNames[k]) + "_mm"))
      return k;
  return std::nullopt;
}

class PointsReader {
 public:
  PointsReader(std::string_view text, const std::string& shown) : rest_(text), shown_(shown) {
    if (rest_.starts_with(kByteOrderMark)) {
      rest_.remove_prefix(kByteOrderMark.size());
      mark_ = kByteOrderMark.size();
    }
  }

  MeasuredPoints read() {
    read_header();
    while (next_line()) out_.points.push_back(point_of_line());
    if (out_.points.empty())
      throw InputError({shown_, 0, 0}, "has no points", "a line for each point below the header");
    return std::move(out_);
  }

 private:
  /// The next line that is not blank, in cells once the separator is known.
  bool next_line() {
    while (!rest_.empty()) {
      const std::size_t end = rest_.find('\n');
      text_ = rest_.substr(0, end);
      rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
      if (line_ == kMostLines) refuse(0, "has too many lines", "fewer");
      if (++line_ > 1) mark_ = 0;
      if (std::all_of(text_.begin(), text_.end(), is_blank)) continue;
      if (separator_) split(text_, *separator_, cells_);
      return true;
    }
    return false;
  }

  void read_header() {
    if (!next_line()) throw InputError({shown_, 0, 0}, "is empty", kHeaderExpected);
    separator_ = text_.find(';') != std::string_view::npos   ? ';'
                 : text_.find(',') != std::string_view::npos ? ','
                                                             : ' ';
    split(text_, *separator_, cells_);
    if (parse_number(cells_.front().text)) refuse(0, "is no header", kHeaderExpected);
    for (std::size_t i = 0; i < cells_.size(); ++i) take_column(i);
    for (std::size_t k = 0; k < kUncertainty; ++k)
      if (!column_[k]) refuse(0, "has no column " + std::string(kNames[k]), kHeaderExpected);
    columns_ = cells_.size();
    out_.has_uncertainty = column_[kUncertainty].has_value();
  }

  void take_column(std::size_t i) {
    const std::string_view name = cells_[i].text;
    const std::optional<std::size_t> meaning = meaning_of(name);
    if (!meaning) {
      out_.ignored.emplace_back(name);
      return;
    }
    if (column_[*meaning])
      refuse(cells_[i].begin, "column " + in_quotes(name) + " stands there twice", "each once");
    column_[*meaning] = i;
  }

  MeasuredPoint point_of_line() const {
    if (cells_.size() != columns_)
      refuse(cells_.empty() ? 0 : cells_.back().begin,
             std::to_string(cells_.size()) + (cells_.size() == 1 ? " cell" : " cells"),
             std::to_string(columns_) + ", as the header has columns");
    MeasuredPoint point;
    point.line = line_;
    for (int axis = 0; axis < 3; ++axis)
      point.at_mm[axis] = coordinate(static_cast<std::size_t>(axis));
    if (out_.has_uncertainty) point.u_mm = uncertainty();
    return point;
  }

  double number(std::size_t meaning) const {
    const Cell& cell = cells_[*column_[meaning]];
    if (const std::optional<double> value = parse_number(cell.text)) return *value;
    refuse(cell.begin,
           std::string(kNames[meaning]) +
               (cell.text.empty() ? " is missing" : ": " + in_quotes(cell.text) + " is no number"),
           "a number of mm with a decimal point");
  }

  double coordinate(std::size_t meaning) const {
    const double value = number(meaning);
    if (!is_near(value))
      refuse(cells_[*column_[meaning]].begin,
             std::string(kNames[meaning]) + " = " + shortest(value) + " mm", kFarthestExpected);
    return value;
  }

  double uncertainty() const {
    const double value = number(kUncertainty);
    if (!(value >= kLeastLengthMm && is_near(value)))
      refuse(cells_[*column_[kUncertainty]].begin,
             "u_mm = " + shortest(value) + ": no standard uncertainty", kLengthExpected);
    return value;
  }

  [[noreturn]] void refuse(std::size_t begin, const std::string& wrong,
                           const std::string& expected) const {
    const std::size_t column =
        std::min<std::size_t>(begin + mark_ + 1, std::numeric_limits<int>::max());
    throw InputError({shown_, line_, static_cast<int>(column)}, wrong, expected);
  }

  std::string_view rest_, text_;
  const std::string& shown_;
  int line_ = 0;
  std::size_t mark_ = 0;  ///< bytes of the first line that are no part of its text
  std::optional<char> separator_;
  std::vector<Cell> cells_;
  std::array<std::optional<std::size_t>, kMeanings> column_{};
  std::size_t columns_ = 0;
  MeasuredPoints out_;
};

}  // namespace

MeasuredPoints parse_measured_points(std::string_view text, const std::string& shown) {
  return PointsReader(text, shown).read();
}

MeasuredPoints read_measured_points(const std::filesystem::path& file) {
  return parse_measured_points(read_text_file(file), file.string());
}

}  // namespace limitgauge::model
