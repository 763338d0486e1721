#pragma once

#include <optional>

namespace limitgauge::app {

/// A socket that listens on 127.0.0.1 and waits for nobody.
class Listener {
 public:
  /// On `port`, or on a free one where it is 0. Throws UsageError for a port that cannot be had,
  /// ResourceError where the machine has no socket left.
  explicit Listener(int port);
  ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  int socket() const { return socket_; }
  int port() const { return port_; }

  struct Accepted {
    int socket = -1;         ///< connected, does not block; -1 where nobody waits
    bool exhausted = false;  ///< somebody waits, and the machine has nothing left to take him with
  };
  /// Throws std::runtime_error where the socket listens no more.
  Accepted accept() const;

 private:
  int socket_ = -1;
  int port_ = 0;
};

}  // namespace limitgauge::app
