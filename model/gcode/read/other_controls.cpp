// Which other control would read a program that the stated one does not.
#include <vector>

#include "model/base/error.h"
#include "model/gcode/cl_data.h"
#include "model/gcode/program.h"
#include "model/gcode/text/program_text.h"

namespace limitgauge::model {
namespace {

/// In the order in which they are offered: those with the most programs first.
constexpr std::array kOffered = {Control::haas,  Control::fanuc,   Control::linuxcnc,
                                 Control::mach3, Control::siemens, Control::grbl};

bool reads(Control control, std::string_view text, const std::string& name, MachineSetup machine) {
  machine.control = control;
  try {
    read_program(text, name, machine);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// `--control haas would read it, and so would fanuc, mach3`; empty where none would.
std::string offer(std::string_view text, const std::string& name, const MachineSetup& machine) {
  std::string words;
  std::size_t count = 0;
  for (const Control control : kOffered) {
    if (control == machine.control || !reads(control, text, name, machine)) continue;
    const std::string who(model::name(control));
    words += count == 0   ? "--control " + who + " would read it"
             : count == 1 ? ", and so would " + who
                          : ", " + who;
    ++count;
  }
  return words;
}

}  // namespace

Program read_program_or_name_control(std::string_view text, const std::string& name,
                                     const MachineSetup& machine) {
  try {
    return read_program(text, name, machine);
  } catch (const InputError& error) {
    if (is_cl_data(text, name)) throw;
    const std::string offered = offer(text, name, machine);
    if (offered.empty()) throw;
    throw error.with(offered);
  }
}

Program read_program_or_name_control(const std::filesystem::path& path,
                                     const MachineSetup& machine) {
  return read_program_or_name_control(std::string_view(read_program_text(path)), path.string(),
                                      machine);
}

}  // namespace limitgauge::model
