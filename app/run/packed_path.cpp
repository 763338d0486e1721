#include "app/run/packed_path.h"

#include <cmath>
#include <stdexcept>
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

/// The start comes first; of a tool that stands upright there is nothing.
void pack_axes(model::Packer& out, const model::ToolAxes* axes) {
  const std::size_t count = axes ? axes->to.size() + 1 : 0;
  out.number(std::uint64_t{count});
  for (std::size_t i = 0; i < count; ++i)
    for (int k = 0; k < 3; ++k) out.number(axis_from(*axes, i)[k]);
}

std::shared_ptr<const model::ToolAxes> unpack_axes(model::Unpacker& in,
                                                   const model::Toolpath& path) {
  const std::size_t count = in.count(3 * sizeof(double));
  if (count == 0) return nullptr;
  auto axes = std::make_shared<model::ToolAxes>();
  for (std::size_t i = 0; i < count; ++i) {
    model::Vec3 axis;
    for (int k = 0; k < 3; ++k) axis[k] = in.number<double>();
    if (i == 0) {
      axes->start = axis;
    } else {
      axes->to.push_back(axis);
    }
  }
  try {
    require_axes(path, *axes);
  } catch (const std::invalid_argument&) {
    in.refuse();
  }
  return axes;
}

}  // namespace limitgauge::app
