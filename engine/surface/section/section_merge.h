#pragma once

#include <compare>
#include <optional>
#include <vector>

#include "engine/surface/offset_model.h"
#include "engine/surface/patch_model.h"
#include "engine/surface/section/section_chain.h"

namespace limitgauge::engine::surface {

/// One curve of a whole section, merged over the outer layer. Seen from the side to which the
/// cage's faces turn counter-clockwise, what is above the plane lies on the left.
struct SectionCurve {
  std::vector<Vec3> points;  ///< all in the plane, bit by bit
  bool closed = false;       ///< the first point is not repeated
};

/// Joins the chains that one plane leaves in the patches of a model into whole curves. A chain
/// leaves a patch where the curve enters its neighbour: at the same segment of the coarser of the
/// two, which a plane crosses once.
class SectionMerge {
 public:
  SectionMerge(const PatchModel& model, const OffsetModel& sampled)
      : model_(model), sampled_(sampled) {}

  /// Takes over the chains of patch `patch`.
  void add(int patch, std::vector<SectionChain>& chains);
  /// Open curves first, each group in the order of its first chain. Leaves the merge empty.
  std::vector<SectionCurve> curves();

 private:
  /// A place on an inner edge: the edge's number and the segment of the coarser side.
  struct Crossing {
    Index edge = 0;
    int segment = 0;
    friend auto operator<=>(const Crossing&, const Crossing&) = default;
  };
  struct Entry {
    Crossing at;
    int chain = 0;
  };
  struct Piece {
    SectionChain chain;
    std::optional<Crossing> first, last;  ///< none: the surface ends there
    bool joined = false;                  ///< another piece leads to it
    bool used = false;
  };
  std::optional<Crossing> crossing(int patch, const SectionEnd& end) const;
  std::optional<int> after(int piece) const;
  /// The pieces from `piece` on, one leading to the next.
  std::vector<int> chain_from(int piece, bool& closed);
  SectionCurve follow(int piece);

  const PatchModel& model_;
  const OffsetModel& sampled_;
  std::vector<Piece> pieces_;
  std::vector<Entry> entries_;
};

}  // namespace limitgauge::engine::surface
