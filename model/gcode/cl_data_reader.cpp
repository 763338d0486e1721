#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/base/text_file.h"
#include "model/base/tolerance.h"
#include "model/gcode/cl_data.h"
#include "model/gcode/cl_lexer.h"
#include "model/gcode/cl_tool_axis.h"
#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

class ClReader {
 public:
  ClReader(const std::string& text, const std::string& name) : lexer_(text, name), name_(name) {}

  ClData read();

 private:
  void execute(const ClStatement& statement);
  bool describe(const ClStatement& statement);
  bool move(const ClStatement& statement);
  void set_units(const ClStatement& statement);
  void set_cutter(const ClStatement& statement);
  void require_cutter(const ClStatement& statement, const SevenFigures& figures) const;
  void set_feed(const ClStatement& statement);
  void go_to(const ClStatement& statement);
  void start_from(const ClStatement& statement);
  Vec3 point(const ClStatement& statement) const;
  std::vector<double> place_figures(const ClStatement& statement) const;
  void note_axis(const Vec3& axis);
  double number(const ClWord& word) const;
  double length(const ClWord& word) const;
  void require_count(const ClStatement& statement, std::size_t least, std::size_t most) const;

  ClLexer lexer_;
  const std::string& name_;
  ClData data_;
  double unit_mm_ = 1;
  double feed_mm_min_ = 0;
  bool rapid_ = false;
  ClToolAxis axis_;
};

/// "CUTTER/6,3".
std::string as_stated(const ClStatement& statement) {
  std::string text = statement.major.text;
  for (const ClWord& figure : statement.figures)
    text += (&figure == &statement.figures.front() ? "/" : ",") + figure.text;
  return text;
}

double ClReader::number(const ClWord& word) const {
  const std::optional<double> value = parse_number(word.text);
  if (!value) lexer_.fail(word, in_quotes(word.text) + " is not a number", "a number");
  return *value;
}

double ClReader::length(const ClWord& word) const {
  const double value = number(word) * unit_mm_;
  if (!(std::abs(value) <= kLargestCoordinateMm))
    lexer_.fail(word, "a length beyond any machine", "at most 1e9 mm");
  return value;
}

void ClReader::require_count(const ClStatement& statement, std::size_t least,
                             std::size_t most) const {
  const std::size_t count = statement.figures.size();
  if (count >= least && count <= most) return;
  lexer_.fail(statement.major, statement.major.text + " with " + std::to_string(count) + " figures",
              least == most ? std::to_string(least)
                            : std::to_string(least) + " to " + std::to_string(most));
}

void ClReader::set_units(const ClStatement& statement) {
  require_count(statement, 1, 1);
  const ClWord& word = statement.figures[0];
  if (word.text != "MM" && word.text != "INCHES")
    lexer_.fail(word, "unknown unit " + in_quotes(word.text), "MM or INCHES");
  unit_mm_ = word.text == "MM" ? 1 : kInchMm;
  data_.units_are_stated = true;
}

void ClReader::set_cutter(const ClStatement& statement) {
  const std::size_t count = statement.figures.size();
  if (count != 1 && count != 2 && count != 7)
    lexer_.fail(statement.major, "CUTTER with " + std::to_string(count) + " figures",
                "d, or d and r, or all of d,r,e,f,a,b,h");
  if (data_.cutter)
    lexer_.fail(statement.major, "a second cutter is not supported in this release",
                "one tool a program");
  std::array<double, 7> figures{};
  for (std::size_t i = 0; i < count; ++i) {
    const bool angle = i == 4 || i == 5;
    figures[i] = angle ? number(statement.figures[i]) : length(statement.figures[i]);
  }
  const auto& [d, r, e, f, a, b, h] = figures;
  data_.cutter = SevenFigures{d, r, e, f, a, b, h};
  data_.cutter_as_stated = as_stated(statement);
  data_.cutter_line = statement.major.line;
  // The short forms are cylinders; nothing is said of their height.
  if (count <= 2) data_.cutter->centre_radius = d / 2 - r, data_.cutter->centre_height = r;
  SevenFigures whole = *data_.cutter;
  if (count <= 2) whole.height = std::max(d, r);
  require_cutter(statement, whole);
}

void ClReader::require_cutter(const ClStatement& statement, const SevenFigures& figures) const {
  try {
    cutter_of(figures);
  } catch (const std::invalid_argument& problem) {
    lexer_.fail(statement.major, problem.what(), "figures that make a cutter");
  }
}

void ClReader::set_feed(const ClStatement& statement) {
  require_count(statement, 1, 2);
  double unit_mm = unit_mm_;
  const ClWord* figure = nullptr;
  for (const ClWord& word : statement.figures) {
    if (word.text == "MMPM")
      unit_mm = 1;
    else if (word.text == "IPM")
      unit_mm = kInchMm;
    else if (figure == nullptr)
      figure = &word;
    else
      lexer_.fail(word, "a second feed rate", "MMPM or IPM");
  }
  if (figure == nullptr)
    lexer_.fail(statement.major, "a feed rate without its number", "FEDRAT/500,MMPM");
  const double feed = number(*figure) * unit_mm;
  if (!(feed >= kLeastFeed_mm_min && feed <= kLargestFeed_mm_min))
    lexer_.fail(*figure, "feed rate " + in_quotes(figure->text),
                "at least 1e-6 and at most 1e9 mm/min");
  feed_mm_min_ = feed;
}

