#include <algorithm>

#include "reports/compare/run_comparison.h"

namespace limitgauge::reports::compare {
namespace fs = std::filesystem;
namespace {

/// The folders that lead to a result, the innermost first; a result of another name than that of a
/// run begins with itself.
std::vector<std::string> parts_of(const fs::path& file) {
  std::vector<std::string> parts;
  const fs::path whole = file.lexically_normal();
  for (const fs::path& part : whole)
    if (!part.empty() && part != "." && part != "/") parts.push_back(part.string());
  std::reverse(parts.begin(), parts.end());
  if (parts.size() > 1 && parts.front() == "result.json") parts.erase(parts.begin());
  return parts;
}

std::string last(const std::vector<std::string>& parts, std::size_t count) {
  std::string out;
  for (std::size_t i = std::min(count, parts.size()); i-- > 0;)
    out += (out.empty() ? "" : "/") + parts[i];
  return out;
}

}  // namespace

void name_runs(Comparison& comparison, const record::RunRecord& base, const fs::path& base_file,
               const record::RunRecord& now, const fs::path& now_file) {
  const std::vector<std::string> a = parts_of(base_file), b = parts_of(now_file);
  std::size_t count = 1;
  while (last(a, count) == last(b, count) && count < std::max(a.size(), b.size())) ++count;
  if (a == b) count = 1;
  comparison.base.name = base.label.empty() ? last(a, count) : base.label;
  comparison.now.name = now.label.empty() ? last(b, count) : now.label;
}

}  // namespace limitgauge::reports::compare
