#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/plan/plan.h"
#include "study/store/table.h"

namespace limitgauge::study {

/// Where a plan's figures stand in a table.
struct Objectives {
  std::optional<std::size_t> cost;    ///< into Table::figures; empty: the table does not have it
  std::vector<std::size_t> accuracy;  ///< likewise
};
Objectives objectives(const Plan& plan, const Table& table);

std::optional<std::size_t> figure_index(const Table& table, const std::string& id);
/// Nothing where the row does not have it.
std::optional<double> figure_of(const Row& row, std::size_t figure);
/// True where the case came to a result: passed, failed or undecided.
bool has_result(const Row& row);
/// All of `figures`; nothing where one is missing or the case came to no result.
std::optional<std::vector<double>> figures_of(const Row& row,
                                              const std::vector<std::size_t>& figures);

}  // namespace limitgauge::study
