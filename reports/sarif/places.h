#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/run/finding_list.h"
#include "reports/sarif/rules.h"

namespace limitgauge::reports::sarif {

/// Where findings are: programs, and lines of them with their text.
class Places {
 public:
  Places(const RunResult& result, const std::vector<std::vector<ListedFinding>>& findings);

  /// A physical location: the program of `stage` and, but for 0, a line of it.
  Json location(std::size_t stage, std::uint32_t line) const;
  /// The text of a line that some finding names, empty where the program has none.
  const std::string& text(std::size_t stage, std::uint32_t line) const;
  /// "artifacts" of the run: each program once.
  const Json& artifacts() const { return artifacts_; }

 private:
  Json artifacts_ = Json::array();
  std::vector<std::size_t> artifact_of_stage_;
  std::map<std::pair<std::size_t, std::uint32_t>, std::string> text_;
};

/// "originalUriBaseIds": what the programs' paths are relative to. Neither folder is named: a
/// report may move, and the same input gives the same bytes anywhere.
Json base_ids();
/// `path` as a URI reference, percent-encoded.
std::string uri_of(std::string_view path);

}  // namespace limitgauge::reports::sarif
