#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <list>
#include <string>
#include <vector>

#include "app/serve/connection.h"
#include "app/serve/listener.h"
#include "app/serve/report_answers.h"

namespace limitgauge::app {

/// Serves one folder to this machine's browsers, and to nobody else: it listens on 127.0.0.1 alone,
/// answers only to that name (a page of elsewhere that has its own name point here is refused), and
/// reads only.
///
/// One thread serves all of them in turn and waits for none, so that no number of slow or silent
/// ones holds the others up, or its end. Of so many connections as the machine's descriptors allow,
/// the one that has been silent longest gives way to a newcomer.
class ReportServer {
 public:
  /// Listens on `port`, or on a free one where it is 0. Throws InputError for a folder that cannot
  /// be opened, UsageError for a port that cannot be had, ResourceError.
  ReportServer(const std::filesystem::path& folder, int port);

  /// Where the report is: http://127.0.0.1:PORT/
  std::string address() const;
  /// Serves until `stop` is set, within a tenth of a second. Throws std::runtime_error where the
  /// system ends it before.
  void serve(const std::atomic<bool>& stop);

 private:
  using Clock = Connection::Clock;
  /// Waits for something to do; whether somebody is at the door.
  bool wait();
  void serve_connections();
  void take_newcomers();
  /// False where none of those that are here may go.
  bool make_room();

  ReportAnswers answers_;
  Listener listener_;
  std::list<Connection> connections_;
  std::vector<Connection*> ready_;  ///< of the last wait
  Clock::time_point door_opens_{};  ///< nobody is let in before
};

}  // namespace limitgauge::app
