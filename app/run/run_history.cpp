#include "app/run/run_history.h"

#include <algorithm>
#include <fstream>
#include <utility>

#include "app/cli/error_message.h"
#include "model/base/absolute_path.h"
#include "model/base/error.h"
#include "reports/history/run_entry.h"
#include "reports/record/record_reader.h"

namespace limitgauge::app {
namespace fs = std::filesystem;
namespace {

bool is_within(const fs::path& file, const fs::path& folder) {
  std::error_code ignored;
  const fs::path inner = fs::weakly_canonical(model::absolute_path(file), ignored);
  fs::path outer = fs::weakly_canonical(model::absolute_path(folder), ignored);
  if (!outer.has_filename()) outer = outer.parent_path();
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

}  // namespace

RunHistory::RunHistory(HistoryOptions options, const fs::path& output)
    : options_(std::move(options)) {
  if (options_.file.empty()) return;
  if (is_within(options_.file, output))
    throw model::InputError({options_.file.string(), 0, 0},
                            "the history would be lost with the output folder that it is in",
                            "a place outside of it");
  recorder_.emplace(options_.file);
}

std::int64_t RunHistory::add(const fs::path& folder) const {
  const fs::path result = folder / "result.json";
  try {
    std::ifstream in(result);
    history::Entry entry =
        reports::history_report::entry_of(reports::record::read_result_json(in, result.string()));
    entry.label = options_.label;
    entry.commit = options_.commit;
    return recorder_->append(entry);
  } catch (const std::exception& error) {
    throw model::ResourceError(message_of(error) +
                               "\nlimitgauge: the run is finished and its result is in " +
                               folder.string() + ", but it is not in the history");
  }
}

}  // namespace limitgauge::app
