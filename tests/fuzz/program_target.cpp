#include <sstream>

#include "model/gcode/program.h"
#include "tests/fuzz/reading.h"

using namespace limitgauge;

namespace {

/// A machine that states everything a program may ask for.
model::MachineSetup stated_machine() {
  model::MachineSetup machine;
  double place_mm = 10;
  for (auto& offset : machine.work_offsets) {
    offset = model::WorkOffset{{place_mm, -place_mm, place_mm / 2}, place_mm};
    place_mm += 10;
  }
  machine.home_mm = model::Vec3{0, 0, 300};
  machine.second_home_mm = model::Vec3{-50, 200, 250};
  for (int number = 1; number <= 9; ++number)
    machine.tools.push_back({number, 50.0 + number, 2.0 * number});
  return machine;
}

model::MachineSetup fresh_machine() {
  model::MachineSetup machine;
  machine.assume_fresh_machine = true;
  return machine;
}

void require_finite(const model::Motion& motion) {
  fuzz::require(is_finite(motion.to), "every motion ends at a finite place");
  fuzz::require(is_finite(model::Vec3{motion.centre1, motion.centre2, motion.turns}),
                "every arc has a finite centre and count of turns");
  fuzz::require(motion.feed_mm_min >= 0, "no feed rate is negative or no number");
}

void read_on(const model::MachineSetup& machine, const std::string& text) {
  fuzz::answer([&] {
    std::istringstream in(text);
    for (const model::Motion& motion : read_program(in, "program.ngc", machine).motions)
      require_finite(motion);
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const model::MachineSetup stated = stated_machine(), fresh = fresh_machine();
  const std::string text = fuzz::text_of(data, size);
  read_on(stated, text);
  read_on(fresh, text);
  for (const model::Control control : model::kControls) {
    if (control == model::Control::linuxcnc) continue;
    model::MachineSetup machine = stated;
    machine.control = control;
    read_on(machine, text);
  }
  return 0;
}
