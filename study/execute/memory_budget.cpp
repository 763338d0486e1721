#include "study/execute/memory_budget.h"

#include <algorithm>

namespace limitgauge::study {
namespace {

/// What cases of one forecast may still differ by.
constexpr double kReserve = 1.1;

}  // namespace

std::uint64_t MemoryBudget::expected(std::uint64_t forecast_bytes) const {
  if (worst_ratio_ == 0) return forecast_bytes;
  return static_cast<std::uint64_t>(kReserve * worst_ratio_ * static_cast<double>(forecast_bytes));
}

void MemoryBudget::learn(std::uint64_t forecast_bytes, std::uint64_t peak_bytes) {
  if (forecast_bytes == 0 || peak_bytes == 0) return;
  worst_ratio_ =
      std::max(worst_ratio_, static_cast<double>(peak_bytes) / static_cast<double>(forecast_bytes));
}

}  // namespace limitgauge::study
