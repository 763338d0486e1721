#include "model/mesh/mesh_defect.h"
#include "simulator/grid/vdb_answer.h"
#include "tests/fuzz/reading.h"

using namespace limitgauge;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::answer([&] {
    const auto stock = simulator::read_vdb_answer(fuzz::text_of(data, size), "stock.vdb");
    fuzz::require(!find_defect(stock.mesh), "a stock that was read bounds a solid");
    fuzz::require(stock.voxel_mm > 0, "voxels have a size");
    fuzz::require(stock.blunt_mm > 0, "edges are blunt");
  });
}
