#pragma once

#include <compare>
#include <cstdint>

namespace limitgauge::verifier {

/// One of the bodies whose union is the removed space: a move of a pass, or a piece of one
/// (ChordPieces), or what lies outside one face of the raw stock (which counts as the pass after
/// the last), or outside all of a mesh.
struct BodyRef {
  std::uint32_t pass = 0, index = 0;
  friend auto operator<=>(const BodyRef&, const BodyRef&) = default;
};

}  // namespace limitgauge::verifier
