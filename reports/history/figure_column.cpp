#include "reports/history/figure_column.h"

#include <algorithm>
#include <cmath>

#include "model/text/number_text.h"
#include "reports/text/interval_text.h"

namespace limitgauge::reports::history_report {
namespace {

double largest(const JobHistory& job, std::size_t column) {
  double most = 0;
  for (const Run& run : job.runs)
    if (const auto& value = run.cells[column].value)
      most = std::max({most, std::abs(value->low), std::abs(value->high)});
  return most;
}

}  // namespace

FigureColumn::FigureColumn(const JobHistory& job, std::size_t column)
    : column_(&job.columns[column]), unit_(column_->unit) {
  is_length_ = unit_ == "mm";
  if (is_length_) {
    length_ = unit_for(largest(job, column));
    factor_ = length_.per_mm;
    unit_ = length_.symbol;
  } else if (column_->metric == "coverage") {
    factor_ = 100;
    unit_ = "%";
  }
}

std::string FigureColumn::title() const {
  const std::string stage = clean_text(column_->stage);
  return (stage.empty() ? std::string() : stage + " ") + clean_text(column_->label);
}

std::string FigureColumn::number(double value) const {
  const double shown = value * factor_;
  // Counts and times keep their whole part.
  return std::abs(shown) >= 1000 ? fixed(shown, 0) : three_digits(shown);
}

std::string FigureColumn::figure(const Cell& cell) const {
  if (!cell.value) return "–";
  if (column_->known != nullptr && column_->known->source == record::Source::certified)
    return interval_numbers(*cell.value, length_, cell.limit);
  if (unit_ == "%") return fixed(std::floor(cell.value->low * 1e4) / 100, 2);
  return number(cell.value->high);
}

std::string FigureColumn::limit(const Cell& cell) const {
  return cell.limit ? model::shortest(std::round(*cell.limit * factor_ * 1e9) / 1e9)
                    : std::string();
}

std::string trend(const Cell& cell) {
  const std::string word = trend_word(cell);
  if (word.empty() || cell.new_meaning) return word;
  if (word == "same") return "=";
  const std::string arrow = cell.direction > 0 ? "↑" : "↓";
  return word == "higher" || word == "lower" ? arrow : arrow + " " + word;
}

const char* trend_word(const Cell& cell) {
  if (cell.new_meaning) return "new meaning";
  using compare::Judgement;
  switch (cell.judgement.value_or(Judgement::not_judged)) {
    case Judgement::better:
      return "better";
    case Judgement::worse:
      return "worse";
    case Judgement::same:
      return "same";
    case Judgement::not_judged:
      break;
  }
  return cell.direction > 0 ? "higher" : cell.direction < 0 ? "lower" : "";
}

std::string short_commit(std::string_view commit) {
  constexpr std::size_t kDigits = 10, kCharacters = 24;
  const bool is_hash = commit.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
  return is_hash ? std::string(commit.substr(0, kDigits)) : shortened(commit, kCharacters);
}

std::string moment(std::string_view created) {
  std::string text = clean_text(created.substr(0, 16));
  std::replace(text.begin(), text.end(), 'T', ' ');
  return text;
}

}  // namespace limitgauge::reports::history_report
