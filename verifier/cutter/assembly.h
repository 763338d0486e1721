#pragma once

#include <span>
#include <string>
#include <vector>

#include "verifier/cutter/removed_space.h"
#include "verifier/gate/verify.h"

namespace limitgauge::verifier {

/// A part of a cutter's shank or holder, and what it sweeps in one pass. Parts are bodies of one
/// removed space together with the flutes: a gouge is measured in their union, whatever slices an
/// assembly is stated in.
struct AssemblySweep {
  std::size_t stage = 0;
  std::string body;  ///< "shank" or "holder"
  Sweep sweep;
};

/// Of all passes, the parts that come lower than the highest of `region`, as it lies before the
/// pass's cutter, from the tip up; all of a pass that turns its tool as it goes. Parts of one kind
/// and diameter that follow each other are one cylinder.
std::vector<AssemblySweep> assembly_sweeps(std::span<const Pass> passes, const model::Box3& region);
/// The same of a region of which only `highest_mm` is known, for passes that are not turned.
std::vector<AssemblySweep> assembly_sweeps(std::span<const Pass> passes, double highest_mm);

}  // namespace limitgauge::verifier
