#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/e2e/running_program.h"

namespace limitgauge::e2e {

/// What a finished run looks like from outside, with a secret beside it.
void write_finished(const Scratch& scratch);

/// `limitgauge view` at work.
class Viewer {
 public:
  /// `in_child` is done before the program begins.
  explicit Viewer(const Scratch& scratch, std::vector<std::string> more = {"--no-browser"},
                  const std::function<void()>& in_child = {});

  const std::string& said() const { return said_; }
  int port() const { return port_; }
  pid_t id() const { return program_.id(); }
  int end(int signal) { return program_.end(signal); }
  std::string host() const { return "127.0.0.1:" + std::to_string(port_); }
  /// All that comes back on a connection of its own. `fields`: further lines of the head.
  std::string ask(const std::string& first, const std::string& host,
                  const std::string& fields = {}) const;
  std::string get(const std::string& path, const std::string& fields = {}) const {
    return ask("GET " + path, host(), fields);
  }

 private:
  RunningProgram program_;
  std::string said_;
  int port_ = 0;
};

std::string body_of(const std::string& answer);
int status_of(const std::string& answer);

}  // namespace limitgauge::e2e
