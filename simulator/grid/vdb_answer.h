#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "simulator/grid/vdb_stock.h"

namespace limitgauge::simulator {

// What the process that reads a .vdb says to the one that asked: a mesh, or why there is none.
// The file may have ruined it, so that what it says is read as a stranger's.

/// Of a mesh that bounds a solid, or does not.
std::string vdb_answer(const VdbStock& stock);
/// Of a file that cannot be used.
std::string vdb_refusal(std::string_view why);
inline constexpr const char* kShortOfMemory =
    "there is not enough memory for the triangles of this stock; a coarser voxel in the run that "
    "wrote it would do";
/// Of a machine that cannot carry the work.
std::string vdb_shortage(std::string_view why);

/// What stands in an answer about `path`. Throws InputError for a refusal, for a mesh that bounds
/// no solid and for an answer that makes no sense; ResourceError for a shortage.
VdbStock read_vdb_answer(std::string_view answer, const std::filesystem::path& path);

}  // namespace limitgauge::simulator
