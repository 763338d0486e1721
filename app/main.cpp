#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "app/cli/commands.h"
#include "app/cli/error_message.h"
#include "app/cli/terminal.h"
#include "app/output/interrupt.h"
#include "app/output/standard_stream.h"
#include "model/base/memory.h"

namespace limitgauge::app {
namespace {

/// What was to be read and is lost is no success, whatever the verdict was.
ExitCode unless_lost(ExitCode code, StandardStream& out) {
  const std::string failure = out.failure();
  if (failure.empty()) return code;
  std::cerr << "limitgauge: error: standard output cannot be written: " << failure << std::endl;
  return code == ExitCode::bad_input ? code : ExitCode::resources;
}

int run(int argc, char** argv) {
  hold_standard_descriptors();
  model::spare_addresses();
  const char* term = std::getenv("TERM");
  StandardStream out(STDOUT_FILENO);
  const Console console{out,
                        std::cerr,
                        may_colour(isatty(STDOUT_FILENO) == 1, std::getenv("NO_COLOR"), term),
                        may_redraw(isatty(STDERR_FILENO) == 1, term),
                        columns_of(STDOUT_FILENO, 120),
                        [] { return columns_of(STDERR_FILENO, 80); },
                        &catch_interrupts()};
  return static_cast<int>(unless_lost(run_command_line(argc, argv, console), out));
}

/// Before the libraries that the program is linked with set themselves up: one of OpenVDB's starts
/// threads then, and where it cannot, nothing of ours has had its turn yet.
[[gnu::section(".preinit_array"),
  gnu::used]] void (*const before_libraries)() = &end_instead_of_aborting;

}  // namespace
}  // namespace limitgauge::app

int main(int argc, char** argv) {
  return limitgauge::app::run(argc, argv);
}
