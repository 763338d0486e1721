#include "study/execute/slurm_submitter.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include "model/base/error.h"
#include "model/base/output_file.h"

namespace limitgauge::study {
namespace fs = std::filesystem;
namespace {

constexpr const char* kSign = "submitter";
constexpr std::chrono::seconds kBetweenTouches{20};
/// Ninety touches missed: no file system is behind by that much, and no swapped-out machine.
constexpr std::chrono::minutes kSilenceOfTheDead{30};
/// A worker that is told to end needs less.
constexpr std::chrono::milliseconds kLongestEnd{2000};

class File {
 public:
  File(const fs::path& path, int flags)
      : descriptor_(::open(path.c_str(), flags | O_CLOEXEC, 0600)) {}
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  int descriptor() const { return descriptor_; }
  int release() { return std::exchange(descriptor_, -1); }
  bool lock() const { return descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0; }

 private:
  int descriptor_;
};

/// Of this machine since it was started: no other has it.
std::string machine() {
  std::string id;
  std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), id);
  return id;
}

[[noreturn]] void cannot_sign(const fs::path& file, int reason) {
  throw model::ResourceError(
      file.string() + ": error: cannot make this study's sign of life: " + std::strerror(reason));
}

/// When a file was touched, by the clock of its file system, which is asked by making another.
bool is_silent(const File& sign, const fs::path& folder) {
  const fs::path now = folder / ("." + std::to_string(::getpid()) + ".now");
  const File probe(now, O_CREAT | O_WRONLY | O_TRUNC);
  ::unlink(now.c_str());
  struct stat then {
  }, here{};
  if (::fstat(sign.descriptor(), &then) != 0 || ::fstat(probe.descriptor(), &here) != 0)
    return false;
  return std::chrono::seconds(here.st_mtim.tv_sec - then.st_mtim.tv_sec) > kSilenceOfTheDead;
}

/// A study's name, as this program gives them: nobody else's jobs are called that.
bool is_name(const std::string& name) {
  constexpr std::string_view kBegin = "limitgauge-";
  return name.starts_with(kBegin) && name.size() > kBegin.size() &&
         name.find_first_not_of("0123456789abcdef", kBegin.size()) == std::string::npos;
}

/// Whether a sign's maker is dead. Takes the lock, so that nobody else comes to the same
/// conclusion.
bool is_orphaned(const File& sign, const fs::path& file) {
  struct stat about {};
  if (::fstat(sign.descriptor(), &about) != 0 || about.st_uid != ::geteuid()) return false;
  const bool locked = sign.lock();
  if (!locked && errno == EWOULDBLOCK) return false;
  std::string of;
  std::getline(std::ifstream(file), of);
  // Empty: another that cleans up has been quicker.
  if (of.empty()) return false;
  return (locked && of == machine()) || is_silent(sign, file.parent_path());
}

void cancel_orphan(const fs::path& folder, const SlurmCommands& commands,
                   const std::function<void(const std::string&)>& note) {
  const std::string name = folder.filename().string();
  const File sign(folder / kSign, O_RDWR);
  if (sign.descriptor() < 0 || !is_orphaned(sign, folder / kSign)) return;
  if (!commands.cancel(name) || !commands.wait_for_cancelled(name, kLongestEnd)) {
    note("jobs " + name +
         " of a study that was killed are not gone yet: the next study sees to it");
    return;
  }
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  note("jobs " + name + " of a study that was killed were cancelled; its results are kept");
}

}  // namespace

SlurmSubmitter::SlurmSubmitter(fs::path folder) : file_(folder / kSign) {
  model::make_folder(folder);
  // Locked before it has its name: nobody sees it without its lock.
  const fs::path part = folder / (std::string(kSign) + ".part");
  File sign(part, O_CREAT | O_EXCL | O_RDWR);
  // A file system without locks: only the touching tells of this study then.
  const std::string content = (sign.lock() ? machine() : "unlocked") + "\n";
  if (sign.descriptor() < 0 ||
      ::write(sign.descriptor(), content.data(), content.size()) !=
          static_cast<ssize_t>(content.size()) ||
      ::rename(part.c_str(), file_.c_str()) != 0)
    cannot_sign(file_, errno);
  try {
    toucher_ = std::thread([this] { keep_touching(); });
  } catch (const std::system_error& error) {
    ::unlink(file_.c_str());
    cannot_sign(file_, error.code().value());
  }
  descriptor_ = sign.release();
}

SlurmSubmitter::~SlurmSubmitter() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  ending_.notify_all();
  toucher_.join();
  if (!leaves_) ::unlink(file_.c_str());
  ::close(descriptor_);
}

void SlurmSubmitter::keep_touching() {
  std::unique_lock lock(mutex_);
  while (!ending_.wait_for(lock, kBetweenTouches, [this] { return ends_; }))
    ::utimensat(AT_FDCWD, file_.c_str(), nullptr, 0);
}

void cancel_orphans(const fs::path& folder, const SlurmCommands& commands,
                    const std::function<void(const std::string&)>& note) {
  std::error_code missing;
  std::vector<fs::path> studies;
  for (fs::directory_iterator at(folder, missing), end; !missing && at != end;
       at.increment(missing))
    if (is_name(at->path().filename().string())) studies.push_back(at->path());
  std::sort(studies.begin(), studies.end());
  for (const fs::path& study : studies) cancel_orphan(study, commands, note);
}

}  // namespace limitgauge::study
