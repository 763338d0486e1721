#include <ostream>

#include "model/text/number_text.h"
#include "reports/json/values.h"
#include "reports/study/figure_column.h"
#include "reports/text/text.h"

namespace limitgauge::reports::study_report {
namespace {

std::string header(const study::Table& table) {
  std::string out = "case,status,reason";
  for (const std::string& key : table.keys) out += "," + csv_text_cell(key);
  for (const study::Figure& figure : table.figures) out += "," + csv_text_cell(figure.id);
  return out + ",key,reused,attempts,seconds";
}

std::string setting_cell(const study::Setting& setting) {
  return setting.number ? model::shortest(*setting.number) : csv_text_cell(setting_text(setting));
}

std::string line(const study::Table& table, const study::Row& row) {
  std::string out = std::to_string(row.asked.index) + "," + study::name(row.status) + "," +
                    csv_text_cell(row.reason);
  for (const study::Setting& setting : row.asked.settings) out += "," + setting_cell(setting);
  for (std::size_t i = 0; i < table.figures.size(); ++i) {
    const std::optional<double>& value = row.figures.at(i);
    out += ",";
    if (value) out += model::shortest(json::finite(table.figures[i].id, *value));
  }
  return out + "," + csv_text_cell(row.key) + (row.reused ? ",true," : ",false,") +
         std::to_string(row.attempts) + "," + model::shortest(json::finite("seconds", row.seconds));
}

}  // namespace

void write_study_csv(const study::Plan&, const study::Table& table, const study::Analysis&,
                     std::ostream& out) {
  out << header(table) << "\r\n";
  for (const study::Row& row : table.rows) out << line(table, row) << "\r\n";
}

}  // namespace limitgauge::reports::study_report
