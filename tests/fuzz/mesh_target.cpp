#include <sstream>

#include "model/mesh/mesh_defect.h"
#include "model/mesh/mesh_reader.h"
#include "tests/fuzz/reading.h"

using namespace limitgauge;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::answer([&] {
    std::istringstream in(fuzz::text_of(data, size));
    const model::MeshReading reading = model::read_mesh(in, LIMITGAUGE_FUZZ_MESH);
    fuzz::require(!find_defect(reading.mesh), "a mesh that was read bounds a solid");
    fuzz::require(volume_mm3(reading.mesh) != 0, "a mesh that was read has a volume");
  });
}
