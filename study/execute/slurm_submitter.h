#pragma once

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "study/execute/slurm_commands.h"

namespace limitgauge::study {

/// The sign of life of a study that has jobs in Slurm: a file `submitter` in its work folder, which
/// is locked as long as its process lives and touched every twenty seconds.
///
/// By it others know that a study was killed. On the machine that it ran on, the lock says so: the
/// kernel lets go of it with the process. From another machine a lock may not be seen (it depends
/// on the file system); there a study is dead only where its file can be locked and was not touched
/// for half an hour, by the file system's own clock.
class SlurmSubmitter {
 public:
  /// Makes `folder` and the sign. Throws model::ResourceError.
  explicit SlurmSubmitter(std::filesystem::path folder);
  /// Takes the sign away: what is left in the folder is nobody's any more.
  ~SlurmSubmitter();
  /// Leaves the sign, unlocked, when this ends: the next study sees to the jobs and the folder.
  void leave() { leaves_ = true; }
  SlurmSubmitter(const SlurmSubmitter&) = delete;
  SlurmSubmitter& operator=(const SlurmSubmitter&) = delete;

 private:
  void keep_touching();

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::mutex mutex_;
  std::condition_variable ending_;
  bool ends_ = false, leaves_ = false;
  std::thread toucher_;
};

/// Cancels the jobs of studies in `folder` whose submitter was killed, and removes what they left
/// there; results are elsewhere and stay. `note` is told of each. What Slurm does not do within
/// seconds is left for the next. Those of the living, and of other users, are not touched. Does not
/// throw for what cannot be removed.
void cancel_orphans(const std::filesystem::path& folder, const SlurmCommands& commands,
                    const std::function<void(const std::string&)>& note);

}  // namespace limitgauge::study
