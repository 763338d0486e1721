#pragma once

#include <atomic>

namespace limitgauge::app {

/// Makes SIGINT, SIGTERM and SIGHUP set the returned flag instead of ending the program; a second
/// one ends it at once. What does not see the flag within kMostToStop_ms is ended all the same,
/// with the exit code of an interruption; what it leaves the next run removes. A write beyond the
/// file size limit, and one to a pipe that nobody reads, becomes an error of the write.
const std::atomic<bool>& catch_interrupts();

/// Whoever stops a program waits for two seconds at most: this leaves time to be noticed.
inline constexpr int kMostToStop_ms = 1700;

}  // namespace limitgauge::app
