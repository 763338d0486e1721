#pragma once

#include <filesystem>

#include "simulator/grid/vdb_tree.h"

namespace limitgauge::simulator::vdb {

/// Registers OpenVDB's types, once.
void start_openvdb();
/// The same grid gives the same bytes. Throws ResourceError when the file cannot be written.
void write_grid(const openvdb::FloatGrid& grid, const std::filesystem::path& file);

}  // namespace limitgauge::simulator::vdb
