#include "reports/run/report.h"
#include "reports/text/embedded.h"

namespace limitgauge::reports {

const std::string& result_schema() {
  static const std::string text{embedded::result_schema()};
  return text;
}

}  // namespace limitgauge::reports
