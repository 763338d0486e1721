#include "app/output/process_memory.h"

#include <fstream>
#include <string>

namespace limitgauge::app {

void reset_process_peak() {
  std::ofstream("/proc/self/clear_refs") << "5\n";
}

std::uint64_t process_peak_bytes() {
  std::ifstream in("/proc/self/status");
  for (std::string name; in >> name;) {
    std::uint64_t kib = 0;
    if (name == "VmHWM:" && in >> kib) return kib * 1024;
  }
  return 0;
}

}  // namespace limitgauge::app
