#pragma once

#include "simulator/instrument/stock_rays.h"
#include "verifier/gate/verify.h"

namespace limitgauge::app {

/// The simulator's rays as the verifier asks them. Shares the stock, so it must be gone before the
/// stock can be cut where it stands.
class StockRayProbe : public verifier::StockProbe {
 public:
  explicit StockRayProbe(simulator::StockModel stock) : rays_(std::move(stock)) {}
  Run run(const model::Vec3& from, const model::Vec3& along, double limit_mm) const override {
    const simulator::StockRays::Run r = rays_.run(from, along, limit_mm);
    return {r.material, r.length_mm, r.ends, r.error_mm};
  }
  double spacing_mm() const override { return rays_.voxel_mm(); }

 private:
  simulator::StockRays rays_;
};

}  // namespace limitgauge::app
