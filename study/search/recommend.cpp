#include "study/search/analysis.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "study/search/phrases.h"
#include "study/store/table.h"

namespace limitgauge::study {
namespace {

std::string case_text(const Row& row) {
  return "case " + std::to_string(row.asked.index);
}

std::size_t count(const Table& table, Status status) {
  return static_cast<std::size_t>(std::count_if(
      table.rows.begin(), table.rows.end(), [&](const Row& row) { return row.status == status; }));
}

/// What a sentence about a table needs at hand.
struct Told {
  const Table& table;
  const Objectives& objectives;

  const Figure& paid() const { return table.figures[*objectives.cost]; }
  /// As it is to be small.
  double cost(const Row& row) const {
    return to_be_small(paid(), *figure_of(row, *objectives.cost));
  }
  std::string cost_text(const Row& row) const {
    return quantity(*figure_of(row, *objectives.cost), paid().unit);
  }
  /// One word of a cost, the other of what is to be large.
  const char* either(const char* of_cost, const char* of_gain) const {
    return paid().larger_is_better ? of_gain : of_cost;
  }
  /// True where no stage of the row is missing, so that its cost is that of the whole job.
  bool is_whole(const Row& row) const {
    return figure_of(row, *objectives.cost) && figures_of(row, objectives.accuracy);
  }
};

std::string verb(const Row& row) {
  return row.status == Status::indeterminate ? "cannot be decided" : "fails";
}

std::string why(const Row& row) {
  return row.reason.empty() ? "" : ": " + row.reason;
}

/// ", its certified uncut 41 µm, its ..." of the figures that were to be bought.
std::string accuracy_text(const Told& told, const Row& row) {
  std::string text;
  for (const std::size_t figure : told.objectives.accuracy) {
    const std::optional<double> value = figure_of(row, figure);
    const Figure& told_of = told.table.figures[figure];
    if (value)
      text += (text.empty() ? "" : ", ") + told_of.label + " " + quantity(*value, told_of.unit);
  }
  return text.empty() ? text : " (" + text + ")";
}

std::string first_sentence(const Told& told, const Row& best) {
  const std::size_t passing = count(told.table, Status::pass);
  const std::string which =
      passing == 1
          ? "the only one of " + counted(told.table.rows.size(), "case") + " that passes every gate"
          : std::string("the ") + told.either("cheapest", "best") + " of the " +
                std::to_string(passing) + " cases that pass every gate, of " +
                std::to_string(told.table.rows.size()) + " in all";
  return "Case " + std::to_string(best.asked.index) + " is " + which + ": " +
         told.table.figures[*told.objectives.cost].label + " " + told.cost_text(best) +
         accuracy_text(told, best) + ".";
}

std::string against_own(const Told& told, const Row& best, const Row& own) {
  if (&own == &best) return " These are the job's own settings.";
  const std::string name = "the job's own settings (" + case_text(own);
  if (own.status != Status::pass)
    return has_result(own) ? " With " + name + ") it " + verb(own) + why(own) + "."
                           : " With " + name + ") there is no result" + why(own) + ".";
  if (!figure_of(own, *told.objectives.cost)) return {};
  const double saved = told.cost(own) - told.cost(best);
  const double whole = std::abs(told.cost(own)), share = whole > 0 ? saved / whole : 0;
  return saved > 0 ? " That is " + percent(share) + told.either(" below ", " above ") + name +
                         ", " + told.cost_text(own) + ")."
                   : " That is as much as with " + name + ").";
}

/// The dearest of what is cheaper, as far as it went through all stages.
const Row* next_cheaper(const Told& told, const Row& best) {
  const Row* next = nullptr;
  for (const Row& row : told.table.rows) {
    if (row.status == Status::pass || !told.is_whole(row) || told.cost(row) >= told.cost(best))
      continue;
    if (next == nullptr || told.cost(row) > told.cost(*next)) next = &row;
  }
  return next;
}

std::string against_cheaper(const Told& told, const Row& best) {
  const Row* next = next_cheaper(told, best);
  const std::string better = told.either("cheaper", "better");
  if (next == nullptr) return " No case that went through all stages is " + better + ".";
  return " The next " + better + " one, " + case_text(*next) + " (" + told.cost_text(*next) +
         "), " + verb(*next) + why(*next) + accuracy_text(told, *next) + ".";
}

std::string waste_text(const Told& told, const Analysis& analysis) {
  const std::size_t wasted = analysis.bought_for_nothing.size();
  if (wasted == 0) return {};
  const std::string what = told.either(wasted == 1 ? " costs more" : " cost more",
                                       wasted == 1 ? " has less" : " have less");
  return " " + counted(wasted, "passing case") + what +
         " than another one that is at least as accurate.";
}

std::string missing_text(const Table& table) {
  const std::size_t errors = count(table, Status::error), lost = count(table, Status::lost);
  std::string text;
  if (errors > 0) text += " " + counted(errors, "case") + " ended with an error.";
  if (lost > 0) text += " " + counted(lost, "case") + " did not come back.";
  return text;
}

/// The row whose certified figures come nearest to the limits.
const Row* nearest_to_passing(const Table& table, std::size_t excess) {
  const Row* nearest = nullptr;
  for (const Row& row : table.rows) {
    if (!has_result(row) || !figure_of(row, excess)) continue;
    if (nearest == nullptr || *figure_of(row, excess) < *figure_of(*nearest, excess))
      nearest = &row;
  }
  return nearest;
}

std::string nothing_passes(const Table& table) {
  const std::size_t failed = count(table, Status::fail),
                    undecided = count(table, Status::indeterminate);
  std::string text = "None of " + counted(table.rows.size(), "case") +
                     " passes every gate: " + std::to_string(failed) +
                     (failed == 1 ? " fails, " : " fail, ") + std::to_string(undecided) +
                     " cannot be decided.";
  const std::optional<std::size_t> excess = figure_index(table, "gate_excess");
  const Row* nearest = excess ? nearest_to_passing(table, *excess) : nullptr;
  if (nearest != nullptr)
    text += " Nearest comes " + case_text(*nearest) + ", " +
            percent(*figure_of(*nearest, *excess)) + " over a limit" + why(*nearest) + ".";
  return text + missing_text(table);
}

}  // namespace

std::optional<std::size_t> cheapest_passing(const Table& table, const Objectives& objectives) {
  if (!objectives.cost) return std::nullopt;
  const Told told{table, objectives};
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Row& row = table.rows[i];
    if (row.status != Status::pass || !figure_of(row, *objectives.cost)) continue;
    if (!best || told.cost(row) < told.cost(table.rows[*best])) best = i;
  }
  return best;
}

