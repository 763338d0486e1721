#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "app/output/interrupt.h"

int main(int argc, char** argv) {
  using namespace limitgauge::app;
  const char* term = std::getenv("TERM");
  const Console console{std::cout,
                        std::cerr,
                        may_colour(isatty(STDOUT_FILENO) == 1, std::getenv("NO_COLOR"), term),
                        may_redraw(isatty(STDERR_FILENO) == 1, term),
                        columns_of(STDOUT_FILENO, 120),
                        [] { return columns_of(STDERR_FILENO, 80); },
                        &catch_interrupts()};
  return static_cast<int>(run_command_line(argc, argv, console));
}
