#pragma once

#include <string>
#include <string_view>

#include "reports/history/job_history.h"
#include "reports/text/text.h"

namespace limitgauge::reports::history_report {

/// How the figures of one column are written: lengths in one unit, so that they compare at a
/// glance.
class FigureColumn {
 public:
  FigureColumn(const JobHistory& job, std::size_t column);

  /// "finish gouge"; plain text.
  std::string title() const;
  /// "µm", "", "%".
  const std::string& unit() const { return unit_; }
  /// The figure without its unit: "[9.8, 12.8]", "86.3"; "–" where the run has none.
  std::string figure(const Cell& cell) const;
  /// Likewise the limit; empty where there is none.
  std::string limit(const Cell& cell) const;

 private:
  std::string number(double value) const;

  const Column* column_;
  LengthUnit length_;
  bool is_length_ = false;
  double factor_ = 1;
  std::string unit_;
};

/// "↑ worse", "↓ better", "=", "↑" where neither way is better, empty for a first one.
std::string trend(const Cell& cell);
/// The word alone: "better", "same", "worse", "higher", "lower", "new meaning", or empty.
const char* trend_word(const Cell& cell);

/// A hash in as many digits as tell it apart; any other name whole, up to 24 characters.
std::string short_commit(std::string_view commit);

/// "2026-11-22 01:37" of an ISO 8601 time.
std::string moment(std::string_view created);

}  // namespace limitgauge::reports::history_report
