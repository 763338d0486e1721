#include "tests/support/effort.h"

#include <cstdlib>

namespace limitgauge::tests {

bool thorough() {
  return std::getenv("LIMITGAUGE_THOROUGH") != nullptr;
}

}  // namespace limitgauge::tests
