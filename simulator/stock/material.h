#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "simulator/stock/raw_stock.h"
#include "simulator/sweep/sweep_index.h"

namespace limitgauge::simulator {

/// What a point of the stock's surface was made by: 0 is the raw stock, k the k-th pass, in which
/// `slot` names the move.
struct SurfaceMaker {
  std::uint32_t pass = 0;
  std::uint32_t slot = 0;
  friend bool operator==(const SurfaceMaker&, const SurfaceMaker&) = default;
};

/// φ at a point, its gradient, and the maker of the surface that it is the distance to.
struct MaterialSample {
  double value = 0;
  model::Vec3 gradient;
  SurfaceMaker maker;
};

/// The exact material: the raw stock less everything that the passes swept. An immutable value,
/// cheap to copy.
class Material {
 public:
  explicit Material(const RawStock& raw) : raw_(raw) {}
  Material after(std::shared_ptr<const SweepIndex> pass) const;

  /// φ = max(raw, −least swept distance). `guess` is where to look first (it only saves time).
  MaterialSample sample(const model::Vec3& p, SurfaceMaker guess = {}) const;
  /// The part of φ that one maker gives.
  MaterialSample sample_of(SurfaceMaker maker, const model::Vec3& p) const;

  const RawStock& raw() const { return raw_; }
  const std::vector<std::shared_ptr<const SweepIndex>>& passes() const { return passes_; }

 private:
  RawStock raw_;
  std::vector<std::shared_ptr<const SweepIndex>> passes_;
};

}  // namespace limitgauge::simulator
