#pragma once

#include <filesystem>

#include "model/geometry/pose.h"

#include "simulator/grid/vdb_tree.h"

namespace limitgauge::simulator::vdb {

/// Registers OpenVDB's types, once.
void start_openvdb();
/// Name of the double in a grid's metadata that is MeshStock::blunt_mm of a stock taken from it.
inline constexpr const char* kBluntName = "limitgauge_blunt_mm";
/// The same grid gives the same bytes. Throws ResourceError when the file cannot be written.
void write_grid(const openvdb::FloatGrid& grid, const std::filesystem::path& file, double blunt_mm);
/// The same values where places of the grid's frame lie in another: a grid beside `grid` that
/// shares its tree.
openvdb::FloatGrid::ConstPtr turned(const openvdb::FloatGrid& grid, const model::Pose& pose);

}  // namespace limitgauge::simulator::vdb
