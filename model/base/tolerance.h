#pragma once

/// Limits and tolerances of what is read and written: value, unit and reason of each. How far from
/// zero a part may lie is in coordinate_limit.h; LinuxCNC's tolerances for the radii of arcs in
/// gcode/read/arc.h.

namespace limitgauge::model {

inline constexpr double kInchMm = 25.4;

/// No length that is stated is shorter, unless it is 0: a nanometre. Rounding of a path at 10 m and
/// what the certificate allows for it are a thousandth of that, and no machine knows a length
/// below.
inline constexpr double kLeastLengthMm = 1e-6;

/// No word of a program names a place or a length beyond any machine: 1000 km. Squares are far from
/// overflow, and the fixed notation of such a number fits a writer's buffer.
inline constexpr double kLargestCoordinateMm = 1e9;
/// Slower than this nothing is cut; in single precision, as moves have it, it is still a number.
/// mm/min.
inline constexpr double kLeastFeed_mm_min = 1e-6;
/// No feed rate is beyond this, as no coordinate is. mm/min.
inline constexpr double kLargestFeed_mm_min = 1e9;

/// Between the ends of a motion that bends, X, Y or Z may be beyond a limit of travel by so much
/// without being named: limits are set in tenths of a millimetre.
inline constexpr double kTravelLook_mm = 0.01;

/// What is this little beyond the axis is taken to be on it: rounding of a cutter's given figures.
inline constexpr double kOnAxisMm = 1e-9;
/// Stated e and f of a cutter may be this far from what its other figures make of them: figures are
/// often rounded to a hundredth.
inline constexpr double kCentreAgreementMm = 0.01;

/// How far a corner of a polygon may be off the polygon's plane. What lies between the corners is
/// not stated by a file, so that a fan of triangles is the polygon itself only if it is plane.
inline constexpr double kPlanarity_mm = 1e-3;
/// A coordinate of a mesh beyond this is no part of a machine tool: 1 km.
inline constexpr double kFarthestCoordinate_mm = 1e6;
/// Below this share of the cube about a shell its volume is rounding alone.
inline constexpr double kLeastVolumeShare = 1e-12;

/// LinuxCNC takes a count for whole within this.
inline constexpr double kWholeCount = 1e-4;
/// LinuxCNC's EQ, NE, GE and LE take numbers for equal within this since 2.9.1; before, 1e-4 and
/// none for GE and LE.
inline constexpr double kEqualNumbers = 1e-6;
/// An entry arc of cutter compensation whose chord is this near to square with the radius at its
/// end, as a cosine, has become a straight line.
inline constexpr double kStraight = 1e-6;
/// An arc that is written turns by more: controls take one that turns by less than about 1e-6 for a
/// full turn.
inline constexpr double kLeastTurn_rad = 1e-3;
/// The radii at start and end of an arc that is written differ by no more: Grbl refuses what is
/// more unless it is below a thousandth of the radius.
inline constexpr double kRadiiApartMm = 0.005;
/// Half chords this near to the radius, relatively, mean a half circle.
inline constexpr double kHalfCircle = 1e-12;
/// LinuxCNC's tolerance for smooth transitions of cutter compensation.
inline constexpr double kSmooth_rad = 0.05;

/// The same where a control's corners are exact: of two lines only what rounding makes of no bend,
/// and beside an arc what places with three decimals make of a tangent one, radians. Where paths
/// beside circles that touch would meet is not known; what is no corner then moves the cutter's
/// edge by at most 5e-5 of its radius.
inline constexpr double kStraightOn_rad = 1e-9;
inline constexpr double kTangentArc_rad = 0.01;
/// LinuxCNC's fuzz: an arc whose end lies less than this beyond its start is a full turn.
inline constexpr double kFullTurn_rad = 1e-6;

}  // namespace limitgauge::model
