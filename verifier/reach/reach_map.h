#pragma once

#include <memory>
#include <span>
#include <vector>

#include "model/base/run_control.h"
#include "verifier/cells/parameter_index.h"
#include "verifier/reach/reach_records.h"
#include "verifier/reach/reachability.h"

namespace limitgauge::verifier {

struct ReachOptions {
  /// Cells whose control points lie this near to their middle are not halved any more: half the
  /// width of the undecided rim, roughly.
  double smallest_radius_mm = 0.02;
  /// Halving ends once so many cells were looked at; those left are undecided.
  std::size_t largest_cell_count = 100'000;
};

/// What a verdict takes for most cutters: the rim of what can be reached is a tenth of a millimetre
/// wide.
inline constexpr ReachOptions kReachEffort = {0.05, 60'000};

/// S as cells of which all points can be touched, none can, or neither was proven.
class ReachMap {
 public:
  struct Entry {
    CellPart cell;
    Reach reach = Reach::undecided;
    std::uint32_t cutter = 0;  ///< of a reachable cell: one that can touch all of it
    double area_mm2 = 0;
  };

  /// Of parts of `cells`.
  ReachMap(const SurfaceCells& cells, std::vector<Entry> entries);

  /// Areas of the cells so proven, by Gauss quadrature; they add up to the area of S.
  double reachable_area_mm2() const { return area_[1]; }
  double unreachable_area_mm2() const { return area_[2]; }
  double undecided_area_mm2() const { return area_[0]; }

  const std::vector<Entry>& entries() const { return entries_; }
  /// What is proven of the point of S at a patch's parameters; undecided at an irregular vertex.
  Reach at(int patch, double u, double v) const;
  /// The entry that holds it; none at an irregular vertex.
  const Entry* entry_at(int patch, double u, double v) const;
  /// What is proven of all points of `cell`, a part of one of the entries; undecided otherwise.
  Reach of(const SurfaceCell& cell) const;

 private:
  std::vector<Entry> entries_;
  std::unique_ptr<const ParameterIndex> index_;
  double area_[3] = {0, 0, 0};
};

/// How a search is shared out: its own part of the cells, what it says of them, and what other
/// processes have said. The map of all parts' records is that of a search that is not shared out.
struct ReachSharing {
  std::uint32_t first = 0, end = 0xffffffffU;  ///< cells that are looked at
  ReachRecords* record = nullptr;              ///< takes down every decision
  const ReachRecords* known = nullptr;         ///< taken over where they say something
};

/// Halves the cells until each is proven (CERTIFICATE.md, section 4) or an end of `options` is met.
/// Reachable and the contact tolerance as in `Reachability`. The same for any number of threads.
ReachMap classify_reach(const SurfaceCells& cells, const Reachability& reachability,
                        const ReachOptions& options, const model::RunControl& control);
/// Of several cutters, the first with the first options: what one of them can touch is reachable,
/// what none of them can is unreachable. Each looks only at what those before it cannot touch.
ReachMap classify_reach(const SurfaceCells& cells, std::span<const Reachability> cutters,
                        std::span<const ReachOptions> options, const model::RunControl& control,
                        const ReachSharing& sharing = {});

}  // namespace limitgauge::verifier
