#pragma once

#include <atomic>

namespace limitgauge::app {

/// Makes SIGINT, SIGTERM and SIGHUP set the returned flag instead of ending the program; a second
/// one ends it at once. A write beyond the file size limit becomes an error of the write.
const std::atomic<bool>& catch_interrupts();

}  // namespace limitgauge::app
