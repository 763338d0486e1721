#include <unistd.h>

#include <iostream>

#include "app/commands.h"
#include "app/interrupt.h"

int main(int argc, char** argv) {
  using namespace limitgauge::app;
  const Console console{std::cout, std::cerr, isatty(STDOUT_FILENO) == 1,
                        isatty(STDERR_FILENO) == 1, &catch_interrupts()};
  return static_cast<int>(run_command_line(argc, argv, console));
}
