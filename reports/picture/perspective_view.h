#pragma once

#include "reports/picture/raster.h"
#include "verifier/gate/deviation.h"

namespace limitgauge::reports {

/// A viewer with one eye before a surface: true perspective, Z upright on the screen.
class PerspectiveView {
 public:
  /// Looks at the middle of `field` from the direction `towards` (from there to the viewer), scaled
  /// to fit `width` x `largest_height` pixels.
  PerspectiveView(const verifier::DeviationField& field, const model::Vec3& towards, int width,
                  int largest_height);

  /// z is the inverse of the distance along the view: linear on the screen over a flat triangle.
  ScreenPoint project(const model::Vec3& p) const;
  const model::Vec3& eye() const { return eye_; }
  /// From the middle of the field to the eye, and what leads right and up on the screen: of length
  /// one.
  const model::Vec3& towards() const { return towards_; }
  const model::Vec3& right() const { return right_; }
  const model::Vec3& up() const { return up_; }
  int width() const { return width_; }
  int height() const { return height_; }
  /// The same view on `times` as many pixels each way.
  PerspectiveView scaled(double times) const;

 private:
  model::Vec3 towards_, right_, up_, eye_;
  double pixels_ = 1, left_ = 0, top_ = 0;  ///< of a plane at distance one
  int width_ = 1, height_ = 1;
};

}  // namespace limitgauge::reports
