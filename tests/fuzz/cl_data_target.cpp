#include <sstream>

#include "model/gcode/cl_data.h"
#include "tests/fuzz/reading.h"

using namespace limitgauge;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::answer([&] {
    std::istringstream in(fuzz::text_of(data, size));
    const model::Toolpath path = model::read_cl_data(in, "program.apt").path;
    fuzz::require(is_finite(path.start), "a path starts at a finite place");
    for (const model::Move& move : path.moves)
      fuzz::require(is_finite(move.to), "every move ends at a finite place");
  });
}
