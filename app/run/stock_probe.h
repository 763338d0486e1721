#pragma once

#include <algorithm>

#include "model/base/memory.h"
#include "simulator/instrument/stock_rays.h"
#include "verifier/gate/verify.h"

namespace limitgauge::app {

/// The simulator's rays as the verifier asks them. Shares the stock, so it must be gone before the
/// stock can be cut where it stands.
class StockRayProbe : public verifier::StockProbe {
 public:
  /// `raw`, which must outlive this, is what other passes would cut; without it nothing else can be
  /// asked than the stock as it is.
  explicit StockRayProbe(simulator::StockModel stock, const model::Stock* raw = nullptr)
      : rays_(std::move(stock)), raw_(raw) {}
  Run run(const model::Vec3& from, const model::Vec3& along, double limit_mm) const override {
    const simulator::StockRays::Run r = rays_.run(from, along, limit_mm);
    return {r.material, r.length_mm, r.ends, r.error_mm};
  }
  double spacing_mm() const override { return rays_.voxel_mm(); }
  /// Cut coarsely: near a surface rays are answered from the exact material, and there are few.
  /// Throws simulator::ResourceError, model::Interrupted.
  std::unique_ptr<StockProbe> cut_by(std::span<const model::Pass> passes,
                                     const model::RunControl& control) const override {
    if (!raw_) return nullptr;
    constexpr double kVoxels = 100;  // along the longest side
    const model::Vec3 size = model::bounding_box(*raw_).size();
    const double voxel_mm = std::max(spacing_mm(), std::max({size.x, size.y, size.z}) / kVoxels);
    simulator::StockModel stock(*raw_, voxel_mm, model::memory_limit_bytes(), control);
    for (const model::Pass& pass : passes) stock = std::move(stock).cut(pass, control);
    return std::make_unique<StockRayProbe>(std::move(stock));
  }

 private:
  simulator::StockRays rays_;
  const model::Stock* raw_;
};

}  // namespace limitgauge::app
