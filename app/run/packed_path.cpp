#include "app/run/packed_path.h"

#include <cmath>
#include <type_traits>

namespace limitgauge::app {

/// Moves are written as they stand in memory: they hold neither pointers nor gaps.
static_assert(std::is_trivially_copyable_v<model::Move> && sizeof(model::Move) == 32);

void pack_path(model::Packer& out, const model::Toolpath& path) {
  for (int axis = 0; axis < 3; ++axis) out.number(path.start[axis]);
  out.number(path.chord_error_mm);
  out.number(std::uint64_t{path.moves.size()});
  out.raw(path.moves.data(), path.moves.size() * sizeof(model::Move));
}

model::Toolpath unpack_path(model::Unpacker& in) {
  model::Toolpath path;
  for (int axis = 0; axis < 3; ++axis) path.start[axis] = in.number<double>();
  path.chord_error_mm = in.number<double>();
  path.moves.resize(in.count(sizeof(model::Move)));
  const std::string_view bytes = in.take(path.moves.size() * sizeof(model::Move));
  if (!bytes.empty()) std::memcpy(path.moves.data(), bytes.data(), bytes.size());
  for (const model::Move& move : path.moves)
    if (!std::isfinite(move.to.x + move.to.y + move.to.z)) in.refuse();
  return path;
}

}  // namespace limitgauge::app
