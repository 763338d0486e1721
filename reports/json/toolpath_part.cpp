#include "reports/json/toolpath_part.h"

namespace limitgauge::reports::json {

Json toolpath_part(const StageResult::Ran& r) {
  return {
      {"moves", r.path ? r.path->moves.size() : 0},
      {"planes", r.planes},
      {"sampling_interval", {{"min", r.sampling_interval_min}, {"max", r.sampling_interval_max}}},
      {"sampling_intervals", r.sampling_intervals},
      {"cut_length_mm", finite("toolpath.cut_length_mm", r.cut_length_mm)},
      {"rapid_length_mm", finite("toolpath.rapid_length_mm", r.rapid_length_mm)},
      {"machining_time_s", finite("toolpath.machining_time_s", r.machining_time_s)},
      {"chord_error_mm", finite("toolpath.chord_error_mm", r.path ? r.path->chord_error_mm : 0)},
      {"ignored_words", texts(r.ignored_words)},
      {"seconds", finite("toolpath.seconds", r.plan_seconds)},
      {"memory_bytes", r.path_memory_bytes}};
}

}  // namespace limitgauge::reports::json
