#pragma once

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace limitgauge::study {

struct Spawned {
  pid_t process = -1;
  int error = 0;  ///< an errno; 0 where the process was started
};

/// Starts `command`, its first word looked for in PATH, with descriptors of ours as descriptors of
/// its own ({ours, its}) and with no signal held back. In a process group of its own where `apart`:
/// the terminal's Ctrl-C then is not for it.
Spawned spawn(const std::vector<std::string>& command,
              const std::vector<std::pair<int, int>>& descriptors, bool apart = false);

/// What a program printed until its end.
struct Printed {
  int exit_code = -1;  ///< minus the signal that ended it
  std::string out, errors;
};

/// When a program is no longer waited for.
struct ProgramPatience {
  std::chrono::milliseconds longest = std::chrono::seconds(60);
  const std::atomic<bool>* stop = nullptr;  ///< not once this is set
  bool goes_on = false;                     ///< it comes to its end by itself then, or is killed
};

/// Runs a program to its end, apart, with nothing on its standard input. One that is not waited for
/// any longer has exit code -1, or -SIGKILL, and `errors` says so. Throws model::ResourceError
/// where it cannot be started.
Printed run_program(const std::vector<std::string>& command, const ProgramPatience& patience = {});

}  // namespace limitgauge::study
