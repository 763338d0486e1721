#pragma once

/// The simulator's tolerances: value, unit and reason of each. Sizes in voxels and shares of time
/// or memory stand where they are used.

namespace limitgauge::simulator {

// Rounding in double precision. Coordinates lie within 10 m of zero
// (model/base/coordinate_limit.h), so that one operation rounds by at most 1e-12 mm.

/// What the rounding of a chain of operations may add to a distance, or take from it: moves are set
/// aside, and cutters' blocks end, only where they lose by more.
inline constexpr double kDistanceRounding_mm = 1e-9;
/// Distances to one plane that differ by less are one: the rounding of one operation.
inline constexpr double kSameDistance_mm = 1e-12;
/// Share of its value to which an iteration finds a place: at a minimum the value is then exact.
inline constexpr double kSettled = 1e-12;
/// The least distance along a move is found to this; the promise is kDistanceRounding_mm.
inline constexpr double kLeastAlongMove_mm = 1e-10;
/// A turn of a tool that is no more than rounding, rad: a tenth of a picometre on 100 mm.
inline constexpr double kSameTurn_rad = 1e-12;
/// Share of a voxel to which the least along a turning move is found for the level set, which holds
/// it in single precision.
inline constexpr double kTurnInVoxels = 1e-6;

// Dexels.

/// A move that goes less than this to the side is taken to be vertical.
inline constexpr double kLeastRun_mm = 1e-12;
/// Ends that would move by less than this stay where they are, and no thinner material is kept.
inline constexpr double kDexelRounding_mm = kDistanceRounding_mm;
/// A size that is a whole number of spacings but for this share of one is that number; a place that
/// is beyond a cell by no more is in it.
inline constexpr double kWholeSpacing = 1e-9;
/// Share of a spacing by which a range of lines is taken wider: a line on its edge is not missed.
inline constexpr double kLineOnEdge = 1e-6;
/// Material and gaps that are thinner have no middle at which two instruments could be compared.
inline constexpr double kThin_mm = 1e-8;
/// Two instruments may differ by this. The swept distances are exact to 1e-10 mm, the ends of
/// dexels to 1e-9 mm along Z; a cutter a micrometre too wide makes more than 1e-5 mm at some end.
inline constexpr double kAgreement_mm = 1e-6;

// Rays into the stock.

/// What is thinner along the ray is passed over, and an end is known to this.
inline constexpr double kLeastFeature_mm = 1e-7;
/// Share of a voxel that single precision may be off in a level set.
inline constexpr double kSinglePrecision_voxels = 1e-5;
/// How far from the surface an end of dexels may lie that were taken from a level set.
inline constexpr double kTakenOver_mm = 5e-7;
/// A level set read from a file has axes at right angles, as long as each other, within this share
/// of a voxel.
inline constexpr double kStraightAxes = 1e-12;
/// The most voxels by which its values may change from one node to the next across its surface:
/// distances change by one; what was drawn out a little by whoever wrote it stays below this, a
/// band of one voxel or more whose inside is empty does not.
inline constexpr double kSteepestLevelSet = 1.75;

// Meshes.

/// On the surface: far below what a mesh is for, far above rounding. From nearer, the way from the
/// nearest point has lost its direction to rounding.
inline constexpr double kOnSurface_mm = 1e-9;
/// Triangles are in one plane within rounding.
inline constexpr double kCoplanar_mm = 1e-10;
/// A triangle is a sliver where the sine of its smallest angle is below this. In doubles the foot
/// on its plane is off by about the square of 1e-16 over the sine, relative to the distance; the
/// foot of a sliver is found otherwise (PROOFS.md, P4).
inline constexpr double kSliverSine = 1e-8;

/// Points of the stock's surface are moved onto what was swept to this: far below the micrometre
/// that anybody measures, far above rounding.
inline constexpr double kSurfacePoint_mm = 1e-10;
/// Squared sine of the angle between two unit gradients below which they say no more than one.
inline constexpr double kSameLine = 1e-12;
/// Volume that three unit gradients span below which they say no more than two.
inline constexpr double kSamePlane = 1e-6;
/// Sine of the angle at which surfaces of two makers meet below which they make no edge worth a
/// vertex: a facet across it is off by the angle times a voxel over eight.
inline constexpr double kSharpSine = 5e-3;
/// The same of one maker's surface, whose own normals turn within a cell where it is round.
inline constexpr double kSharpOfOneSine = 0.3;
/// φ at an interpolated crossing that is beyond what curvature makes of a smooth surface: there the
/// crossing is looked for.
inline constexpr double kOffCrossing_voxels = 0.02;
/// Share of the way from a cell's middle to a crossing by which it is looked at from further out.
inline constexpr double kFurtherOut = 1e-3;

// Process.

/// What the rounding of a program's coordinates to micrometres may add to the drop of a move.
inline constexpr double kDropRounding_mm = 1e-3;
/// Two radii that are meant to be the same: diameters are stated to micrometres.
inline constexpr double kSameRadius_mm = 1e-6;
/// Sine of the angle between pieces of one line whose ends a program has rounded.
inline constexpr double kSameDirection = 1e-4;

}  // namespace limitgauge::simulator
