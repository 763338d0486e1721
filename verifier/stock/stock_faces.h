#pragma once

#include <cstdint>
#include <optional>

#include "model/part/stock.h"
#include "verifier/cutter/swept_body.h"

namespace limitgauge::verifier {

/// What lies outside a raw block or bar, face by face: half-spaces, and round a bar's side the
/// outside of a cylinder. A shape that leans is asked in its own frame. Immutable.
class StockFaces {
 public:
  /// None of a mesh (MeshOutside).
  static std::optional<StockFaces> of(const model::Stock& stock);

  std::uint32_t count() const { return bar() ? 3 : 6; }
  /// Distance inwards from a face, mm, negative outside it, and its gradient.
  BodyDistance distance(std::uint32_t face, const model::Vec3& p) const;
  /// The side of a bar.
  bool is_concave(std::uint32_t face) const;

 private:
  explicit StockFaces(const model::LeaningStock& stock);
  BodyDistance upright_distance(std::uint32_t face, const model::Vec3& p) const;

  const model::CylinderStock* bar() const {
    return std::get_if<model::CylinderStock>(&stock_.upright);
  }

  model::LeaningStock stock_;
  model::Box3 box_;  ///< of the upright shape
  bool leans_ = false;
};

}  // namespace limitgauge::verifier