std::vector<BoughtForNothing> bought_for_nothing(const Table& table, const Objectives& objectives) {
  std::vector<BoughtForNothing> found;
  if (!objectives.cost || objectives.accuracy.empty()) return found;
  std::vector<std::size_t> figures = {*objectives.cost};
  figures.insert(figures.end(), objectives.accuracy.begin(), objectives.accuracy.end());
  std::vector<std::size_t> rows;
  std::vector<std::vector<double>> points;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    std::optional<std::vector<double>> point = to_be_small(table, table.rows[i], figures);
    if (table.rows[i].status != Status::pass || !point) continue;
    rows.push_back(i);
    points.push_back(std::move(*point));
  }
  const std::vector<std::size_t> front = pareto_front(points);
  const std::set<std::size_t> on_front(front.begin(), front.end());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (on_front.count(i) > 0) continue;
    const auto beats = [&](std::size_t f) {
      return points[f][0] < points[i][0] &&
             std::equal(points[f].begin() + 1, points[f].end(), points[i].begin() + 1,
                        [](double a, double b) { return a <= b; });
    };
    const auto by = std::find_if(front.begin(), front.end(), beats);
    if (by != front.end()) found.push_back({rows[i], rows[*by], points[i][0] - points[*by][0]});
  }
  return found;
}

Recommendation recommend(const Table& table, const Objectives& objectives,
                         const Analysis& analysis) {
  const std::optional<std::size_t> best = cheapest_passing(table, objectives);
  if (!best) return {std::nullopt, nothing_passes(table)};
  const Told told{table, objectives};
  const Row& row = table.rows[*best];
  std::string reason = first_sentence(told, row);
  if (analysis.own) reason += against_own(told, row, table.rows[*analysis.own]);
  reason += against_cheaper(told, row) + waste_text(told, analysis) + missing_text(table);
  return {best, std::move(reason)};
}

}  // namespace limitgauge::study
