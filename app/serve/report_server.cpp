#include "app/serve/report_server.h"

#include <poll.h>
#include <sys/resource.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <vector>

#include "model/base/error.h"

namespace limitgauge::app {
namespace {

/// How long a wait lasts at most: `stop` is looked at that often.
constexpr int kLook_ms = 100;
/// Where there is no room for a newcomer, and where the machine has no descriptor left.
constexpr std::chrono::milliseconds kNextTry{20}, kRest{100};
/// More than all browsers of a machine open; each may have a file of its own open as well.
constexpr std::size_t kMostConnections = 1000;
constexpr std::size_t kDescriptorsEach = 2;
/// What the program itself has open, with the folders on the way to a file.
constexpr std::size_t kOwnDescriptors = 16;

std::size_t most_connections() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return kMostConnections;
  const std::size_t all = std::max<std::size_t>(limit.rlim_cur, kOwnDescriptors);
  return std::clamp<std::size_t>((all - kOwnDescriptors) / kDescriptorsEach, 1, kMostConnections);
}

}  // namespace

ReportServer::ReportServer(const std::filesystem::path& folder, int port)
    : answers_(folder), listener_(port) {
  const std::string number = ":" + std::to_string(listener_.port());
  answers_.answer_to({"127.0.0.1" + number, "localhost" + number});
}

std::string ReportServer::address() const {
  return "http://127.0.0.1:" + std::to_string(listener_.port()) + "/";
}

void ReportServer::serve(const std::atomic<bool>& stop) {
  while (!stop) {
    const bool somebody_is_there = wait();
    serve_connections();
    if (somebody_is_there) take_newcomers();
  }
  ready_.clear();
  connections_.clear();
}

bool ReportServer::wait() {
  const bool open = Clock::now() >= door_opens_;
  std::vector<pollfd> sockets = {{listener_.socket(), static_cast<short>(open ? POLLIN : 0), 0}};
  for (const Connection& one : connections_) sockets.push_back({one.socket(), one.wanted(), 0});
  const int timeout = open ? kLook_ms : static_cast<int>(kNextTry.count());
  ready_.clear();
  if (::poll(sockets.data(), sockets.size(), timeout) < 0) {
    if (errno == EINTR) return false;
    throw model::ResourceError("limitgauge: error: this machine cannot wait for its browsers");
  }
  std::size_t at = 1;
  for (Connection& one : connections_)
    if (sockets[at++].revents != 0) ready_.push_back(&one);
  return open && sockets[0].revents != 0;
}

void ReportServer::serve_connections() {
  const Clock::time_point now = Clock::now();
  for (Connection* one : ready_)
    one->go_on([this](const HttpRequest& request) { return answers_.answer(request); }, now);
  for (Connection& one : connections_) one.look_at_clock(now);
  connections_.remove_if([](const Connection& one) { return one.has_ended(); });
}

/// As many as there is room for; where there is none, room is made for one.
void ReportServer::take_newcomers() {
  const std::size_t most = most_connections();
  if (connections_.size() >= most && !make_room()) door_opens_ = Clock::now() + kNextTry;
  while (connections_.size() < most) {
    const Listener::Accepted accepted = listener_.accept();
    if (accepted.exhausted) {
      door_opens_ = Clock::now() + kRest;
      make_room();
    }
    if (accepted.socket < 0) return;
    connections_.emplace_back(accepted.socket, Clock::now());
  }
}

bool ReportServer::make_room() {
  const Clock::time_point now = Clock::now();
  auto leaving = connections_.end();
  for (auto one = connections_.begin(); one != connections_.end(); ++one) {
    const bool better = leaving == connections_.end() || one->gives_way_before(*leaving);
    if (one->may_give_way(now) && better) leaving = one;
  }
  if (leaving == connections_.end()) return false;
  connections_.erase(leaving);
  return true;
}

}  // namespace limitgauge::app
