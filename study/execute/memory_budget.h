#pragma once

#include <cstdint>

namespace limitgauge::study {

/// How many cases fit beside each other: forecasts at first, put right by what cases took.
class MemoryBudget {
 public:
  explicit MemoryBudget(std::uint64_t bytes) : bytes_(bytes) {}

  /// What a case with this forecast will take, as far as is known by now.
  std::uint64_t expected(std::uint64_t forecast_bytes) const;
  /// A case came out with another peak than was forecast.
  void learn(std::uint64_t forecast_bytes, std::uint64_t peak_bytes);

  bool fits(std::uint64_t expected_bytes) const { return taken_ + expected_bytes <= bytes_; }
  void take(std::uint64_t expected_bytes) { taken_ += expected_bytes; }
  void give_back(std::uint64_t expected_bytes) { taken_ -= expected_bytes; }

 private:
  std::uint64_t bytes_, taken_ = 0;
  double worst_ratio_ = 0;  ///< of peak to forecast; 0: nothing measured yet
};

}  // namespace limitgauge::study
