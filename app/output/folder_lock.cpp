#include "app/output/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

#include "app/output/manifest.h"
#include "model/base/error.h"
#include "model/base/output_file.h"

namespace limitgauge::app {
namespace fs = std::filesystem;
namespace {

constexpr const char* kLockFile = ".lock";
constexpr const char* kMark = "limitgauge-lock/1 ";
constexpr const char* kWorking = ".partial-";
constexpr std::size_t kSuffixDigits = 32;
/// Bytes of a name that a hidden one begins with: what is put about it still fits into the 255 that
/// file systems take.
constexpr std::size_t kLongestName = 150;
/// A folder of results that has no lock any more is about to be renamed: that takes no hour.
constexpr std::chrono::hours kRenamed{1};
/// A lock that is free but was taken on another machine may be one that this file system does not
/// tell others of: nobody works a week without a file.
constexpr std::chrono::hours kForgotten{7 * 24};

/// Of the kernel that keeps the locks of this machine, since it was started.
std::string this_machine() {
  std::string id;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> id;
  return id;
}

/// A descriptor that is closed at its end, if it is one.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

bool is_removed(int descriptor) {
  struct stat about {};
  return ::fstat(descriptor, &about) != 0 || about.st_nlink == 0;
}

bool is_older(const fs::path& path, std::chrono::hours age) {
  std::error_code error;
  const fs::file_time_type written = fs::last_write_time(path, error);
  return !error && written < fs::file_time_type::clock::now() - age;
}

bool is_working_name(const std::string& name) {
  const std::size_t mark = name.rfind(kWorking);
  return name.starts_with('.') && mark != std::string::npos && mark > 0 &&
         name.size() - mark == std::strlen(kWorking) + kSuffixDigits &&
         name.find_first_not_of("0123456789abcdef", mark + std::strlen(kWorking)) ==
             std::string::npos;
}

/// The youngest of what is in it: when somebody last worked there.
bool is_forgotten(const fs::path& folder) {
  std::error_code error;
  fs::recursive_directory_iterator at(folder, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error))
    if (!is_older(at->path(), kForgotten)) return false;
  return !error && is_older(folder, kForgotten);
}

/// The process that locked it has ended. A lock that cannot be asked for tells nothing.
bool is_left(const fs::path& folder, int lock) {
  if (::flock(lock, LOCK_EX | LOCK_NB) != 0) return false;
  std::ifstream in(folder / kLockFile);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!text.starts_with(kMark)) return false;
  return text == kMark + this_machine() + "\n" || is_forgotten(folder);
}

/// The lock's file goes last: who is killed in between leaves a leftover again.
void remove_all_of(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    if (at->path().filename() != kLockFile) fs::remove_all(at->path(), ignored);
  }
  fs::remove(folder / kLockFile, error);
  fs::remove(folder, error);
}

void remove_if_left(const fs::path& folder) {
  const Descriptor lock(
      ::open((folder / kLockFile).c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  if (lock.number() >= 0) {
    if (is_left(folder, lock.number())) remove_all_of(folder);
  } else if (errno == ENOENT && is_older(folder, kRenamed)) {
    remove_ours(folder);
  }
}

}  // namespace

FolderLock::FolderLock(fs::path file, int descriptor)
    : file_(std::move(file)), descriptor_(descriptor) {}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

FolderLock& FolderLock::operator=(FolderLock&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::optional<FolderLock> FolderLock::take(const fs::path& folder) {
  fs::path file = folder / kLockFile;
  Descriptor lock(::open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  const std::string text = kMark + this_machine() + "\n";
  if (lock.number() < 0 ||
      ::write(lock.number(), text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
    throw model::ResourceError(file.string() +
                               ": error: cannot write the file: " + std::strerror(errno));
  }
  // A file system without locks: nobody else can take it either, and the folder is left alone.
  if (::flock(lock.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return std::nullopt;
  if (is_removed(lock.number())) return std::nullopt;
  return FolderLock(std::move(file), lock.release());
}

void FolderLock::leave() const {
  std::error_code ignored;
  fs::remove(file_, ignored);
}

std::string shortened_name(const std::string& name) {
  if (name.size() <= kLongestName) return name;
  std::size_t end = kLongestName;
  // Where a character begins.
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;
  return name.substr(0, end);
}

std::string working_name(const std::string& name) {
  return "." + shortened_name(name) + kWorking + model::random_digits();
}

void remove_leftovers(const fs::path& parent) {
  std::error_code error;
  for (fs::directory_iterator at(parent, error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    if (is_working_name(at->path().filename().string()) &&
        fs::symlink_status(at->path(), ignored).type() == fs::file_type::directory)
      remove_if_left(at->path());
  }
}

}  // namespace limitgauge::app
