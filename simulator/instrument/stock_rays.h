#pragma once

#include "simulator/stock/material.h"
#include "simulator/stock/stock_model.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {

/// Rays into the stock: what stands at a point, and how far along a straight way everything is like
/// that. The level set leads as far as it proves where it is; where it does not, near a surface,
/// the exact material decides. So nothing is passed over for being thinner than a voxel: a fin or
/// a gap is seen down to kLeastFeature_mm, measured along the ray.
///
/// Proof: simulator/PROOFS.md, P3.
///
/// A model that works tile by tile holds a coarser level set whole: it leads less far, and the
/// answers are the same. Cheap to copy; shares the stock, so it must be gone before the stock can
/// be cut where it stands. Const calls from several threads at once.
class StockRays {
 public:
  struct Run {
    bool material = false;  ///< what stands at the start
    /// All of this is like the start, but for what is thinner than kLeastFeature_mm.
    double length_mm = 0;
    /// Material and air change places at its end. Where they do not and the length is less than was
    /// asked for, the ray keeps so close to a surface that nothing is known beyond.
    bool ends = false;
    double error_mm = 0;  ///< bound on the way from the end to the true change
  };

  explicit StockRays(StockModel stock) : stock_(std::move(stock)) {}

  /// `along` is a unit vector. A start within rounding of a surface is on either side of it.
  Run run(const model::Vec3& from, const model::Vec3& along, double limit_mm) const;
  /// The same on a way that lies in the raw stock from end to end, as its crossings with the ray
  /// say: only what was cut off it is looked for. So a ray along a side of the raw stock is no
  /// ray beside a surface.
  Run run_in_raw(const model::Vec3& from, const model::Vec3& along, double limit_mm) const;
  double voxel_mm() const { return stock_.voxel_mm(); }

 private:
  StockModel stock_;
};

}  // namespace limitgauge::simulator
