// vdb_seeds FOLDER - writes small .vdb files of many kinds, for the fuzz target to start from.
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/points/PointConversion.h>
#include <openvdb/tools/LevelSetSphere.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "simulator/grid/grid_file.h"

namespace {

namespace io = openvdb::io;
using Folder = std::filesystem::path;

/// Within one node of the topmost kind, which has 130 kB where it is not compressed.
openvdb::FloatGrid::Ptr ball(const std::string& name = "stock", double radius_mm = 1) {
  auto grid = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(
      static_cast<float>(radius_mm), {4, 4, 4}, 0.5F);
  grid->setName(name);
  return grid;
}

void write(const Folder& file, const openvdb::GridPtrVec& grids,
           std::uint32_t compression = io::Archive::DEFAULT_COMPRESSION_FLAGS,
           bool statistics = true) {
  io::File out(file.string());
  out.setCompression(compression);
  out.setGridStatsMetadataEnabled(statistics);
  out.write(grids);
  out.close();
}

template <class Grid>
typename Grid::Ptr other(const typename Grid::ValueType& value) {
  auto grid = Grid::create();
  grid->setName("other");
  grid->tree().setValueOn({1, 2, 3}, value);
  return grid;
}

openvdb::GridBase::Ptr points() {
  const std::vector<openvdb::Vec3R> places = {{0, 0, 0}, {1, 2, 3}};
  const auto transform = openvdb::math::Transform::createLinearTransform(0.5);
  auto grid =
      openvdb::points::createPointDataGrid<openvdb::points::NullCodec,
                                           openvdb::points::PointDataGrid>(places, *transform);
  grid->setName("points");
  return grid;
}

void write_compressions(const Folder& folder) {
  const std::uint32_t mask = io::COMPRESS_ACTIVE_MASK;
  const std::vector<std::pair<const char*, std::uint32_t>> kinds = {
      {"none", io::COMPRESS_NONE},   {"mask", mask},
      {"zip", io::COMPRESS_ZIP},     {"zip_mask", io::COMPRESS_ZIP | mask},
      {"blosc", io::COMPRESS_BLOSC}, {"blosc_mask", io::COMPRESS_BLOSC | mask}};
  for (const auto& [name, flags] : kinds)
    write(folder / (std::string(name) + ".vdb"), {ball()}, flags);
  write(folder / "no_statistics.vdb", {ball()}, mask, false);
}

void write_kinds(const Folder& folder) {
  auto half = ball();
  half->setSaveFloatAsHalf(true);
  write(folder / "half.vdb", {half}, io::COMPRESS_ACTIVE_MASK);
  auto bare = ball();
  bare->clearMetadata();
  write(folder / "bare.vdb", {bare}, io::COMPRESS_ACTIVE_MASK, false);
  auto turned = ball();
  turned->transform().preRotate(0.3, openvdb::math::Z_AXIS);
  write(folder / "turned.vdb", {turned});
  auto frustum = ball();
  frustum->setTransform(openvdb::math::Transform::createFrustumTransform(
      openvdb::BBoxd({0, 0, 0}, {10, 10, 10}), 0.5, 2, 1));
  write(folder / "frustum.vdb", {frustum});
  auto tiles = ball();
  tiles->tree().addTile(2, {64, 0, 0}, -1.5F, false);
  tiles->tree().addTile(1, {0, 64, 0}, 1.5F, true);
  write(folder / "tiles.vdb", {tiles}, io::COMPRESS_ACTIVE_MASK);
  write(folder / "empty.vdb", {openvdb::FloatGrid::create(1.5F)});
}

void write_several(const Folder& folder) {
  write(folder / "two.vdb", {ball("other"), ball()});
  auto shared = ball();
  auto instance = openvdb::gridPtrCast<openvdb::FloatGrid>(shared->copyGrid());
  instance->setName("instance");
  write(folder / "instance.vdb", {instance, shared}, io::COMPRESS_ACTIVE_MASK);
  write(folder / "vectors.vdb", {other<openvdb::Vec3SGrid>({1, 2, 3}), ball()});
  write(folder / "double.vdb", {other<openvdb::DoubleGrid>(1.5)});
  write(folder / "whole.vdb",
        {other<openvdb::Int32Grid>(7), other<openvdb::BoolGrid>(true), ball()});
  write(folder / "points.vdb", {points(), ball()});
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) return std::fputs("usage: vdb_seeds FOLDER\n", stderr), 2;
  const Folder folder(words[1]);
  std::filesystem::create_directories(folder);
  limitgauge::simulator::vdb::start_openvdb();
  limitgauge::simulator::vdb::write_grid(*ball("stock", 2), folder / "stock.vdb", 1);
  write_compressions(folder);
  write_kinds(folder);
  write_several(folder);
}
