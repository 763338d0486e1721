#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace limitgauge::study {

/// A process that is asked and answers line by line, over a socket that is its standard input and
/// output. Its errors go where ours go.
class WorkerProcess {
 public:
  /// Throws model::ResourceError where it cannot be started.
  explicit WorkerProcess(const std::vector<std::string>& command);
  /// Ends it, hard where it does not end by itself at once.
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// To wait for with poll(2): something to read, or the process has ended.
  int descriptor() const { return socket_; }
  pid_t id() const { return process_; }
  /// What cannot be sent to a process that has ended is dropped: lines() will tell.
  void send(const std::string& line);
  /// What it has answered by now; does not wait. Sets ended() once there will be no more.
  std::vector<std::string> lines();
  bool ended() const { return ended_; }

  /// Asks it to give up what it does.
  void interrupt();
  /// Waits for its end and kills it where it takes longer; says how it ended, in words.
  std::string end(std::chrono::milliseconds patience);

 private:
  bool reaped_within(std::chrono::milliseconds patience);

  pid_t process_ = -1;
  int socket_ = -1;
  bool ended_ = false;
  std::optional<int> status_;
  std::string unread_;
};

}  // namespace limitgauge::study
