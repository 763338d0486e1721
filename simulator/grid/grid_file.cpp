#include "simulator/grid/grid_file.h"

#include <openvdb/io/Archive.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include "model/base/error.h"
#include "model/base/output_file.h"

namespace limitgauge::simulator::vdb {
namespace {

void take_away(const std::filesystem::path& file) {
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
}

[[noreturn]] void refuse(const std::filesystem::path& file, int reason) {
  take_away(file);
  throw model::ResourceError(file.string() + ": error: cannot write the file" +
                             (reason == 0 ? "" : std::string(": ") + std::strerror(reason)));
}

// The same bytes as OpenVDB's own file, which does not notice that a disk is full: it would leave
// half a stock and say nothing.
class GridWriter : public openvdb::io::Archive {
 public:
  void write_to(std::ostream& out, const openvdb::GridCPtrVec& grids) const {
    write(out, grids, /*seekable=*/true);
  }
};

// OpenVDB puts a random identifier of 36 characters behind the magic number, three version words
// and a flag; the same stock is to give the same bytes.
void fix_identifier(const std::filesystem::path& file) {
  constexpr std::streamoff kIdentifierOffset = 8 + 3 * 4 + 1;
  std::fstream f(file, std::ios::in | std::ios::out | std::ios::binary);
  f.seekp(kIdentifierOffset);
  f << "00000000-0000-0000-0000-000000000000";
  errno = 0;
  f.close();
  if (!f) refuse(file, errno);
}

}  // namespace

void start_openvdb() {
  static const bool started = (openvdb::initialize(), true);
  static_cast<void>(started);
}

openvdb::FloatGrid::ConstPtr turned(const openvdb::FloatGrid& grid, const model::Pose& pose) {
  const auto place = [&](double i, double j, double k) {
    const openvdb::Vec3d p = grid.transform().indexToWorld(openvdb::Vec3d(i, j, k));
    return pose.point({p.x(), p.y(), p.z()});
  };
  // A row of OpenVDB's matrix is where a step along one index leads, the last is the origin.
  const model::Vec3 origin = place(0, 0, 0);
  openvdb::Mat4R matrix = openvdb::Mat4R::identity();
  const model::Vec3 steps[] = {place(1, 0, 0) - origin, place(0, 1, 0) - origin,
                               place(0, 0, 1) - origin, origin};
  for (int row = 0; row < 4; ++row)
    for (int axis = 0; axis < 3; ++axis) matrix(row, axis) = steps[row][axis];
  return openvdb::gridConstPtrCast<openvdb::FloatGrid>(
      grid.copyGridReplacingTransform(openvdb::math::Transform::createLinearTransform(matrix)));
}

void write_grid(const openvdb::FloatGrid& grid, const std::filesystem::path& file,
                double blunt_mm) {
  try {
    // Writing a grid notes statistics in its metadata, too: give it a shallow copy of its own.
    openvdb::MetaMap meta(grid);
    meta.insertMeta(kBluntName, openvdb::DoubleMetadata(blunt_mm));
    const openvdb::GridCPtrVec grids = {grid.copyGridReplacingMetadata(meta)};
    model::write_file(file, [&](std::ostream& out) { GridWriter().write_to(out, grids); });
    fix_identifier(file);
  } catch (const openvdb::Exception&) {
    // What it says is of its insides; no grid of ours is one that it cannot write.
    refuse(file, 0);
  } catch (const model::ResourceError&) {
    take_away(file);
    throw;
  }
}

}  // namespace limitgauge::simulator::vdb
