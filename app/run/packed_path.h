#pragma once

#include <memory>

#include "model/base/packed_bytes.h"
#include "model/part/toolpath.h"

namespace limitgauge::app {

/// A path to the last bit.
void pack_path(model::Packer& out, const model::Toolpath& path);
/// Refuses one with a move to no place.
model::Toolpath unpack_path(model::Unpacker& in);

/// How a tool stands along a path, or that it stands upright throughout (null).
void pack_axes(model::Packer& out, const model::ToolAxes* axes);
/// Refuses what is not how a tool stands along `path`.
std::shared_ptr<const model::ToolAxes> unpack_axes(model::Unpacker& in,
                                                   const model::Toolpath& path);

}  // namespace limitgauge::app
