#include <cmath>
#include <sstream>

#include "model/gcode/cl_data.h"
#include "tests/fuzz/reading.h"

using namespace limitgauge;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::answer([&] {
    std::istringstream in(fuzz::text_of(data, size));
    const model::ClData read = model::read_cl_data(in, "program.apt");
    fuzz::require(!read.from || is_finite(*read.from), "a path starts at a finite place");
    for (const model::Move& move : read.moves)
      fuzz::require(is_finite(move.to), "every move ends at a finite place");
    fuzz::require(read.axes.empty() || read.axes.size() == read.moves.size(),
                  "a path that turns its tool has an axis for each move");
    for (const model::Vec3& axis : read.axes)
      fuzz::require(std::abs(length(axis) - 1) < 1e-9, "an axis is a unit vector");
  });
}
