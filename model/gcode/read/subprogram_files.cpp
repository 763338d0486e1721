#include "model/gcode/read/subprogram_files.h"

#include <algorithm>
#include <system_error>
#include <vector>

#include "model/base/error.h"
#include "model/gcode/text/program_text.h"
#include "model/text/characters.h"

namespace limitgauge::model::gcode {
namespace {

constexpr std::size_t kMostFiles = 100'000;

/// The digits of a program number without leading zeros; empty where the name is none.
std::string number_in(std::string name) {
  if (!name.empty() && upper(name.front()) == 'O') name.erase(0, 1);
  if (name.empty()) return {};
  for (const char c : name)
    if (!is_digit(c)) return {};
  const std::size_t first = name.find_first_not_of('0');
  return first == std::string::npos ? "0" : name.substr(first);
}

bool lies_in(const std::filesystem::path& file, const std::filesystem::path& folder) {
  std::error_code failure;
  const auto real = std::filesystem::canonical(file, failure);
  if (failure) return false;
  return real.parent_path() == std::filesystem::canonical(folder, failure) && !failure &&
         std::filesystem::is_regular_file(real, failure);
}

std::vector<std::filesystem::path> numbered_files(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::directory_iterator entries(folder, failure);
  if (failure)
    throw InputError({folder.string()},
                     "the folder of subprograms cannot be read: " + failure.message(), "a folder");
  std::vector<std::filesystem::path> found;
  std::size_t seen = 0;
  for (; entries != std::filesystem::directory_iterator(); entries.increment(failure)) {
    if (failure || ++seen > kMostFiles)
      throw InputError({folder.string()}, "the folder of subprograms cannot be read to its end",
                       "fewer files");
    const std::filesystem::path& file = entries->path();
    if (!number_in(file.stem().string()).empty() && lies_in(file, folder)) found.push_back(file);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

FindSubprogram subprograms_in(const std::filesystem::path& folder) {
  if (folder.empty()) return {};
  return [folder](const std::string& number) -> std::optional<SubprogramFile> {
    auto found = numbered_files(folder);
    std::erase_if(found, [&](const std::filesystem::path& file) {
      return number_in(file.stem().string()) != number;
    });
    if (found.empty()) return std::nullopt;
    if (found.size() > 1)
      throw InputError({folder.string()},
                       "two files of program O" + number + ", " + found[0].filename().string() +
                           " and " + found[1].filename().string(),
                       "one");
    return SubprogramFile{found.front().string(), read_program_text(found.front())};
  };
}

}  // namespace limitgauge::model::gcode

namespace limitgauge::model {

std::vector<std::filesystem::path> subprogram_files(const std::filesystem::path& folder) {
  if (folder.empty()) return {};
  return gcode::numbered_files(folder);
}

}  // namespace limitgauge::model
