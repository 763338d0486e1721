#include "reports/picture/perspective_view.h"

#include "reports/tolerance.h"

namespace limitgauge::reports {
namespace {

using model::Vec3;

constexpr double kMargin_px = 30;
/// Of the viewer, in radii of the part: as one holds a part in the hand.
constexpr double kDistance = 3.2;

}  // namespace

PerspectiveView::PerspectiveView(const verifier::DeviationField& field, const Vec3& towards,
                                 int width, int largest_height)
    : towards_(model::normalized(towards)),
      right_(model::normalized(model::cross({0, 0, 1}, towards_))),
      up_(model::cross(towards_, right_)),
      width_(width) {
  model::Box3 box;
  for (const auto& sample : field.samples) box.add(sample.place.point);
  if (box.empty()) return;
  const double radius = std::max(model::length(box.size()) / 2, kLeastExtent_mm);
  eye_ = (box.low + box.high) / 2.0 + towards_ * (kDistance * radius);
  model::Box3 seen;
  for (const auto& sample : field.samples) {
    const ScreenPoint p = project(sample.place.point);
    seen.add(Vec3{p.x, p.y, 0});
  }
  const Vec3 size = seen.size();
  pixels_ = std::min((width - 2 * kMargin_px) / std::max(size.x, kLeastSeen),
                     (largest_height - 2 * kMargin_px) / std::max(size.y, kLeastSeen));
  height_ = int(std::ceil(size.y * pixels_ + 2 * kMargin_px));
  left_ = (seen.low.x + size.x / 2) * pixels_ - width / 2.0;
  top_ = seen.low.y * pixels_ - kMargin_px;
}

ScreenPoint PerspectiveView::project(const Vec3& p) const {
  const Vec3 from_eye = p - eye_;
  const double inverse = -1 / model::dot(from_eye, towards_);
  return {model::dot(from_eye, right_) * inverse * pixels_ - left_,
          -model::dot(from_eye, up_) * inverse * pixels_ - top_, inverse};
}

PerspectiveView PerspectiveView::scaled(double times) const {
  PerspectiveView out = *this;
  out.pixels_ *= times, out.left_ *= times, out.top_ *= times;
  out.width_ = std::max(1, int(std::lround(width_ * times)));
  out.height_ = std::max(1, int(std::lround(height_ * times)));
  return out;
}

}  // namespace limitgauge::reports
