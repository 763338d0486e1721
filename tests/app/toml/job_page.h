#pragma once

#include <map>
#include <string>
#include <vector>

namespace limitgauge::app {

/// A row of the tables in docs/job.md and docs/study.md.
struct DocumentedKey {
  std::string unit, fallback, range;
};
/// By dotted key, as `stage.gate.gouge`.
std::map<std::string, DocumentedKey> documented_keys(const std::string& page = "job.md");

/// Jobs that are in order and have every key between them; paths are below fixtures/.
std::vector<std::string> jobs_with_every_key();

}  // namespace limitgauge::app
