#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "verifier/cells/surface_cells.h"
#include "verifier/reach/reach.h"

namespace limitgauge::verifier {

/// What became of one cell when it was looked at for one cutter.
struct ReachDecision {
  Reach reach = Reach::undecided;
  bool halve = false, in_u = true;
  double area_mm2 = 0;  ///< of a cell that is not halved
};

/// Decisions that were taken in another process, by what they depend on: the cutter, the cell, and
/// how often it was halved since that cutter looked at it first, for what is known of a cell comes
/// from those that it is part of.
class ReachRecords {
 public:
  void add(std::uint32_t cutter, std::uint32_t depth, const CellPart& cell,
           const ReachDecision& decision);
  void add(const ReachRecords& others);
  const ReachDecision* find(std::uint32_t cutter, std::uint32_t depth, const CellPart& cell) const;
  std::size_t size() const { return known_.size(); }

  std::string to_bytes() const;
  /// Nothing for bytes that are not what to_bytes() makes.
  static std::optional<ReachRecords> of_bytes(std::string_view bytes);

 private:
  struct Key {
    std::uint32_t cutter = 0, depth = 0, whole = 0;
    double u = 0, v = 0, size_u = 0, size_v = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };
  std::unordered_map<Key, ReachDecision, Hash> known_;
};

}  // namespace limitgauge::verifier
