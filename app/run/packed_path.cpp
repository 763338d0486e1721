#include "app/run/packed_path.h"

#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace limitgauge::app {

/// Moves are written as they stand in memory: they hold neither pointers nor gaps.
static_assert(std::is_trivially_copyable_v<model::Move> && sizeof(model::Move) == 32);
/// The same holds for arcs.
static_assert(std::is_trivially_copyable_v<model::ArcMoves> && sizeof(model::ArcMoves) == 136);

namespace {

bool is_finite(const model::Arc& arc) {
  double sum = arc.angle + arc.swept + arc.radius_mm + arc.radius_growth_mm;
  for (const model::Vec3& v : {arc.centre, arc.axis1, arc.axis2, arc.rise_mm})
    sum += v.x + v.y + v.z;
  return std::isfinite(sum);
}

/// Arcs in the order of their moves, none of which belongs to two.
bool fit(const std::vector<model::ArcMoves>& arcs, std::size_t moves) {
  std::size_t next = 0;
  for (const model::ArcMoves& arc : arcs) {
    if (!is_finite(arc.arc) || arc.chords == 0 || arc.first_move < next) return false;
    next = std::size_t{arc.first_move} + arc.chords;
  }
  return next <= moves;
}

template <class Value>
void pack_values(model::Packer& out, const std::vector<Value>& values) {
  out.number(std::uint64_t{values.size()});
  out.raw(values.data(), values.size() * sizeof(Value));
}

template <class Value>
void unpack_values(model::Unpacker& in, std::vector<Value>& values) {
  values.resize(in.count(sizeof(Value)));
  const std::string_view bytes = in.take(values.size() * sizeof(Value));
  if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
}

}  // namespace

void pack_path(model::Packer& out, const model::Toolpath& path) {
  for (int axis = 0; axis < 3; ++axis) out.number(path.start[axis]);
  out.number(path.chord_error_mm);
  pack_values(out, path.moves);
  pack_values(out, path.arcs);
}

model::Toolpath unpack_path(model::Unpacker& in) {
  model::Toolpath path;
  for (int axis = 0; axis < 3; ++axis) path.start[axis] = in.number<double>();
  path.chord_error_mm = in.number<double>();
  unpack_values(in, path.moves);
  unpack_values(in, path.arcs);
  if (!fit(path.arcs, path.moves.size())) in.refuse();
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
