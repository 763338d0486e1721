#include "study/plan/reference.h"

#include <algorithm>
#include <cmath>

#include "study/plan/settings.h"

namespace limitgauge::study {
namespace {

Setting nearest_to_base(const Variable& variable) {
  const std::vector<Setting> all = settings_of(variable);
  const Setting* nearest = nullptr;
  double distance = 0;
  for (const Setting& setting : all) {
    if (variable.base && alike(setting, *variable.base)) return setting;
    if (!setting.number || !variable.base || !variable.base->number) continue;
    const double away = std::abs(*setting.number - *variable.base->number);
    if (nearest == nullptr || away < distance) nearest = &setting, distance = away;
  }
  return nearest != nullptr ? *nearest : all[(all.size() - 1) / 2];
}

}  // namespace

bool alike(const Setting& a, const Setting& b) {
  return a.number && b.number ? *a.number == *b.number : a.toml == b.toml;
}

std::optional<std::size_t> row_with(const Table& table, const std::vector<Setting>& settings) {
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::vector<Setting>& own = table.rows[i].asked.settings;
    if (std::equal(own.begin(), own.end(), settings.begin(), settings.end(), alike)) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> own_row(const Plan& plan, const Table& table) {
  std::vector<Setting> own;
  for (const Variable& variable : plan.variables) {
    if (!variable.base) return std::nullopt;
    own.push_back(*variable.base);
  }
  return row_with(table, own);
}

std::optional<std::size_t> reference_row(const Plan& plan, const Table& table,
                                         std::optional<std::size_t> recommended) {
  if (const std::optional<std::size_t> own = own_row(plan, table)) return own;
  if (plan.method != Method::grid) return recommended;
  std::vector<Setting> settings;
  for (const Variable& variable : plan.variables) settings.push_back(nearest_to_base(variable));
  return row_with(table, settings);
}

}  // namespace limitgauge::study
