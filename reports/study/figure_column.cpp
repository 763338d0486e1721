#include "reports/study/figure_column.h"

#include <algorithm>
#include <cmath>

#include "reports/html/markup.h"
#include "reports/text/text.h"

namespace limitgauge::reports::study_report {
namespace {

using study::Status;

double largest(const study::Table& table, std::size_t figure) {
  double most = 0;
  for (const study::Row& row : table.rows)
    if (const auto& value = row.figures.at(figure)) most = std::max(most, std::abs(*value));
  return most;
}

const char* sign(Status status) {
  switch (status) {
    case Status::pass:
      return "✓";
    case Status::fail:
      return "✕";
    case Status::indeterminate:
      return "?";
    case Status::error:
      return "!";
    case Status::lost:
      break;
  }
  return "–";
}

}  // namespace

std::string setting_text(const study::Setting& setting) {
  const std::string& toml = setting.toml;
  const bool quoted = toml.size() >= 2 && (toml.front() == '"' || toml.front() == '\'') &&
                      toml.back() == toml.front();
  if (!quoted) return toml;
  const std::string inner = toml.substr(1, toml.size() - 2);
  return inner.find_first_of("\"'\\") == std::string::npos ? inner : toml;
}

const char* word(Status status) {
  switch (status) {
    case Status::pass:
      return "passed";
    case Status::fail:
      return "failed";
    case Status::indeterminate:
      return "undecided";
    case Status::error:
      return "error";
    case Status::lost:
      break;
  }
  return "lost";
}

const char* css_class(Status status) {
  if (status == Status::pass) return "pass";
  if (status == Status::fail) return "fail";
  return status == Status::indeterminate ? "open" : "none";
}

std::string badge(Status status) {
  return html::badge(css_class(status), sign(status), word(status));
}

FigureColumn::FigureColumn(const study::Table& table, std::size_t figure)
    : figure_(table.figures.at(figure)), kind_(Kind::plain), unit_(figure_.unit) {
  if (figure_.unit == "mm") {
    kind_ = Kind::length;
    const LengthUnit unit = unit_for(largest(table, figure));
    per_unit_ = unit.per_mm;
    unit_ = unit.symbol;
  } else if (figure_.unit == "s") {
    kind_ = Kind::duration;
    unit_.clear();
  } else if (figure_.id == "coverage" || figure_.id.ends_with(".coverage")) {
    kind_ = Kind::share;
    unit_.clear();
  }
}

std::string FigureColumn::title() const {
  return unit_.empty() ? figure_.label : figure_.label + ", " + unit_;
}

std::string FigureColumn::cell(const std::optional<double>& value) const {
  if (!value) return "–";
  if (kind_ == Kind::duration) return duration_text(*value);
  if (kind_ == Kind::share) return percent_text(*value);
  const double shown = *value * per_unit_;
  // A count keeps all its digits.
  if (kind_ == Kind::plain && shown == std::round(shown) && std::abs(shown) < 1e15)
    return html::typeset(fixed(shown, 0));
  return html::typeset(three_digits(shown));
}

std::string FigureColumn::value(double value) const {
  return unit_.empty() ? cell(value) : cell(value) + " " + escape_markup(unit_);
}

}  // namespace limitgauge::reports::study_report
