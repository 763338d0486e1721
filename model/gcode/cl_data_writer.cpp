#include <cmath>
#include <stdexcept>
#include <vector>

#include "model/base/tolerance.h"
#include "model/gcode/cl_data.h"
#include "model/text/fixed_number.h"
#include "model/text/number_text.h"
#include "model/text/text_blocks.h"

namespace limitgauge::model {
namespace {

constexpr int kMostDecimals = 9;
constexpr std::size_t kColumns = 72;

void require_cl_writable(const Toolpath& path, const ClOptions& options) {
  if (options.decimals < 0 || options.decimals > kMostDecimals)
    throw std::invalid_argument("CL data are written with 0 to 9 decimals");
  if (options.tool_number < 0) throw std::invalid_argument("tool number must not be negative");
  const auto require_point = [](const Vec3& point) {
    for (const int axis : {0, 1, 2}) {
      if (!(std::abs(point[axis]) <= kLargestCoordinateMm))
        throw std::invalid_argument("a toolpath point is not finite or beyond any machine");
    }
  };
  require_point(path.start);
  for (const Move& move : path.moves) {
    require_point(move.to);
    if (move.kind == MoveKind::feed &&
        !(move.feed_mm_min >= static_cast<float>(kLeastFeed_mm_min) &&
          move.feed_mm_min <= static_cast<float>(kLargestFeed_mm_min)))
      throw std::invalid_argument("a feed move's feed rate must lie between 1e-6 and 1e9 mm/min");
  }
}

/// `WORD/A,B,C`, continued by `$` before a figure that would not fit the line.
void write_statement(const std::string& word, const std::vector<std::string>& figures,
                     TextBlocks& text) {
  std::string line = word + "/";
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const std::string figure = figures[i] + (i + 1 < figures.size() ? "," : "");
    if (line.size() + figure.size() + 1 > kColumns) text.line(line + "$"), line.clear();
    line += figure;
  }
  text.line(line);
}

std::vector<std::string> cutter_figures(const Cutter& cutter) {
  const SevenFigures c = seven_figures(cutter);
  std::vector<double> figures = {c.diameter,    c.corner_radius, c.centre_radius, c.centre_height,
                                 c.lower_angle, c.upper_angle,   c.height};
  // A cylinder needs no more than its corner.
  if (cutter.type == CutterType::flat) figures.resize(1);
  if (cutter.type == CutterType::ball || cutter.type == CutterType::bull) figures.resize(2);
  std::vector<std::string> texts;
  for (const double figure : figures) texts.push_back(shortest(figure));
  return texts;
}

std::string part_line(const std::string& part) {
  constexpr std::string_view kWord = "PARTNO ";
  std::string line(kWord);
  for (const char c : part) {
    // `$` would continue the line.
    line += c >= ' ' && c <= '~' && c != '$' ? c : ' ';
    if (line.size() == kColumns) break;
  }
  return line;
}

void write_figures(const Vec3& figures, int decimals, TextBlocks& text) {
  for (const int axis : {0, 1, 2}) {
    if (axis > 0) text.append(",");
    text.append(fixed(figures[axis], decimals).text());
  }
}

/// An axis stands in a line of its own.
void write_point(const char* word, const Vec3& point, const Vec3* axis, int decimals,
                 TextBlocks& text) {
  text.append(word);
  write_figures(point, decimals, text);
  if (axis) {
    text.line(",$");
    text.append(" ");
    write_figures(*axis, kMostDecimals, text);
  }
  text.end_line();
}

}  // namespace

void write_cl_data(const Toolpath& path, const Cutter& cutter, const ClOptions& options,
                   std::ostream& out, const ToolAxes* axes) {
  require_cl_writable(path, options);
  if (axes) require_axes(path, *axes);
  TextBlocks text(out);
  if (!options.part.empty()) text.line(part_line(options.part));
  text.line("UNITS/MM");
  write_statement("CUTTER", cutter_figures(cutter), text);
  write_statement("LOADTL", {std::to_string(options.tool_number)}, text);
  if (axes) text.line("MULTAX/ON");
  write_point("FROM/", path.start, axes ? &axes->start : nullptr, options.decimals, text);
  float feed_mm_min = 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    if (move.kind == MoveKind::rapid) {
      text.line("RAPID");
    } else if (move.feed_mm_min != feed_mm_min) {
      feed_mm_min = move.feed_mm_min;
      text.line("FEDRAT/" + feed_text(feed_mm_min) + ",MMPM");
    }
    write_point("GOTO/", move.to, axes ? &axes->to[i] : nullptr, options.decimals, text);
  }
  text.line("FINI");
  text.flush();
}

}  // namespace limitgauge::model
