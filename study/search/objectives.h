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
/// What is to be small of a figure: the one place where what is to be large changes its sign.
double to_be_small(const Figure& figure, double value);
/// True where the case came to a result: passed, failed or undecided.
bool has_result(const Row& row);
/// All of `figures`; nothing where one is missing or the case came to no result.
std::optional<std::vector<double>> figures_of(const Row& row,
                                              const std::vector<std::size_t>& figures);
/// The same, each as it is to be small.
std::optional<std::vector<double>> to_be_small(const Table& table, const Row& row,
                                               const std::vector<std::size_t>& figures);

}  // namespace limitgauge::study
