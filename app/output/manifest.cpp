#include "app/output/manifest.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/output/checksum.h"
#include "model/base/error.h"
#include "model/base/output_file.h"

namespace limitgauge::app {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kChecksumDigits = 64;
/// More are synced at once, with what others have written to the same disk: three milliseconds
/// each.
constexpr std::size_t kManyFiles = 100;
/// Between checksum and name, as sha256sum writes it.
constexpr const char* kGap = "  ";
/// Of these each command leaves one at least, wherever in its folder. Others call a list of their
/// own files manifest.sha256, too.
constexpr std::array<std::string_view, 7> kOurs = {"result.json",  "compare.json", "history.json",
                                                   "probe.json",   "study.json",   "toolpath.ngc",
                                                   kIncompleteFile};

using Sums = std::map<std::string, std::string>;  // by path within the folder

/// All that is in `folder`, relative to it, what lies in a folder after it. Links are not followed.
std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  fs::recursive_directory_iterator at(folder, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error))
    found.push_back(at->path().lexically_relative(folder));
  if (error)
    throw model::ResourceError(folder.string() +
                               ": error: the folder cannot be read: " + error.message());
  std::sort(found.begin(), found.end());
  return found;
}

/// What is a folder or a file by itself; a link is neither.
fs::file_type type_of(const fs::path& path) {
  std::error_code error;
  return fs::symlink_status(path, error).type();
}

bool names_ours(const Sums& sums) {
  return std::any_of(sums.begin(), sums.end(), [](const auto& sum) {
    return std::find(kOurs.begin(), kOurs.end(), fs::path(sum.first).filename()) != kOurs.end();
  });
}

/// None where the list is somebody else's: it proves nothing.
Sums stated_sums(const fs::path& folder) {
  Sums sums;
  std::ifstream in(folder / kManifestFile, std::ios::binary);
  for (std::string line; std::getline(in, line);)
    if (line.size() > kChecksumDigits + 2)
      sums[line.substr(kChecksumDigits + 2)] = line.substr(0, kChecksumDigits);
  return names_ours(sums) ? sums : Sums{};
}

bool is_ours(const fs::path& folder, const fs::path& entry, const Sums& sums) {
  const auto stated = sums.find(entry.generic_string());
  if (stated == sums.end() || type_of(folder / entry) != fs::file_type::regular) return false;
  try {
    return file_checksum(folder / entry).sha256 == stated->second;
  } catch (const model::InputError&) {
    return false;
  }
}

bool is_within(const fs::path& entry, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), entry.begin(), entry.end()).first ==
         folder.end();
}

/// A folder that was made here has a file of ours in it, however deep.
bool holds_stated(const fs::path& entry, const Sums& sums) {
  return std::any_of(sums.begin(), sums.end(),
                     [&](const auto& sum) { return is_within(fs::path(sum.first), entry); });
}

void remove_ours_in(const fs::path& folder) {
  const Sums sums = stated_sums(folder);
  std::vector<fs::path> entries = entries_of(folder);
  // What lies in a folder goes before it.
  std::reverse(entries.begin(), entries.end());
  std::error_code not_empty;
  for (const fs::path& entry : entries) {
    const bool is_folder = type_of(folder / entry) == fs::file_type::directory;
    if (is_folder ? holds_stated(entry, sums) : is_ours(folder, entry, sums))
      fs::remove(folder / entry, not_empty);
  }
}

}  // namespace

void seal(const fs::path& folder) {
  std::string text;
  const std::vector<fs::path> entries = entries_of(folder);
  for (const fs::path& entry : entries) {
    if (type_of(folder / entry) != fs::file_type::regular) continue;
    text += file_checksum(folder / entry).sha256 + kGap + entry.generic_string() + "\n";
  }
  model::write_file(folder / kManifestFile, text);
  if (entries.size() > kManyFiles) return model::sync_file_system(folder);
  for (const fs::path& entry : entries) model::sync_file(folder / entry);
  model::sync_file(folder / kManifestFile);
  model::sync_file(folder);
}

std::optional<std::string> seal_of(const fs::path& folder) {
  if (type_of(folder / kManifestFile) != fs::file_type::regular) return std::nullopt;
  return file_checksum(folder / kManifestFile).sha256;
}

Sealed sealed(const fs::path& folder, const fs::path& entry) {
  if (type_of(folder / kManifestFile) != fs::file_type::regular) return Sealed::unknown;
  return is_ours(folder, entry, stated_sums(folder)) ? Sealed::as_written : Sealed::otherwise;
}

std::optional<fs::path> foreign_in(const fs::path& folder) {
  const Sums sums = stated_sums(folder);
  for (const fs::path& entry : entries_of(folder)) {
    if (entry == kManifestFile) continue;
    const bool is_folder = type_of(folder / entry) == fs::file_type::directory;
    if (!(is_folder ? holds_stated(entry, sums) : is_ours(folder, entry, sums))) return entry;
  }
  return std::nullopt;
}

bool remove_ours(const fs::path& folder) {
  std::error_code error;
  try {
    remove_ours_in(folder);
    // Last: what is left by an end in between can be gone on with.
    if (entries_of(folder) == std::vector<fs::path>{kManifestFile})
      fs::remove(folder / kManifestFile, error);
  } catch (const std::exception&) {
    return false;
  }
  return fs::remove(folder, error) && !error;
}

}  // namespace limitgauge::app
