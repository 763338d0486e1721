#include <sstream>

#include "model/part/cage_obj.h"
#include "tests/fuzz/reading.h"

using namespace limitgauge;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  model::Cage cage;
  bool is_cage = false;
  fuzz::answer([&] {
    std::istringstream in(fuzz::text_of(data, size));
    cage = model::read_cage_obj(in, "cage.obj");
    is_cage = true;
  });
  if (!is_cage) return 0;
  // What was read can be written, and is then the same cage.
  std::stringstream written;
  write_cage_obj(cage, written);
  const model::Cage again = model::read_cage_obj(written, "cage.obj");
  fuzz::require(again.vertices == cage.vertices && again.face_corners == cage.face_corners &&
                    again.face_offsets == cage.face_offsets && again.holes == cage.holes &&
                    again.creases.size() == cage.creases.size() &&
                    again.corners.size() == cage.corners.size() && again.boundary == cage.boundary,
                "a cage that was written reads back as the same cage");
  return 0;
}
