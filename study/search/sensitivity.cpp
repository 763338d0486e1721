#include "study/search/analysis.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "study/plan/reference.h"
#include "study/search/least_squares.h"
#include "study/search/objectives.h"
#include "study/tolerance.h"

namespace limitgauge::study {
namespace {

/// One key as a column: a number for each row, and which rows have the same setting.
struct Column {
  std::vector<double> settings;    ///< the number, or the place in the order of the design
  std::vector<std::size_t> level;  ///< of the row's setting among the different ones
  std::size_t levels = 0;
  bool numeric = true;
  bool logarithmic = false;
};

Column column_of(const Plan& plan, const Table& table, std::size_t key) {
  Column column;
  const Variable& variable = plan.variables[key];
  column.logarithmic = variable.range && variable.range->logarithmic;
  std::map<std::string, std::size_t> levels;
  for (const Setting& setting : variable.values) levels.emplace(setting.toml, levels.size());
  for (const Row& row : table.rows) {
    const Setting& setting = row.asked.settings[key];
    column.level.push_back(levels.emplace(setting.toml, levels.size()).first->second);
    column.numeric = column.numeric && setting.number;
  }
  column.levels = levels.size();
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    column.settings.push_back(column.numeric ? *table.rows[i].asked.settings[key].number
                                             : static_cast<double>(column.level[i]));
  return column;
}

/// Rows that differ from the reference in one key at most: by key; the reference is with all.
std::vector<std::vector<std::size_t>> rows_along(const Table& table, std::size_t reference) {
  std::vector<std::vector<std::size_t>> along(table.keys.size());
  const std::vector<Setting>& base = table.rows[reference].asked.settings;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    std::vector<std::size_t> others;
    for (std::size_t k = 0; k < base.size() && others.size() < 2; ++k)
      if (!alike(base[k], table.rows[i].asked.settings[k])) others.push_back(k);
    if (others.size() == 1) along[others.front()].push_back(i);
    if (others.empty())
      for (std::vector<std::size_t>& rows : along) rows.push_back(i);
  }
  return along;
}

/// The rows that have the figure: settings, values and levels.
struct Known {
  Pairs pairs;
  std::vector<std::size_t> rows, level;
};

Known known(const Table& table, const Column& column, std::size_t figure,
            const std::vector<std::size_t>& rows) {
  Known found;
  for (const std::size_t i : rows) {
    const std::optional<std::vector<double>> value = figures_of(table.rows[i], {figure});
    if (!value) continue;
    found.pairs.x.push_back(column.settings[i]);
    found.pairs.y.push_back(value->front());
    found.rows.push_back(i);
    found.level.push_back(column.level[i]);
  }
  return found;
}

double spread(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

void add_elasticity(Response& response, const Column& column, const Pairs& pairs) {
  if (!column.numeric) return;
  const std::optional<double> found = elasticity(pairs);
  response.has_elasticity = found.has_value();
  response.elasticity = found.value_or(0);
}

std::optional<Response> response_along(const Column& column, const Known& found) {
  if (distinct(found.pairs.x) < 2) return std::nullopt;
  Response response;
  for (std::size_t i = 0; i < found.rows.size(); ++i)
    response.points.push_back({found.rows[i], found.pairs.x[i], found.pairs.y[i]});
  std::stable_sort(response.points.begin(), response.points.end(),
                   [](const auto& a, const auto& b) { return a.setting < b.setting; });
  response.change = spread(found.pairs.y);
  add_elasticity(response, column, found.pairs);
  return response;
}

/// The mean figure of the rows of each setting, with how many they are.
struct Means {
  std::vector<double> mean, count;
};

Means means_of(const Known& found, std::size_t levels) {
  Means means{std::vector<double>(levels), std::vector<double>(levels)};
  for (std::size_t i = 0; i < found.rows.size(); ++i) {
    means.mean[found.level[i]] += found.pairs.y[i];
    means.count[found.level[i]] += 1;
  }
  for (std::size_t l = 0; l < levels; ++l)
    if (means.count[l] > 0) means.mean[l] /= means.count[l];
  return means;
}

/// Sum of squares that is left when every row is taken for the mean of its setting.
double squares_about_means(const Known& found, const Means& means) {
  double sum = 0;
  for (std::size_t i = 0; i < found.rows.size(); ++i) {
    const double off = found.pairs.y[i] - means.mean[found.level[i]];
    sum += off * off;
  }
  return sum;
}

/// Zero where the figures are alike but for rounding: there is nothing to have a share in.
double variation(const std::vector<double>& values) {
  const double largest = std::accumulate(values.begin(), values.end(), 0.0, [](double a, double b) {
    return std::max(a, std::abs(b));
  });
  return spread(values) > kNoSpread * largest ? squares_about_mean(values) : 0;
}

std::optional<double> share_of_means(const Known& found, std::size_t levels) {
  const double all = variation(found.pairs.y);
  if (!(all > 0)) return std::nullopt;
  const double left = squares_about_means(found, means_of(found, levels));
  return std::clamp(1 - left / all, 0.0, 1.0);
}

/// What is left after a fit, held against what was there, both for each degree of freedom.
std::optional<double> share_of_fit(double left, std::size_t coefficients, const Pairs& pairs) {
  const double all = variation(pairs.y);
  const auto n = static_cast<double>(pairs.y.size());
  const double freedom = n - static_cast<double>(coefficients);
  if (!(all > 0) || freedom < 1) return std::nullopt;
  return std::clamp(1 - (left / freedom) / (all / (n - 1)), 0.0, 1.0);
}

constexpr std::size_t kCurvePoints = 21;

std::optional<Response> parabola_of(const Column& column, const Known& found) {
  Pairs scaled = found.pairs;
  const auto scale = [&](double x) { return column.logarithmic ? std::log(x) : x; };
  for (double& x : scaled.x) x = scale(x);
  const std::optional<Parabola> fit = Parabola::through(scaled);
  if (!fit) return std::nullopt;
  Response response;
  double left = 0;
  for (std::size_t i = 0; i < scaled.x.size(); ++i) {
    const double off = scaled.y[i] - fit->at(scaled.x[i]);
    left += off * off;
  }
  response.variance_share = share_of_fit(left, fit->coefficients(), scaled);
  const auto [low, high] = std::minmax_element(scaled.x.begin(), scaled.x.end());
  for (std::size_t i = 0; i < kCurvePoints; ++i) {
    const double part = static_cast<double>(i) / (kCurvePoints - 1);
    const double x = *low + (*high - *low) * part;
    response.fit.push_back({column.logarithmic ? std::exp(x) : x, fit->at(x)});
  }
  return response;
}

std::optional<Response> means_response(const Column& column, const Known& found) {
  const Means means = means_of(found, column.levels);
  Response response;
  for (std::size_t l = 0; l < column.levels; ++l)
    if (means.count[l] > 0) response.fit.push_back({static_cast<double>(l), means.mean[l]});
  if (response.fit.size() < 2) return std::nullopt;
  response.variance_share =
      share_of_fit(squares_about_means(found, means), response.fit.size(), found.pairs);
  return response;
}

std::optional<Response> main_effect(const Column& column, const Known& found) {
  std::optional<Response> response =
      column.numeric ? parabola_of(column, found) : means_response(column, found);
  if (!response) return std::nullopt;
  std::vector<double> values;
  for (const Response::CurvePoint& point : response->fit) values.push_back(point.value);
  response->change = spread(values);
  add_elasticity(*response, column, found.pairs);
  return response;
}

std::vector<std::size_t> all_rows(const Table& table) {
  std::vector<std::size_t> rows(table.rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
  return rows;
}

}  // namespace

std::vector<Response> responses(const Plan& plan, const Table& table,
                                const std::vector<std::size_t>& figures,
                                std::optional<std::size_t> reference) {
  const bool drawn = plan.method == Method::random || plan.method == Method::latin_hypercube;
  std::vector<Response> all;
  if (!drawn && !reference) return all;
  const std::vector<std::size_t> rows = all_rows(table);
  std::vector<std::vector<std::size_t>> along;
  if (!drawn) along = rows_along(table, *reference);
  for (std::size_t key = 0; key < table.keys.size(); ++key) {
    const Column column = column_of(plan, table, key);
    for (const std::size_t figure : figures) {
      std::optional<Response> response =
          drawn ? main_effect(column, known(table, column, figure, rows))
                : response_along(column, known(table, column, figure, along[key]));
      if (!response) continue;
      response->key = key;
      response->figure = figure;
      if (plan.method == Method::grid)
        response->variance_share =
            share_of_means(known(table, column, figure, rows), column.levels);
      all.push_back(std::move(*response));
    }
  }
  return all;
}

std::vector<Ranking> rankings(const std::vector<Response>& all,
                              const std::vector<std::size_t>& figures) {
  std::vector<Ranking> ranked;
  for (const std::size_t figure : figures) {
    Ranking ranking{figure, {}};
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].figure == figure) ranking.responses.push_back(i);
    std::stable_sort(ranking.responses.begin(), ranking.responses.end(),
                     [&](std::size_t a, std::size_t b) { return all[a].change > all[b].change; });
    if (!ranking.responses.empty()) ranked.push_back(std::move(ranking));
  }
  return ranked;
}

}  // namespace limitgauge::study