Vec3 ClReader::point(const ClStatement& statement) const {
  const std::vector<ClWord>& figures = statement.figures;
  if (figures.size() != 3 && figures.size() != 6)
    lexer_.fail(statement.major,
                statement.major.text + " with " + std::to_string(figures.size()) + " figures",
                "3, or 6 with a tool axis");
  return {length(figures[0]), length(figures[1]), length(figures[2])};
}

std::vector<double> ClReader::place_figures(const ClStatement& statement) const {
  std::vector<double> figures;
  for (const ClWord& word : statement.figures) figures.push_back(number(word));
  return figures;
}

/// Of the motion that was read last. Paths whose tool never turns have none.
void ClReader::note_axis(const Vec3& axis) {
  constexpr Vec3 kUpright{0, 0, 1};
  if (data_.axes.empty() && axis == kUpright && data_.from_axis.value_or(kUpright) == kUpright)
    return;
  data_.axes.resize(data_.moves.size(), kUpright);
  data_.axes.back() = axis;
  const bool turns = data_.axes.size() > 1
                         ? !(data_.axes[data_.axes.size() - 2] == axis)
                         : data_.from_axis.has_value() && !(*data_.from_axis == axis);
  if (turns && data_.turning_line == 0) data_.turning_line = data_.moves.back().line;
}

void ClReader::go_to(const ClStatement& statement) {
  const Vec3 to = point(statement);
  const Vec3 axis = axis_.go_to(statement, place_figures(statement), lexer_);
  const bool rapid = rapid_;
  rapid_ = false;
  if (!rapid && feed_mm_min_ == 0)
    lexer_.fail(statement.major, "a feed move without a feed rate", "FEDRAT or RAPID before it");
  data_.moves.emplace_back(to, rapid ? 0.0F : static_cast<float>(feed_mm_min_),
                           statement.major.line, rapid ? MoveKind::rapid : MoveKind::feed);
  note_axis(axis);
}

void ClReader::start_from(const ClStatement& statement) {
  if (data_.from || !data_.moves.empty())
    lexer_.fail(statement.major, "FROM behind a motion or another one", "it first");
  data_.from = point(statement);
  data_.from_axis = axis_.start_at(statement, place_figures(statement), lexer_);
  data_.from_as_stated = as_stated(statement);
  data_.from_line = statement.major.line;
}

/// Statements that say what the program is for.
bool ClReader::describe(const ClStatement& statement) {
  const std::string& major = statement.major.text;
  if (major == "PARTNO") return data_.part = statement.text, true;
  if (major == "UNITS") return set_units(statement), true;
  if (major == "CUTTER") return set_cutter(statement), true;
  if (major == "LOADTL") {
    require_count(statement, 1, 1);
    const double tool = number(statement.figures[0]);
    if (!(tool >= 0 && tool <= 1e9 && tool == std::floor(tool)))
      lexer_.fail(statement.figures[0], "tool number " + in_quotes(statement.figures[0].text),
                  "an integer from 0");
    if (data_.tool && *data_.tool != static_cast<int>(tool))
      lexer_.fail(statement.major, "a change to a second tool is not supported in this release",
                  "one tool a program");
    data_.tool = static_cast<int>(tool);
    data_.tool_line = statement.major.line;
    return true;
  }
  if (major == "SPINDL" || major == "COOLNT")
    return data_.ignored.push_back({statement.major.line, as_stated(statement)}), true;
  return major == "PPRINT" || major == "REMARK";
}

bool ClReader::move(const ClStatement& statement) {
  const std::string& major = statement.major.text;
  if (major == "RAPID") return require_count(statement, 0, 0), rapid_ = true;
  if (major == "FEDRAT") return set_feed(statement), true;
  if (major == "GOTO") return go_to(statement), true;
  if (major == "FROM") return start_from(statement), true;
  if (major == "MULTAX") return axis_.set_mode(statement, lexer_), true;
  return false;
}

void ClReader::execute(const ClStatement& statement) {
  if (describe(statement) || move(statement)) return;
  constexpr std::array<std::string_view, 14> kKnown = {
      "PARTNO", "PPRINT", "REMARK", "UNITS",  "CUTTER", "LOADTL", "SPINDL",
      "COOLNT", "FROM",   "RAPID",  "FEDRAT", "GOTO",   "MULTAX", "FINI"};
  const std::string near = meant_word(statement.major.text, kKnown);
  lexer_.fail(statement.major,
              in_quotes(statement.major.text) + " is not supported in this release",
              near.empty() ? "straight moves of one tool" : in_quotes(near));
}

ClData ClReader::read() {
  ClStatement statement;
  while (lexer_.next(statement)) {
    if (statement.major.text == "FINI") {
      require_count(statement, 0, 0);
      data_.kept_axis_line = axis_.kept_line();
      return std::move(data_);
    }
    execute(statement);
  }
  throw InputError({name_, static_cast<int>(lexer_.line()), 1},
                   "the program does not end; it may have been cut off", "FINI");
}

}  // namespace

ClData read_cl_data(const std::filesystem::path& path) {
  return ClReader(read_text_file(path), path.string()).read();
}

ClData read_cl_data(std::istream& in, const std::string& name_in_errors) {
  const std::string text = read_text(in, name_in_errors);
  return ClReader(text, name_in_errors).read();
}

}  // namespace limitgauge::model
