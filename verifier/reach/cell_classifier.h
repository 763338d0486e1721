#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "verifier/cells/cell_halves.h"
#include "verifier/reach/cell_contact.h"
#include "verifier/reach/local_contact.h"
#include "verifier/reach/reach.h"
#include "verifier/reach/reachability.h"

namespace limitgauge::verifier {

/// A part of S that is not proven to be in reach or out of it yet, and what is known of it from the
/// cell it is half of.
struct OpenCell {
  CellPart cell;
  std::optional<model::Vec3> witness;  ///< a point of S that the cutter cuts into nearby
  std::optional<Cleared> cleared;      ///< proven not to be cut into
  std::vector<std::uint32_t> pending;  ///< with `cleared`: all other cells not proven so
  bool level = false;                  ///< a flat may touch with any of its points
  bool recorded = false;               ///< decided elsewhere: nothing of the above is known
};

/// The proofs that all points of a cell of S can be touched by one cutter, or that none can
/// (CERTIFICATE.md, section 4).
class CellClassifier {
 public:
  CellClassifier(const SurfaceCells& cells, const Reachability& reachability);

  /// Proves the cell to be one or the other, or adds to what is known of it. `parts` are kept from
  /// one neighbouring cell to the next, and change no answer.
  Reach decide(OpenCell& open, const SurfaceCell& cell, CellHalves& parts) const;

 private:
  Reach decide_level(const SurfaceCell& cell, std::uint32_t whole, const CellContact& contact,
                     CellHalves& parts) const;
  bool prove(OpenCell& open, const SurfaceCell& cell, const CellContact& contact,
             CellHalves& parts) const;
  bool prove_beyond(OpenCell& open, const std::optional<Cleared>& cleared,
                    const CellContact& contact, CellHalves& parts) const;
  bool search(const CellContact& c, const std::optional<Cleared>& cleared,
              std::vector<std::uint32_t>& pending, std::optional<model::Vec3>& witness,
              CellHalves& parts) const;
  bool below_contact_plane(const CellContact& c, const model::Box3& box) const;
  /// What the looks at one cell of S share.
  struct Looks {
    CellHalves& parts;
    std::optional<model::Vec3>& witness;
    std::uint32_t whole = 0;  ///< the cell
    int left = 0;             ///< how many more parts of it may be looked at
  };
  bool clears_cell(const CellContact& c, const std::optional<Cleared>& cleared, std::uint32_t index,
                   CellHalves& parts, std::optional<model::Vec3>& witness) const;
  bool clears(const CellContact& c, const std::optional<Cleared>& cleared, CellHalves::Part& other,
              Looks& looks) const;
  bool clears_by_distance(const CellContact& c, const CellHalves::Part& other,
                          const BodyDistance& d) const;
  bool clears_by_plane(const CellContact& c, const CellHalves::Part& other, double apart) const;
  bool clears_by_its_plane(const CellContact& c, const CellHalves::Part& other) const;
  std::optional<model::Vec3> deepest_middle(const model::Vec3& tip) const;
  bool bars_all(const model::Vec3& q, const CellContact& contact) const;
  bool refute(OpenCell& open, const SurfaceCell& cell, const CellContact& contact) const;

  const SurfaceCells& cells_;
  const Reachability& reachability_;
  double limit_;
  LocalContact local_;
};

}  // namespace limitgauge::verifier
