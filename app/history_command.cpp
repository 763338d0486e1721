#include "app/commands.h"

namespace limitgauge::app {

ExitCode execute(const HistoryCommand&, const CommonOptions&, const Console&) {
  throw UsageError("history: under construction");
}

}  // namespace limitgauge::app
