#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>

namespace limitgauge::app {

/// Serves one folder to this machine's browsers, and to nobody else: it listens on 127.0.0.1 alone,
/// answers only to that name (a page of elsewhere that has its own name point here is refused), and
/// reads only.
class ReportServer {
 public:
  /// Listens on `port`, or on a free one where it is 0. Throws InputError for a folder that cannot
  /// be opened, UsageError for a port that cannot be had.
  ReportServer(const std::filesystem::path& folder, int port);
  ~ReportServer();
  ReportServer(const ReportServer&) = delete;
  ReportServer& operator=(const ReportServer&) = delete;

  /// Where the report is: http://127.0.0.1:PORT/
  std::string address() const;
  /// Serves until `stop` is set. Throws std::runtime_error where the system ends it before.
  void serve(const std::atomic<bool>& stop);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace limitgauge::app
