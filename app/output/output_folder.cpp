#include "app/output/output_folder.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>

#include <cerrno>
#include <system_error>

#include "app/output/manifest.h"
#include "model/base/absolute_path.h"
#include "model/base/error.h"
#include "model/base/output_file.h"

namespace limitgauge::app {
namespace fs = std::filesystem;
namespace {

/// Folders that are kept beside each other under one name and a number.
constexpr int kMostKept = 99;
/// Others may remove the empty folders above in the very moment in which we are to use them.
constexpr int kTries = 10;

/// A folder with a trailing slash has no file name: take the one before it.
fs::path absolute_place(const fs::path& path) {
  const fs::path absolute = model::absolute_path(path).lexically_normal();
  return absolute.has_filename() ? absolute : absolute.parent_path();
}

/// The old name is free afterwards: it stands for a folder that was there or not.
fs::path resolved(const fs::path& target) {
  const fs::path place = model::behind_links(target);
  return place.has_filename() ? place.lexically_normal() : place.parent_path().lexically_normal();
}

[[noreturn]] void refuse(const fs::path& target, const std::string& wrong,
                         const std::string& expected) {
  throw model::InputError({target.string(), 0, 0}, wrong, expected);
}

/// Nothing can be renamed to the name of what is mounted.
bool is_mounted(const fs::path& folder) {
  struct statx about {};
  return ::statx(AT_FDCWD, folder.c_str(), 0, 0, &about) == 0 &&
         (about.stx_attributes_mask & STATX_ATTR_MOUNT_ROOT) != 0 &&
         (about.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
}

/// True for what a finished run may take the name of without anything being lost.
bool is_free(const fs::path& target) {
  std::error_code error;
  const fs::file_status there = fs::status(target, error);
  if (there.type() == fs::file_type::not_found) return true;
  if (error) refuse(target, "the output folder cannot be reached: " + error.message(), "another");
  if (!fs::is_directory(there)) refuse(target, "this is a file", "a folder");
  const bool empty = fs::is_empty(target, error);
  if (error) refuse(target, "the output folder cannot be read: " + error.message(), "another");
  if (empty && is_mounted(target))
    refuse(target, "this is where a file system is mounted, which can take no other folder's place",
           "a folder in it");
  return empty;
}

/// The seal of what stands there, which may be replaced; nothing where nothing does.
std::optional<std::string> seal_of_replaced(const fs::path& target, bool force) {
  if (is_free(target)) return std::nullopt;
  std::optional<std::string> seal = seal_of(target);
  if (!seal)
    refuse(target, "this is no output folder of limitgauge",
           "a new folder (-o), so that nothing of yours is overwritten");
  if (!force)
    refuse(target, "the output folder exists already",
           "another one (-o), or --force to overwrite it");
  if (const std::optional<fs::path> foreign = foreign_in(target))
    refuse(target / *foreign,
           "limitgauge has not written this as it is, and the folder that is to be overwritten "
           "holds it",
           "it elsewhere, or another output folder (-o)");
  return seal;
}

/// The topmost folder above `path` that does not exist yet; empty where all do.
fs::path first_missing_parent(const fs::path& path) {
  std::error_code ignored;
  fs::path missing;
  for (fs::path at = path.parent_path(); !at.empty() && !fs::exists(at, ignored);
       at = at.parent_path())
    missing = at;
  return missing;
}

void remove_empty_folders(const fs::path& from, const fs::path& up_to) {
  std::error_code ignored;
  for (fs::path at = from; !up_to.empty() && fs::remove(at, ignored); at = at.parent_path()) {
    if (at == up_to) break;
  }
}

[[noreturn]] void refuse_to_make(const fs::path& target, const std::error_code& error) {
  const std::string wrong = "cannot make an output folder here: " + error.message();
  for (const std::errc lack : {std::errc::no_space_on_device, std::errc::too_many_files_open,
                               std::errc::too_many_files_open_in_system})
    if (error == lack) throw model::ResourceError(target.string() + ": error: " + wrong);
  refuse(target, wrong, "a folder that can be written");
}

std::error_code last_error() {
  return {errno, std::generic_category()};
}

/// Exclusively: nobody else works there, and no other run's files are there.
fs::path make_beside(const fs::path& target) {
  std::error_code error;
  for (int i = 0; i < kTries; ++i) {
    const fs::path working = target.parent_path() / working_name(target.filename().string());
    fs::create_directories(target.parent_path(), error);
    if (!error && ::mkdir(working.c_str(), 0777) == 0) return working;
    if (!error) error = last_error();
    if (error != std::errc::no_such_file_or_directory && error != std::errc::file_exists) break;
  }
  refuse_to_make(target, error);
}

/// Both in one step, where the file system can; false where it cannot.
bool exchange(const fs::path& one, const fs::path& other, std::error_code& error) {
  error.clear();
  if (::renameat2(AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE) == 0)
    return true;
  if (errno != EINVAL && errno != ENOSYS && errno != ENOTSUP) error = last_error();
  return false;
}

/// In two steps: `old` is where the one that stood there goes. What comes in between stays.
void exchange_slowly(const fs::path& working, const fs::path& target, const fs::path& old,
                     std::error_code& error) {
  fs::rename(target, old, error);
  if (error) return;
  fs::rename(working, target, error);
  std::error_code ignored;
  if (error) fs::rename(old, target, ignored);
}

bool is_all_ours(const fs::path& folder) noexcept {
  try {
    return seal_of(folder) && !foreign_in(folder);
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& target, bool force)
    : target_(absolute_place(target)),
      place_(resolved(target_)),
      replaced_(seal_of_replaced(place_, force)) {}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (working_.empty()) return;
  if (fs::exists(working_, ignored)) fs::remove_all(working_, ignored);
  remove_empty_folders(working_.parent_path(), created_parent_);
}

void OutputFolder::prepare() {
  created_parent_ = first_missing_parent(place_);
  if (created_parent_.empty()) remove_leftovers(place_.parent_path());
  for (int i = 0; i < kTries && !lock_; ++i) {
    working_ = make_beside(place_);
    lock_ = FolderLock::take(working_);
  }
  if (!lock_) refuse_to_make(target_, std::make_error_code(std::errc::file_exists));
}

void OutputFolder::finish() {
  lock_->leave();
  seal(working_);
  try {
    publish();
  } catch (const model::ResourceError& error) {
    throw NotPublished(std::string(error.what()) + "\nlimitgauge: the results are in " +
                       keep_as("unpublished", false).string());
  }
  lock_.reset();
}

void OutputFolder::publish() {
  std::error_code error;
  if (replaced_ && fs::exists(place_, error)) {
    replace();
    return;
  }
  // Of what stands there only an empty folder gives way, and that in the same step.
  fs::rename(working_, place_, error);
  if (!error) return;
  const bool taken = error == std::errc::directory_not_empty || error == std::errc::file_exists;
  throw model::ResourceError(
      target_.string() + ": error: " +
      (taken ? "other results or files have come to stand here while this run was at work"
             : "cannot give the results their name: " + error.message()));
}

void OutputFolder::replace() {
  const auto is_replaceable = [this](const fs::path& folder) {
    return seal_of(folder) == replaced_ && !foreign_in(folder);
  };
  const auto refuse_changed = [this] {
    throw model::ResourceError(target_.string() +
                               ": error: what was to be overwritten has been changed while this "
                               "run was at work");
  };
  if (!is_replaceable(place_)) refuse_changed();
  std::error_code error;
  fs::path old = working_;
  if (!exchange(working_, place_, error) && !error) {
    old = place_.parent_path() / working_name(place_.filename().string());
    exchange_slowly(working_, place_, old, error);
  }
  if (error)
    throw model::ResourceError(target_.string() +
                               ": error: cannot give the results their name: " + error.message());
  if (is_replaceable(old)) {
    remove_ours(old);
  } else if (exchange(old, place_, error)) {
    refuse_changed();
  }
}

void OutputFolder::fill(const std::function<void()>& work) {
  prepare();
  try {
    work();
    finish();
  } catch (const NotPublished&) {
    throw;
  } catch (const model::ResourceError& error) {
    throw model::ResourceError(named(error.what()));
  }
}

std::string OutputFolder::named(std::string message) const {
  const std::string working = working_.string(), target = target_.string();
  if (working.empty()) return message;
  for (std::size_t at = message.find(working); at != std::string::npos;
       at = message.find(working, at + target.size()))
    message.replace(at, working.size(), target);
  return message;
}

fs::path OutputFolder::keep_as(const std::string& kind, bool replacing) noexcept {
  const std::string name = shortened_name(place_.filename().string()) + "." + kind;
  for (int i = 1; i <= kMostKept; ++i) {
    const fs::path kept = place_.parent_path() / (i == 1 ? name : name + "-" + std::to_string(i));
    std::error_code error;
    if (replacing && is_all_ours(kept)) remove_ours(kept);
    fs::rename(working_, kept, error);
    if (!error) return kept;
  }
  // Under its hidden name, which is nobody's any more.
  return std::exchange(working_, {});
}

fs::path OutputFolder::keep_incomplete(const std::string& note) {
  lock_->leave();
  try {
    model::write_file(working_ / kIncompleteFile, note + "\n");
    seal(working_);
  } catch (const std::exception&) {
    // A full disk: what is there is kept all the same, and nothing proves it ours.
  }
  return keep_as("incomplete", true);
}

std::filesystem::path result_file(const std::filesystem::path& stated) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(stated, ignored)) return stated;
  const std::filesystem::path file = stated / "result.json";
  if (std::filesystem::exists(file, ignored)) return file;
  throw model::InputError({stated.string(), 0, 0}, "has no result.json",
                          "result.json, or the folder of a finished run");
}

void require_no_result(const fs::path& target) {
  std::error_code ignored;
  if (fs::exists(target / "result.json", ignored))
    refuse(target, "that is the result's own folder, and it would be lost", "another one (-o)");
}

}  // namespace limitgauge::app
