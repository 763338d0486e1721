#include "app/commands.h"

namespace limitgauge::app {

ExitCode execute(const CompareCommand&, const CommonOptions&, const Console&) {
  throw UsageError("compare: under construction");
}

}  // namespace limitgauge::app
