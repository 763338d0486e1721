#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "reports/json/values.h"
#include "reports/study/figure_column.h"
#include "reports/study/parts.h"
#include "reports/text/text.h"

namespace limitgauge::reports::study_report {
namespace {

using json::finite;
using json::Json;

/// Texts that come up again and again, each once, and which of them each row has.
class Dictionary {
 public:
  /// `entry` is what is kept of a text that was not there yet.
  void add(const std::string& text, Json entry) {
    const auto [found, is_new] = at_.try_emplace(text, entries_.size());
    if (is_new) entries_.push_back(std::move(entry));
    of_.push_back(found->second);
  }
  const Json& entries() const { return entries_; }
  const Json& of() const { return of_; }

 private:
  std::map<std::string, std::size_t> at_;
  Json entries_ = Json::array(), of_ = Json::array();
};

Json key_json(const study::Table& table, std::size_t key) {
  Dictionary settings;
  for (const study::Row& row : table.rows) {
    const study::Setting& setting = row.asked.settings.at(key);
    settings.add(setting.toml,
                 {clean_text(setting_text(setting)),
                  setting.number ? Json(finite(table.keys[key], *setting.number)) : Json()});
  }
  return {{"key", clean_text(table.keys[key])},
          {"settings", settings.entries()},
          {"of", settings.of()}};
}

/// Seven digits: what no chart and no cell shows would be half of the page.
double drawn(double value) {
  return std::strtod(fmt::format("{:.7g}", value).c_str(), nullptr);
}

Json figure_json(const study::Table& table, std::size_t figure) {
  const study::Figure& what = table.figures[figure];
  Json values = Json::array();
  for (const study::Row& row : table.rows) {
    const std::optional<double>& value = row.figures.at(figure);
    values.push_back(value ? Json(drawn(finite(what.id, *value))) : Json());
  }
  Json out = {{"id", clean_text(what.id)},
              {"label", clean_text(what.label)},
              {"unit", clean_text(what.unit)},
              {"values", std::move(values)}};
  if (what.larger_is_better) out["better"] = "higher";
  return out;
}

Json statuses_json(const study::Table& table) {
  Json out = Json::array();
  for (const study::Row& row : table.rows)
    out.push_back(std::find(kStatuses.begin(), kStatuses.end(), row.status) - kStatuses.begin());
  return out;
}

Json reasons_json(const study::Table& table) {
  Dictionary reasons;
  for (const study::Row& row : table.rows) reasons.add(row.reason, clean_text(row.reason));
  return {{"texts", reasons.entries()}, {"of", reasons.of()}};
}

/// Numbers of cases, by which their results are found.
Json numbers_json(const study::Table& table) {
  Json out = Json::array();
  for (const study::Row& row : table.rows) out.push_back(row.asked.index);
  return out;
}

Json responses_json(const study::Analysis& analysis) {
  Json out = Json::array();
  for (const study::Response& response : analysis.responses) {
    Json rows = Json::array();
    for (const study::Response::Point& point : response.points) rows.push_back(point.row);
    Json fit = Json::array();
    for (const study::Response::CurvePoint& point : response.fit)
      fit.push_back({finite("setting", point.setting), finite("value", point.value)});
    out.push_back({{"key", response.key},
                   {"figure", response.figure},
                   {"rows", std::move(rows)},
                   {"fit", std::move(fit)}});
  }
  return out;
}

Json page_fronts(const StudyView& view) {
  Json out = Json::array();
  for (const study::Front& front : view.analysis.fronts) {
    Json figures = Json::array();
    for (const std::string& id : front.objectives)
      if (const auto figure = figure_index(view.table, id)) figures.push_back(*figure);
    out.push_back({{"figures", std::move(figures)}, {"rows", front.rows}});
  }
  return out;
}

Json optional_json(const std::optional<std::size_t>& row) {
  return row ? Json(*row) : Json();
}

}  // namespace

std::string page_data(const StudyView& view) {
  const study::Table& table = view.table;
  Json keys = Json::array(), figures = Json::array();
  for (std::size_t i = 0; i < table.keys.size(); ++i) keys.push_back(key_json(table, i));
  for (std::size_t i = 0; i < table.figures.size(); ++i) figures.push_back(figure_json(table, i));
  return Json{{"format", "limitgauge.study-page/1"},
              {"cases", numbers_json(table)},
              {"status", statuses_json(table)},
              {"reasons", reasons_json(table)},
              {"keys", std::move(keys)},
              {"figures", std::move(figures)},
              {"objectives", objectives(view)},
              {"fronts", page_fronts(view)},
              {"responses", responses_json(view.analysis)},
              {"recommended", optional_json(view.analysis.recommendation.row)},
              {"own", optional_json(own_row(view))}}
      .dump();
}

}  // namespace limitgauge::reports::study_report
