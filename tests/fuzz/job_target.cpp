#include <sstream>
#include <vector>

#include "app/job/job_reader.h"
#include "tests/fuzz/reading.h"

using namespace limitgauge;

namespace {

/// Lines `#set key=value` are what the command line's --set would say; to TOML they are comments.
std::vector<std::string> overrides_in(const std::string& text) {
  constexpr std::string_view kMark = "#set ";
  std::vector<std::string> overrides;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(kMark)) overrides.push_back(line.substr(kMark.size()));
  return overrides;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::answer([&] {
    const std::string text = fuzz::text_of(data, size);
    app::read_job_text(text, "job.toml", LIMITGAUGE_FUZZ_JOB_FOLDER, overrides_in(text));
  });
}
