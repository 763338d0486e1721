#include "tests/e2e/shell.h"

#include <sys/wait.h>

#include <cstdio>
#include <stdexcept>

#include "tests/e2e/program.h"

namespace limitgauge::e2e {

ShellOutcome bash(const std::string& script) {
  const Scratch scratch;
  write_text(scratch / "script", script);
  FILE* pipe = popen(("bash " + (scratch / "script").string() + " 2>&1").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("popen failed");
  ShellOutcome outcome;
  char part[4096];
  for (std::size_t got = 0; (got = fread(part, 1, sizeof part, pipe)) > 0;)
    outcome.out.append(part, got);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
  return outcome;
}

bool is_installed(const std::string& program) {
  return bash("command -v " + program).exit_code == 0;
}

}  // namespace limitgauge::e2e
