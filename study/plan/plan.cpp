#include "study/plan/plan.h"

namespace limitgauge::study {

const char* name(Method method) {
  switch (method) {
    case Method::grid:
      return "grid";
    case Method::list:
      return "list";
    case Method::random:
      return "random";
    case Method::latin_hypercube:
      return "latin_hypercube";
    case Method::one_at_a_time:
      return "one_at_a_time";
    case Method::search:
      break;
  }
  return "search";
}

}  // namespace limitgauge::study
