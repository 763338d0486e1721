#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "study/plan/plan.h"
#include "study/store/table.h"

namespace limitgauge::study {

/// The same setting: equal numbers, else equal text.
bool alike(const Setting& a, const Setting& b);

/// The first row with these settings, in the order of Table::keys.
std::optional<std::size_t> row_with(const Table& table, const std::vector<Setting>& settings);
/// The row with the job's own settings.
std::optional<std::size_t> own_row(const Plan& plan, const Table& table);

/// The row that responses go through: the job's own settings where they are a row. Else, of a grid,
/// the row whose settings come nearest to them: of each variable the number nearest to the job's,
/// or the middle one where it has none. Else `recommended`.
std::optional<std::size_t> reference_row(const Plan& plan, const Table& table,
                                         std::optional<std::size_t> recommended);

}  // namespace limitgauge::study
