#pragma once

#include <algorithm>
#include <array>

/// The verifier's tolerances: value, unit and reason of each. The mathematics that they go into is
/// in CERTIFICATE.md, its table of tolerances says what each may hide; FEET.md has those of the
/// closest point. Shares of effort and of a resolution stand where they are used: they decide how
/// long a search takes, and never what is true.

namespace limitgauge::verifier {

// Rounding in double precision. Coordinates lie within 10 m of zero
// (model/base/coordinate_limit.h), so that one operation rounds by at most 1e-12 mm.

/// What the rounding of a chain of operations may add to a distance: a thousand times one of them.
inline constexpr double kDistanceRounding_mm = 1e-9;
/// Distances nearer to each other than this are one: the rounding of one operation.
inline constexpr double kSameDistance_mm = 1e-12;
/// Of a unit vector's components, and of sums of a few terms as a share of the largest.
inline constexpr double kUnitRounding = 1e-14;
/// Of an angle by the arc cosine of nearly one: the root of twice the last bit, rad.
inline constexpr double kArcCosineRounding_rad = 1e-7;
/// Share of the coordinates that differences of distances may be by rounding alone: ten last bits.
inline constexpr double kCoordinateRounding = 2e-15;
/// Determinants of positive matrices below this share of their diagonals' product are singular.
inline constexpr double kSingular = 1e-12;

/// One less the cosine of two directions that are one.
inline constexpr double kSameDirection = 1e-12;
/// The least distance along a sloping move is found to this, between the distance at a place of it
/// and where the tangents of two places meet.
inline constexpr double kAlongMove_mm = 1e-11;
/// The least distance along a move that turns its tool is found to this: what the last bits of the
/// poses in between leave to be found, a tenth of kDistanceRounding_mm.
inline constexpr double kAlongTurn_mm = 1e-10;
/// Over a cell any time serves: to this it is found there, of second order as the bounds are.
inline double turning_precision_mm(double radius_mm) {
  constexpr double kShare = 0.02;
  return std::max(kAlongTurn_mm, kShare * radius_mm * std::min(1.0, radius_mm));
}

/// Share of itself to which a figure is narrowed that is proven to be beyond its limit: its verdict
/// is settled. What compares two of them knows no more.
inline constexpr double kSettledShare = 0.05;

// The limit surface.

/// What lies within it of an irregular vertex is stood for by the vertex. A function that changes
/// by at most a millimetre a millimetre is wrong there by at most that.
inline constexpr double kOmitted_mm = 1e-8;
/// What rounding and the vertices that stand for what is about them may add to any distance.
inline constexpr double kRounding_mm = kDistanceRounding_mm + kOmitted_mm;
/// Pieces within this of an irregular vertex have the normal of the next piece beyond: theirs are
/// lost in rounding, and the vertex's own may be a limit that nothing comes near to.
inline constexpr double kVertexNormal_mm = 1e-6;
/// Searches halve no cell whose control points lie this near to its middle: what they ask stays
/// undecided there.
inline constexpr double kSmallestCell_mm = 1e-6;
/// A cell that is smaller is one point: its normals are rounding.
inline constexpr double kPoint_mm = kSameDistance_mm;
/// Normals of neighbouring faces that differ by less are one: far below what a run of a metre
/// shows.
inline constexpr double kSmooth_rad = 1e-7;
/// Normals of a cell on a plane spread by less than this, by rounding.
inline constexpr double kFlat_rad = 1e-6;
/// Means of unit normals that are shorter have no direction: the normals cancel.
inline constexpr double kCancels = 1e-6;
/// Edges of two patches whose middles and derivatives differ by less, as a share of the surface's
/// size, are one: a hundred times what evaluation rounds by.
inline constexpr double kSameEdge = 1e-11;

/// What the straight pieces that stand for a path's arcs keep to: a hundredth of what counts as met
/// beside a wall (kWedge_mm), so that a wall which an arc runs along, or rolls round the end of, is
/// told from one that is cut; far below what a verdict shows.
inline constexpr double kArcPiece_mm = 1e-6;
/// No path has more pieces of arcs than that: some 50 MB, and as long to search as a path of as
/// many moves. Beyond it they are wider.
inline constexpr double kMostArcPieces = 500'000;

/// Sine of the angle between tangents below which they span no plane: a hundred times the rounding
/// of their evaluation.
inline constexpr double kParallel = 1e-11;
/// Extremes of the surface along an axis are found to this.
inline constexpr double kExtremeTolerance_mm = 1e-10;
/// Share of the whole area by which quadrature over a piece and over its quarters may differ. A
/// quartering takes the error to less than a hundredth, so that pieces by the thousand stay within
/// the 1e-6 that is promised of the area.
inline constexpr double kAreaStep = 1e-8;
/// Share of the whole area that is lost in the last bits of its sum, for as many pieces as there
/// may be: such a piece is not quartered.
inline constexpr double kAreaLost = 1e-20;
/// Refinement about an irregular vertex ends where the neighbourhood is smaller than this part of
/// the model: the last bits of its coordinates.
inline constexpr double kSmallestPiece = 1e-15;
/// A cell whose surface is off its plane by no more is plane: a nanometre.
inline constexpr double kPlane_mm = 1e-6;

// Ridges.

/// Parameters by which the faces round a vertex are looked at beside it, for what rises over a
/// tangent plane. 1e-3 of a face is far from rounding, and less than any bend.
inline constexpr double kIntoFace = 1e-3;
/// Sine by which a face rises where it does; less is the rounding of its tangents.
inline constexpr double kRises = 1e-6;
/// Parameters beside a vertex at which its faces' normals are read: its own limit may be one that
/// nothing comes near to.
inline constexpr double kBesideVertex = 1e-6;
/// Fans of normals that spread by less are one normal, in a cell no larger than kSmallestCell_mm.
inline constexpr double kSmallestFan_rad = 1e-5;

// Closest points (FEET.md).

/// As kOmitted_mm, for closest points, whose cells are few near vertices.
inline constexpr double kFootOmitted_mm = 1e-10;
/// No point of S is nearer than the foot that is found by more than this: proven.
inline constexpr double kFootTolerance_mm = 1e-10;
/// A foot that is no more than this aside needs no settling: a tenth of its tolerance.
inline constexpr double kSettled_mm = 1e-11;
/// A place that is nearer by kFootTolerance_mm at most, over a smooth foot, is within this.
inline constexpr double kSettling_mm = 1e-4;
/// A place this near to a feature (an edge, a vertex) is on it: rounding of its parameters.
inline constexpr double kOnFeature_mm = kDistanceRounding_mm;
/// Relative change of a squared distance that is lost in rounding.
inline constexpr double kLevelSquare = 1e-14;
/// Sine of the angle between connection and normal up to which a foot counts as perpendicular: far
/// above Newton's residual, far below what a boundary point shows to any but its own wedge.
inline constexpr double kPerpendicular = 1e-5;
/// Single precision in the tree over feet: see the head of foot_tree.cpp for both.
inline constexpr double kFootBoxMargin = 1e-6;  ///< as a share of the model's size
inline constexpr float kFootBoundShrink = 1 - 6e-6F;

// Crossings of a ray with S.

/// What lies nearer to where a ray starts is s itself, or a face that meets its own there.
inline constexpr double kItself_mm = 1e-5;
/// Nearer than this two faces cannot be told apart along a ray: the rounding of both.
inline constexpr double kSamePlace_mm = 2 * kDistanceRounding_mm;
/// Cosine of the angle between the normals of two faces that lie back to back.
inline constexpr double kBackToBack = -1 + 1e-9;
/// What leans across the ray by less than this sine faces neither way.
inline constexpr double kFacing = 1e-3;

// Runs along normals (CERTIFICATE.md, table of tolerances).

/// Skins of material, and slits in it, thinner than a nanometre do not count as either: passes that
/// meet face to face leave no film between them, and a block flush with S is not missing there.
inline constexpr double kSkin_mm = 1e-6;
/// By how much a run looks past such a skin or slit.
inline constexpr double kStepOver_mm = 4 * kSkin_mm;
/// What lies this near beside a normal, behind a face that runs along it, counts as met by it: a
/// wall cut flush with an edge of S, or half a micrometre off, is no gouge as deep as the wall is
/// high, nor is a film of that width beside an upright wall a leftover of its height. Fins and
/// holes from a micrometre on are seen. Half of the last digit of programs in micrometres.
inline constexpr double kBeside_mm = 5e-4;
/// Depths at which what stands by so much beside a normal, in whatever direction, counts as met by
/// it: a sharp edge of the material ends the runs beside it, and the side of a block those at the
/// rim of S. The second is for edges and sides that lean by no more than 11 degrees.
inline constexpr std::array<double, 2> kWedge_mm = {8e-4, 1e-4};
/// Sine of the angle up to which a face is taken to run along a normal.
inline constexpr double kAlong = 0.1;

// Meshes (stock and fixtures).

/// Share of the two products' sum by which the determinant of orient2d may be off: Shewchuk (1997),
/// its first stage, (3 + 16u)·u with u = 2⁻⁵³, rounded up.
inline constexpr double kOrientationRounding = 3.5e-16;

/// Nearer than this to a mesh the side of a point is mostly rounding: it counts as inside; and
/// coplanar triangles, which bound a cell alike, are not looked at for less.
inline constexpr double kOnMesh_mm = 1e-11;
/// Nearer than this the way to a mesh has a share of rounding: the facet's normal stands for it.
inline constexpr double kMeshWay_mm = 1e-6;
/// Cells of the search for a mesh's side count as larger by this share, so that rounding cannot
/// lose a triangle.
inline constexpr double kMeshCellMargin = 1e-6;
/// Triangles thinner than a millionth of their length (squared here): the foot on their plane is
/// not to be relied on alone.
inline constexpr double kSliver = 1e-12;

// Reach.

/// A position may come so much nearer to S than the allowance, and still touches: a tenth of a
/// micrometre, far below any gate.
inline constexpr double kContact_mm = 1e-4;
/// Sine of the slope below which a spot is level.
inline constexpr double kLevelSlope = 1e-9;
/// Turn of a normal on a wall that contacts leave room for, rad.
inline constexpr double kContactTurn_rad = 1e-6;
/// A face whose normals are no more than this off a flat's level or off the slope of a cutter's side
/// is tried as one that lies along it, rad: whether it is in reach is for the contact tolerance to
/// say. What coordinates in single precision turn a face of a tenth of a millimetre by.
inline constexpr double kLean_rad = 1e-4;
/// Width to which the unavoidable uncut is certified, where the verdict asks for no less.
inline constexpr double kUnavoidable_mm = 5e-3;
/// A cutter so far above S and its allowance is free: a nanometre, far above rounding.
inline constexpr double kRetracted_mm = 1e-6;
/// Radius in plan to which a point of S is found to bar tips.
inline constexpr double kBarred_mm = 1e-7;

// The second instrument.

/// What two evaluations of the same swept surface may differ by, beyond the error that a run's end
/// states: both work in double precision, so this is far above rounding and far below any gate.
inline constexpr double kAgreement_mm = 1e-6;

// What is added up cell by cell: less is rounding, and no area or length.

inline constexpr double kNoArea_mm2 = 1e-9;
inline constexpr double kNoLength_mm = 1e-6;

}  // namespace limitgauge::verifier
