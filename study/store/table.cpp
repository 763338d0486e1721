#include "study/store/table.h"

namespace limitgauge::study {

const char* name(Status status) {
  switch (status) {
    case Status::pass:
      return "pass";
    case Status::fail:
      return "fail";
    case Status::indeterminate:
      return "indeterminate";
    case Status::error:
      return "error";
    case Status::lost:
      break;
  }
  return "lost";
}

}  // namespace limitgauge::study
