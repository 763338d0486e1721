#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace limitgauge::simulator {

/// What a piece of work may take before its process is ended.
struct ProcessLimits {
  std::size_t memory_bytes = 0;  ///< beyond what this process has already
  unsigned cpu_seconds = 0;
  unsigned wall_seconds = 0;  ///< for work that waits for ever, on a lock that nobody gives back
  std::size_t answer_bytes = 0;
};

/// Does `work` in a process of its own, of which nothing comes back but the bytes that it answers:
/// none if it broke down, let an exception out, ran out of memory, took too long or had more to
/// say. For libraries that a broken file breaks: whoever asks must take the answer for a stranger's
/// as well. The process leaves what a terminal or a scheduler says to this one, and ends when this
/// one does. Throws ResourceError where no process can be started, where its answer finds no room,
/// and where somebody else killed it, as a system does that is short of memory.
std::optional<std::string> answer_of_own_process(const std::function<std::string()>& work,
                                                 const ProcessLimits& limits);

}  // namespace limitgauge::simulator
