#pragma once

#include <cmath>

#include "engine/strategy/stage_path.h"
#include "model/base/angle.h"

namespace limitgauge::engine::strategy {

/// Leads and tilts are no more, either way: a tool along the surface cuts nothing.
inline constexpr double kMostLean_deg = 60;

/// The axis of a tool, of length 1, that leans from `up` (a unit vector) where rows run along
/// `along`: with l the unit vector to the left of the rows, across `up` and `along`, and a the one
/// across l and `up`, ahead, the axis is along up + heading·tan(lead)·a + tan(tilt)·l. Seen along
/// the rows it leans by the tilt, seen across them by the lead.
///
/// `heading` is 1 where the tool goes along the rows and -1 where it comes back; between them the
/// lead goes over from one to the other. `up` must not be parallel to `along`.
inline model::Vec3 leaning_axis(const model::Vec3& up, const model::Vec3& along, double heading,
                                const ToolLean& lean) {
  const model::Vec3 left = normalized(cross(up, along)), ahead = cross(left, up);
  return normalized(up + heading * std::tan(model::radians(lean.lead_deg)) * ahead +
                    std::tan(model::radians(lean.tilt_deg)) * left);
}

}  // namespace limitgauge::engine::strategy
