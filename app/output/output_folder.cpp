#include "app/output/output_folder.h"

#include <unistd.h>

#include <fstream>
#include <system_error>

#include "model/base/error.h"

namespace limitgauge::app {
namespace fs = std::filesystem;
namespace {

/// A folder with a trailing slash has no file name: take the one before it.
fs::path without_slash(const fs::path& path) {
  const fs::path absolute = fs::absolute(path).lexically_normal();
  return absolute.has_filename() ? absolute : absolute.parent_path();
}

fs::path sibling(const fs::path& target, const std::string& kind) {
  std::string name = target.filename().string();
  name.insert(0, 1, '.');
  return target.parent_path() / (name + "." + kind + "-" + std::to_string(getpid()));
}

bool is_empty_folder(const fs::path& path) {
  return fs::is_directory(path) && fs::is_empty(path);
}

/// A finished run has a result, a comparison, a study or a listed history its own, a finished plan
/// a toolpath in each of its folders.
bool was_written_here(const fs::path& folder) {
  if (!fs::is_directory(folder)) return false;
  for (const char* mark : {"result.json", "compare.json", "study.json", "history.json"})
    if (fs::exists(folder / mark)) return true;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (!fs::exists(entry.path() / "toolpath.ngc")) return false;
  }
  return true;
}

void require_free(const fs::path& target, bool force) {
  if (!fs::exists(target) || is_empty_folder(target)) return;
  if (!was_written_here(target)) {
    throw model::InputError({target.string(), 0, 0}, "this is no output folder of limitgauge",
                            "a new folder (-o), so that nothing of yours is overwritten");
  }
  if (!force) {
    throw model::InputError({target.string(), 0, 0}, "the output folder exists already",
                            "another one (-o), or --force to overwrite it");
  }
}

/// The topmost folder above `path` that does not exist yet; empty where all do.
fs::path first_missing_parent(const fs::path& path) {
  fs::path missing;
  for (fs::path at = path.parent_path(); !at.empty() && !fs::exists(at); at = at.parent_path()) {
    missing = at;
  }
  return missing;
}

void remove_empty_folders(const fs::path& from, const fs::path& up_to) {
  std::error_code ignored;
  for (fs::path at = from; !up_to.empty() && fs::remove(at, ignored); at = at.parent_path()) {
    if (at == up_to) break;
  }
}

}  // namespace

OutputFolder::OutputFolder(fs::path target, bool force)
    : target_(without_slash(target)), working_(sibling(target_, "partial")) {
  require_free(target_, force);
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!fs::exists(working_, ignored)) return;
  fs::remove_all(working_, ignored);
  remove_empty_folders(working_.parent_path(), created_parent_);
}

void OutputFolder::prepare() {
  created_parent_ = first_missing_parent(target_);
  std::error_code error;
  fs::create_directories(working_, error);
  if (!error) return;
  const std::string wrong = "cannot make an output folder here: " + error.message();
  if (error == std::errc::no_space_on_device) {
    throw model::ResourceError(target_.string() + ": error: " + wrong);
  }
  throw model::InputError({target_.string(), 0, 0}, wrong, "a folder that can be written");
}

void OutputFolder::finish() {
  std::error_code error;
  const fs::path old = sibling(target_, "old");
  if (fs::exists(target_)) fs::rename(target_, old, error);
  if (!error) fs::rename(working_, target_, error);
  if (error) {
    std::error_code ignored;
    if (fs::exists(old, ignored)) fs::rename(old, target_, ignored);
    throw model::ResourceError(target_.string() +
                               ": error: cannot give the results their name: " + error.message());
  }
  fs::remove_all(old, error);
}

fs::path OutputFolder::keep_incomplete(const std::string& note) {
  fs::path kept = target_;
  kept += ".incomplete";
  std::error_code error;
  fs::remove_all(kept, error);
  std::ofstream(working_ / "INCOMPLETE.txt") << note << '\n';
  fs::rename(working_, kept, error);
  return error ? working_ : kept;
}

}  // namespace limitgauge::app
