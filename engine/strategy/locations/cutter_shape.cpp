#include "engine/strategy/locations/cutter_shape.h"

#include <algorithm>
#include <cmath>

#include "model/base/angle.h"

namespace limitgauge::engine::strategy {
namespace {

double ring_support(const CutterShape::Ring& ring, double steepness, double root) {
  return ring.radius_mm * steepness + ring.rounding_mm * root - ring.height_mm;
}

double ring_distance(const CutterShape::Ring& ring, double steepness) {
  return ring.radius_mm + ring.rounding_mm * steepness / std::sqrt(1 + steepness * steepness);
}

}  // namespace

CutterShape::CutterShape(const model::Cutter& cutter, double allowance_mm) {
  const double corner = cutter.corner_radius_mm;
  first_.ring = {cutter.radius_mm() - corner, corner, corner + allowance_mm};
  if (cutter.type != model::CutterType::taper) {
    finish_single();
    return;
  }
  coned_ = true;
  const double angle = model::radians(cutter.taper_angle_deg);
  const double across = std::cos(angle), up = std::sin(angle);
  last_.ring = {model::largest_radius_mm(cutter), cutter.flute_length_mm, allowance_mm};
  first_.begin_mm = first_.ring.radius_mm;
  first_.end_mm = first_.ring.radius_mm + first_.ring.rounding_mm * across;
  last_.begin_mm = std::max(first_.end_mm, last_.ring.radius_mm + allowance_mm * across);
  last_.end_mm = reach_mm_ = last_.ring.radius_mm + allowance_mm;
  cone_slope_ = cone_steepness_ = across / up;
  cone_z_mm_ = first_.ring.height_mm - first_.ring.rounding_mm * up;
}

CutterShape::CutterShape(const model::CylinderPart& part, double height_mm, double allowance_mm) {
  first_.ring = {part.diameter_mm / 2, height_mm, allowance_mm};
  finish_single();
}

void CutterShape::finish_single() {
  first_.begin_mm = first_.ring.radius_mm;
  first_.end_mm = reach_mm_ = first_.ring.radius_mm + first_.ring.rounding_mm;
  last_ = first_;
}

double CutterShape::support(double steepness) const {
  const double root = std::sqrt(1 + steepness * steepness);
  const double low = ring_support(first_.ring, steepness, root);
  return coned_ ? std::max(low, ring_support(last_.ring, steepness, root)) : low;
}

double CutterShape::contact_distance(double steepness) const {
  const bool above = coned_ && steepness > cone_steepness_;
  return ring_distance(above ? last_.ring : first_.ring, steepness);
}

std::vector<CutterShape> cutter_shapes(const model::Cutter& cutter, double allowance_mm,
                                       bool with_assembly) {
  std::vector<CutterShape> shapes = {CutterShape(cutter, allowance_mm)};
  if (!with_assembly) return shapes;
  double widest = model::largest_radius_mm(cutter), height = cutter.flute_length_mm;
  for (const auto* parts : {&cutter.shank, &cutter.holder})
    for (const model::CylinderPart& part : *parts) {
      if (part.diameter_mm / 2 > widest) shapes.emplace_back(part, height, allowance_mm);
      widest = std::max(widest, part.diameter_mm / 2);
      height += part.length_mm;
    }
  return shapes;
}

}  // namespace limitgauge::engine::strategy
