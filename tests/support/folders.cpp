#include "tests/support/folders.h"

namespace limitgauge::tests {

const std::filesystem::path& fixtures() {
  static const std::filesystem::path folder = LIMITGAUGE_FIXTURES;
  return folder;
}

}  // namespace limitgauge::tests
