#pragma once

#include <array>
#include <functional>
#include <vector>

#include "engine/surface/cell/chord_bound.h"
#include "engine/surface/cell/limit_patch.h"
#include "engine/surface/cell/outer_mesh.h"
#include "engine/surface/model_request.h"
#include "model/base/run_control.h"
#include "model/part/cage.h"

namespace limitgauge::engine::surface {

/// One patch of the finish model: its limit mesh, its place in the outer layer, and the chord
/// bounds of every depth that was looked at.
struct ModelPatch {
  Index first_half_edge = 0;  ///< side c of the patch is half-edge first_half_edge + c
  LimitPatch limit;
  std::size_t cell_bytes = 0;  ///< of its control points in single precision, as allocated
  ChordBounds bounds;          ///< by depth, to that of the limit mesh
  /// False where no bound was found at the largest depth (a surface folded flat, as at a vertex of
  /// two faces): twice what a mesh of one depth less lacks at the nodes stands in for it.
  bool proven = true;
  /// Extraordinary corners, where normals may turn ever faster: the cell at the corner again, and a
  /// quarter of its side, and so on, each but for its own such quarter within the precision. They
  /// lie over the coarser mesh, which stays as it is and may stand out there: a cutter that keeps
  /// clear of all of them does not gouge, and leaves what the coarser mesh is too high.
  std::vector<LimitPatch> corners;
  /// The vertices at which they end. What is left there lies within the precision of the vertex, so
  /// a ball about the vertex covers its offset.
  std::vector<Vec3> specks;
  double corner_bound_mm = 0;  ///< that of the worst of corners and specks
};

/// How a model is sampled: a depth for each patch, and the bound that then holds.
struct Sampling {
  std::vector<int> depths;
  /// A patch: its limit mesh lacks more than was asked for at an extraordinary corner and needs the
  /// pieces there. Moved out all do.
  std::vector<bool> corners_apart;
  double limit_mm = 0;   ///< limit mesh, with the pieces at its extraordinary corners
  double offset_mm = 0;  ///< the same moved out
};

/// The finish model (paper sections 3 and 4): patches of independent depth over the outer layer.
/// Patches that share an edge or a vertex hold bitwise equal points where they both sample it, and
/// bitwise equal normals where the surface is smooth across.
class PatchModel {
 public:
  PatchModel(const model::Cage& cage, const ModelRequest& request,
             const model::RunControl& control);

  const OuterMesh& outer() const { return outer_; }
  const std::vector<ModelPatch>& patches() const { return patches_; }
  /// The patch on which half-edge `h` lies and its side, or nothing where it is a hole.
  bool has_patch(Index h) const { return patch_of_face_[outer_.face_of[h]] >= 0; }
  int patch_at(Index h) const { return patch_of_face_[outer_.face_of[h]]; }
  int side_at(Index h) const { return h - outer_.face_offsets[outer_.face_of[h]]; }
  /// Whether the surface ends at half-edge `h`: an open boundary or the border of a hole.
  bool ends_at(Index h) const { return outer_.open(h) || !has_patch(outer_.twin[h]); }
  /// Whether the surface has an infinitely sharp crease along `h`.
  bool creased_at(Index h) const { return is_infinite(outer_.edge_sharpness[outer_.edge[h]]); }

  model::Box3 bounding_box() const { return box_; }
  /// Least depth at which the meshes of patch `p` by themselves keep within `error_mm`; the patch's
  /// own depth where none does.
  int depth_for(int p, double error_mm) const;
  /// Least depths at which all meshes keep within `error_mm`, finer ones laid onto the sides of
  /// coarser neighbours; the patches' own where none do. Extraordinary corners have meshes of their
  /// own (ModelPatch::corners) and do not count.
  Sampling sampling_for(double error_mm) const;
  std::size_t memory_bytes() const;

 private:
  void build_corner(ModelPatch& patch, CellPatch cell, const ModelRequest& request);
  CellPatch cell_of(std::size_t p) const;
  BoundRequest bound_request(std::size_t p, const ModelRequest& request) const;
  /// Bounds patch `p` to the depth after those that are known; false where there is none.
  bool bound_next(std::size_t p, const ModelRequest& request);
  void build_patch(std::size_t p, int depth, const ModelRequest& request);
  /// Whether the patch may be a depth deeper than those that are bounded: then it is bounded now.
  using Deepen = std::function<bool(int patch)>;
  /// The largest depths allowed are those to which the bounds go, or to which `deepen` takes them.
  std::vector<int> depths_within(double error_mm, const Deepen& deepen) const;
  /// Those of the least error from `error_mm` on, doubled again and again, at which the model stays
  /// within two gigabytes; the bounds of the patches say what it then lacks.
  std::vector<int> affordable_depths(double error_mm, const Deepen& deepen) const;
  /// Bound of patch `p` beside its neighbours: what its own mesh lacks, what its sides move when
  /// laid onto coarser ones, and what bulges out over their meshes.
  double error_mm(int p, const std::vector<int>& depths, MeshError ChordBound::*of) const;
  /// Bound, either way, of the limit mesh about the extraordinary corners of patch `p`.
  double corner_mm(int p, const std::vector<int>& depths) const;
  double worst_mm(int p, const std::vector<int>& depths) const;
  /// Patches that share a vertex with patch p.
  std::vector<std::vector<int>> touching_;
  void find_touching();
  void share_edges();
  /// One point for all patches at a vertex, one normal for those of a smooth sector there.
  void share_vertex(RingWalk ring);
  void copy_edge(Index from, Index to);

  OuterMesh outer_;
  std::vector<int> patch_of_face_;
  std::vector<ModelPatch> patches_;
  model::Box3 box_;
};

}  // namespace limitgauge::engine::surface
