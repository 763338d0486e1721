#include <ostream>

#include "reports/json/values.h"
#include "reports/study/study_view.h"
#include "reports/text/text.h"

namespace limitgauge::reports::study_report {
namespace {

using json::finite;
using json::Json;
using json::texts;

Json setting_json(const study::Setting& setting) {
  Json out = {{"toml", clean_text(setting.toml)}};
  if (setting.number) out["number"] = finite("setting", *setting.number);
  return out;
}

Json settings_json(const std::vector<study::Setting>& settings) {
  Json out = Json::array();
  for (const study::Setting& setting : settings) out.push_back(setting_json(setting));
  return out;
}

Json variable_json(const study::Variable& variable) {
  Json out = {{"key", clean_text(variable.key)}, {"values", settings_json(variable.values)}};
  if (const auto& range = variable.range)
    out["range"] = {{"low", finite("range", range->low)},
                    {"high", finite("range", range->high)},
                    {"steps", range->steps},
                    {"logarithmic", range->logarithmic}};
  return out;
}

Json plan_json(const study::Plan& plan) {
  Json out = {{"method", study::name(plan.method)}, {"variables", Json::array()}};
  for (const study::Variable& variable : plan.variables)
    out["variables"].push_back(variable_json(variable));
  out["samples"] = plan.samples;
  out["seed"] = plan.seed;
  if (plan.method == study::Method::search)
    out["search"] = {{"cost", clean_text(plan.search.cost)},
                     {"most_cases", plan.search.most_cases},
                     {"accuracy", finite("search accuracy", plan.search.accuracy)},
                     {"batch", plan.search.batch}};
  if (plan.search.largest) out["search"]["largest"] = clean_text(*plan.search.largest);
  out["cost"] = clean_text(plan.cost);
  out["accuracy"] = texts(plan.accuracy);
  return out;
}

Json figures_json(const study::Table& table) {
  Json out = Json::array();
  for (const study::Figure& figure : table.figures) {
    Json& entry = out.emplace_back(Json{{"id", clean_text(figure.id)},
                                        {"label", clean_text(figure.label)},
                                        {"unit", clean_text(figure.unit)}});
    if (figure.larger_is_better) entry["better"] = "higher";
  }
  return out;
}

Json counts_json(const study::Table& table) {
  Json out = Json::object();
  for (const study::Status status : kStatuses) out[study::name(status)] = count(table, status);
  return out;
}

Json case_json(const study::Table& table, const study::Row& row) {
  Json out = {{"case", row.asked.index},          {"status", study::name(row.status)},
              {"reason", clean_text(row.reason)}, {"settings", settings_json(row.asked.settings)},
              {"figures", Json::array()},         {"key", clean_text(row.key)}};
  for (std::size_t i = 0; i < table.figures.size(); ++i) {
    const std::optional<double>& value = row.figures.at(i);
    out["figures"].push_back(value ? Json(finite(table.figures[i].id, *value)) : Json());
  }
  if (has_result(row)) out["result"] = result_path(row.asked.index);
  return out;
}

Json cases_json(const study::Table& table) {
  Json out = Json::array();
  for (const study::Row& row : table.rows) out.push_back(case_json(table, row));
  return out;
}

std::size_t case_of(const study::Table& table, std::size_t row) {
  return table.rows.at(row).asked.index;
}

Json fronts_json(const StudyView& view) {
  Json out = Json::array();
  for (const study::Front& front : view.analysis.fronts) {
    Json cases = Json::array();
    for (const std::size_t row : front.rows) cases.push_back(case_of(view.table, row));
    out.push_back({{"objectives", texts(front.objectives)}, {"cases", std::move(cases)}});
  }
  return out;
}

Json fit_json(const study::Response& response) {
  Json out = Json::array();
  for (const study::Response::CurvePoint& point : response.fit)
    out.push_back(
        {{"setting", finite("setting", point.setting)}, {"value", finite("value", point.value)}});
  return out;
}

Json response_json(const StudyView& view, const study::Response& response) {
  Json points = Json::array();
  for (const study::Response::Point& point : response.points)
    points.push_back({{"case", case_of(view.table, point.row)},
                      {"setting", finite("setting", point.setting)},
                      {"value", finite("value", point.value)}});
  return {
      {"key", clean_text(view.table.keys.at(response.key))},
      {"figure", clean_text(view.table.figures.at(response.figure).id)},
      {"change", finite("change", response.change)},
      {"elasticity",
       response.has_elasticity ? Json(finite("elasticity", response.elasticity)) : Json()},
      {"variance_share",
       response.variance_share ? Json(finite("variance share", *response.variance_share)) : Json()},
      {"points", std::move(points)},
      {"fit", fit_json(response)}};
}

Json rankings_json(const StudyView& view) {
  Json out = Json::array();
  for (const study::Ranking& ranking : view.analysis.rankings) {
    Json keys = Json::array();
    for (const std::size_t i : ranking.responses)
      keys.push_back(clean_text(view.table.keys.at(view.analysis.responses.at(i).key)));
    out.push_back({{"figure", clean_text(view.table.figures.at(ranking.figure).id)},
                   {"keys", std::move(keys)}});
  }
  return out;
}

Json bought_json(const StudyView& view) {
  Json out = Json::array();
  for (const study::BoughtForNothing& bought : view.analysis.bought_for_nothing)
    out.push_back({{"case", case_of(view.table, bought.row)},
                   {"by", case_of(view.table, bought.by)},
                   {"dearer", finite("dearer", bought.dearer)}});
  return out;
}

Json optional_case(const study::Table& table, const std::optional<std::size_t>& row) {
  return row ? Json(case_of(table, *row)) : Json();
}

Json analysis_json(const StudyView& view) {
  Json responses = Json::array();
  for (const study::Response& response : view.analysis.responses)
    responses.push_back(response_json(view, response));
  const study::Recommendation& taken = view.analysis.recommendation;
  return {{"fronts", fronts_json(view)},
          {"reference", optional_case(view.table, view.analysis.reference)},
          {"responses", std::move(responses)},
          {"rankings", rankings_json(view)},
          {"bought_for_nothing", bought_json(view)},
          {"recommendation",
           {{"case", optional_case(view.table, taken.row)}, {"reason", clean_text(taken.reason)}}},
          {"search_ending", clean_text(view.analysis.search_ending)}};
}

/// What differs between two runs of the same study.
Json run_json(const StudyView& view) {
  Json cases = Json::array();
  for (const study::Row& row : view.table.rows)
    cases.push_back({{"reused", row.reused},
                     {"attempts", row.attempts},
                     {"seconds", finite("seconds", row.seconds)}});
  return {{"created", clean_text(view.about.created)},
          {"engine", clean_text(view.about.engine)},
          {"seconds", finite("seconds", view.about.seconds)},
          {"cases", std::move(cases)}};
}

/// A line an entry of a list: a case is found by its line, and two studies differ by lines.
void write_value(const Json& value, const std::string& margin, std::ostream& out) {
  const bool opens = value.is_object()
                         ? margin.size() < 4
                         : value.is_array() && value.size() > 0 && value.front().is_object();
  if (!opens) {
    out << value.dump();
    return;
  }
  const char* separator = "";
  out << (value.is_array() ? "[" : "{");
  for (const auto& [key, entry] : value.items()) {
    out << separator << "\n" << margin << "  ";
    if (value.is_object()) out << Json(key).dump() << ": ";
    if (value.is_array())
      out << entry.dump();
    else
      write_value(entry, margin + "  ", out);
    separator = ",";
  }
  out << "\n" << margin << (value.is_array() ? "]" : "}");
}

}  // namespace

void write_study_json(const study::Plan& plan, const study::Table& table,
                      const study::Analysis& analysis, std::ostream& out, const About& about) {
  const StudyView view{plan, table, analysis, about};
  Json whole = {{"schema", "limitgauge.study/1"}, {"name", clean_text(table.name)},
                {"job", clean_text(table.job)},   {"version", clean_text(about.version)},
                {"plan", plan_json(plan)},        {"keys", texts(table.keys)},
                {"figures", figures_json(table)}, {"counts", counts_json(table)},
                {"cases", cases_json(table)},     {"analysis", analysis_json(view)}};
  if (!about.own.empty()) {
    whole["own"] = {{"settings", settings_json(about.own)},
                    {"case", optional_case(table, own_row(view))}};
  }
  whole["run"] = run_json(view);
  write_value(whole, "", out);
  out << "\n";
}

}  // namespace limitgauge::reports::study_report
