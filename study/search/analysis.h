#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "study/plan/plan.h"
#include "study/search/objectives.h"
#include "study/store/table.h"

namespace limitgauge::study {

/// Which of `points` (all of one dimension) no other one dominates, that is, is at most as large in
/// all coordinates and smaller in one. By rising coordinates, then by index; points that are alike
/// are all in or all out. Up to three coordinates take O(n log n), more of them O(n log n + n f)
/// for f points on the front.
std::vector<std::size_t> pareto_front(const std::vector<std::vector<double>>& points);

/// Rows that no other one with these figures beats: none is at least as small in every objective
/// (as large where it is to be large) and smaller in one. Whether a row passes plays no part.
struct Front {
  std::vector<std::string> objectives;  ///< ids of figures, the first is the one that is paid with
  std::vector<std::size_t> rows;        ///< into Table::rows, from the best first objective on
};

/// How one figure answers to one key. Where the design has rows that differ in that key alone,
/// these are the points, the others at the values of the reference case. Random and Latin hypercube
/// designs have none: there `fit` is the key's main effect, a parabola (or, of text, the means) by
/// least squares through all rows.
struct Response {
  std::size_t key = 0, figure = 0;  ///< into Table::keys and Table::figures
  struct Point {
    std::size_t row;
    double setting;  ///< the number, or the setting's place in the order of the design
    double value;
  };
  std::vector<Point> points;  ///< by rising setting; empty where the response is a fit
  struct CurvePoint {
    double setting, value;
  };
  std::vector<CurvePoint> fit;  ///< by rising setting; empty where there are points
  double change = 0;            ///< largest less smallest value, of the points or of the fit
  double elasticity = 0;        ///< d ln(value) / d ln(setting) by least squares; 0 where undefined
  bool has_elasticity = false;  ///< needs three points above zero
  /// Share of the variance of the figure over all rows that this key explains alone, from 0 to 1:
  /// of a grid the variance of the means, of random designs that of the fit, less what as many
  /// coefficients would explain of mere chance. Empty for other designs.
  std::optional<double> variance_share;
};

/// The keys by what they do to one figure.
struct Ranking {
  std::size_t figure = 0;              ///< into Table::figures
  std::vector<std::size_t> responses;  ///< into Analysis::responses, by falling change
};

/// A passing case that costs more than another passing one which is at least as accurate in
/// everything.
struct BoughtForNothing {
  std::size_t row = 0, by = 0;  ///< into Table::rows; `by` is the cheapest that beats it
  double dearer = 0;            ///< in the unit of the cost
};

/// The setting to take, with why.
struct Recommendation {
  std::optional<std::size_t> row;  ///< into Table::rows; empty where nothing passes
  std::string reason;              ///< whole sentences
};

struct Analysis {
  std::vector<Front> fronts;  ///< the cost against each accuracy, and against all of several
  std::vector<Response> responses;
  std::vector<Ranking> rankings;
  std::optional<std::size_t> own;                    ///< row with the job's own settings
  std::optional<std::size_t> reference;              ///< row that the responses go through
  std::vector<BoughtForNothing> bought_for_nothing;  ///< by row
  Recommendation recommendation;
  std::string search_ending;  ///< of a search: how it ended, whole sentences; not set by analyse()
};

/// The responses of `figures` (into Table::figures) to every key that shows one, key by key; those
/// that go through a row do so through `reference`.
std::vector<Response> responses(const Plan& plan, const Table& table,
                                const std::vector<std::size_t>& figures,
                                std::optional<std::size_t> reference);

/// For each of `figures` its responses by falling change; those alike by key.
std::vector<Ranking> rankings(const std::vector<Response>& all,
                              const std::vector<std::size_t>& figures);

/// The passing row of the least cost, the first of several.
std::optional<std::size_t> cheapest_passing(const Table& table, const Objectives& objectives);

/// Passing rows that cost more than a passing one which no accuracy of theirs beats.
std::vector<BoughtForNothing> bought_for_nothing(const Table& table, const Objectives& objectives);

/// The cheapest passing row with its reasons; where nothing passes, what comes nearest.
Recommendation recommend(const Table& table, const Objectives& objectives,
                         const Analysis& analysis);

/// All of it. Rows without a figure (of a stage that was not run) play no part where it is needed.
Analysis analyse(const Plan& plan, const Table& table);

}  // namespace limitgauge::study
