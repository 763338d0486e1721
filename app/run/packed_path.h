#pragma once

#include "model/base/packed_bytes.h"
#include "model/part/toolpath.h"

namespace limitgauge::app {

/// A path to the last bit.
void pack_path(model::Packer& out, const model::Toolpath& path);
/// Refuses one with a move to no place.
model::Toolpath unpack_path(model::Unpacker& in);

}  // namespace limitgauge::app
