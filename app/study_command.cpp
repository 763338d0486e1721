#include "app/commands.h"

namespace limitgauge::app {

ExitCode execute(const StudyCommand&, const CommonOptions&, const Console&) {
  throw UsageError("study: under construction");
}

}  // namespace limitgauge::app
