#pragma once

#include <string>
#include <vector>

#include "reports/study/study_view.h"

/// Values of a study as people read them. What is "text" has still to be escaped for a page.
namespace limitgauge::reports::study_report {

/// A setting as text: `zigzag` for the TOML `"zigzag"`, all else as it is.
std::string setting_text(const study::Setting& setting);
/// "passed", "failed", "undecided", "error", "lost".
const char* word(study::Status status);
/// Class name that carries the status's colour.
const char* css_class(study::Status status);
/// The status as a coloured word with a sign that needs no colour.
std::string badge(study::Status status);

/// A figure's values in one unit, so that they can be compared at a glance.
class FigureColumn {
 public:
  FigureColumn(const study::Table& table, std::size_t figure);
  /// What the figure is, and the unit of its cells: "uncut, µm". Text.
  std::string title() const;
  /// Markup; "–" for a figure that is not there.
  std::string cell(const std::optional<double>& value) const;
  /// With its unit; markup.
  std::string value(double value) const;

 private:
  enum class Kind { length, duration, share, plain };
  const study::Figure& figure_;
  Kind kind_;
  double per_unit_ = 1;
  std::string unit_;
};

}  // namespace limitgauge::reports::study_report
