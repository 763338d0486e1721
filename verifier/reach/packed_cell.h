#pragma once

#include "model/base/packed_bytes.h"
#include "verifier/cells/surface_cells.h"
#include "verifier/reach/reach.h"

namespace limitgauge::verifier {

/// Bytes of a cell.
inline constexpr std::size_t kCellBytes = 36;

inline void pack(model::Packer& out, const CellPart& cell) {
  out.number(cell.whole);
  for (const double value : {cell.u, cell.v, cell.size_u, cell.size_v}) out.number(value);
}

inline CellPart unpack_cell(model::Unpacker& in) {
  CellPart cell;
  cell.whole = in.number<std::uint32_t>();
  for (double* value : {&cell.u, &cell.v, &cell.size_u, &cell.size_v}) *value = in.number<double>();
  return cell;
}

inline void pack(model::Packer& out, Reach reach) {
  out.number(static_cast<std::uint8_t>(reach));
}

inline Reach unpack_reach(model::Unpacker& in) {
  const auto number = in.number<std::uint8_t>();
  if (number > static_cast<std::uint8_t>(Reach::unreachable)) in.refuse();
  return static_cast<Reach>(number);
}

}  // namespace limitgauge::verifier
