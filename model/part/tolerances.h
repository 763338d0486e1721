#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "model/geometry/interval.h"
#include "model/geometry/vec3.h"
#include "model/part/cutter.h"

namespace limitgauge::model {

/// By how much one tool may differ from what is stated of it, mm: the same in all its moves.
struct ToolTolerance {
  Interval radius_mm;         ///< of the cutter; the corner radius stays, of a ball it goes with it
  Interval length_mm;         ///< from the zero of its length to the tip: a longer tool cuts lower
  Interval corner_radius_mm;  ///< the radius stays, but where `flat_mm` is stated
  /// Of the corner's centre from the axis; the radius is that and the corner radius.
  std::optional<Interval> flat_mm;
};

/// What is not known of the tools and the zero, about the stated values; mm. Everything else, and
/// the raw stock, is as stated.
struct Tolerances {
  /// By how much all that programs do may lie further along each axis than it should.
  std::array<Interval, 3> zero_mm{};
  std::map<std::string, ToolTolerance> tools;  ///< by the id of the cutter
  // What differs from move to move, half widths:
  double path_mm = 0;    ///< of the tip from its path, any way
  double runout_mm = 0;  ///< of the radius at which teeth cut
  Vec3 positioning_mm;   ///< of the tip along each axis
};

/// Whether nothing of the range may differ.
bool is_none(const Interval& range);
/// The range of a half width.
Interval about_zero(double half);

/// Each range grown by `factor`: about the stated value where the range holds it, about its middle
/// where not. What a smaller factor allows, a larger one allows too.
Tolerances scaled(const Tolerances& tolerances, double factor);

/// No point of any of the tools lies further than this from where it is stated to be.
double farthest_off_mm(const Tolerances& tolerances);

/// What one tool is off by.
struct CutterOffset {
  double radius_mm = 0, length_mm = 0, corner_radius_mm = 0;
  std::optional<double> flat_mm;
};

/// The cutter that is off by so much; its length is no figure of a cutter's. Throws
/// std::invalid_argument for what no cutter of the type has (a corner radius of a ball), and where
/// what comes of it is no cutter.
Cutter varied(const Cutter& cutter, const CutterOffset& by);

/// Throws std::invalid_argument naming the range that is none, that is not of this type of cutter,
/// or that no cutter has at both of its ends.
void require_valid(const ToolTolerance& tolerance, const Cutter& cutter);

}  // namespace limitgauge::model
