#include "simulator/grid/grid_file.h"

#include <openvdb/io/File.h>

#include <fstream>

#include "model/base/error.h"

namespace limitgauge::simulator::vdb {
namespace {

// OpenVDB puts a random identifier of 36 characters behind the magic number, three version words
// and a flag; the same stock is to give the same bytes.
void fix_identifier(const std::filesystem::path& file) {
  constexpr std::streamoff kIdentifierOffset = 8 + 3 * 4 + 1;
  std::fstream f(file, std::ios::in | std::ios::out | std::ios::binary);
  f.seekp(kIdentifierOffset);
  f << "00000000-0000-0000-0000-000000000000";
  f.close();
  if (!f) throw model::ResourceError(file.string() + ": cannot be written");
}

}  // namespace

void start_openvdb() {
  static const bool started = (openvdb::initialize(), true);
  static_cast<void>(started);
}

void write_grid(const openvdb::FloatGrid& grid, const std::filesystem::path& file) {
  try {
    openvdb::io::File out(file.string());
    // Writing a grid notes statistics in its metadata: give it a shallow copy of its own.
    out.write({grid.copyGrid()});
    out.close();
  } catch (const openvdb::Exception& e) {
    throw model::ResourceError(file.string() + ": cannot be written: " + e.what());
  }
  fix_identifier(file);
}

}  // namespace limitgauge::simulator::vdb
