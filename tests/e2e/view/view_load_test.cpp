#include <arpa/inet.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <list>
#include <sstream>
#include <thread>

#include "tests/e2e/view/viewer.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace {

using LoadClock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using std::chrono::seconds;

/// On a busy machine as well; a client who asks for nothing is waited for longer (kLongestAsking,
/// 15 s).
constexpr seconds kPromptly{10};

/// One connection of a client who need not be in a hurry.
class Client {
 public:
  explicit Client(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval patience{8, 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    REQUIRE(::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
  }
  ~Client() { ::close(socket_); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  void send(const std::string& text) const {
    ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
  }
  void ask(const std::string& path, int port) const {
    send("GET " + path + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
         "\r\nConnection: close\r\n\r\n");
  }
  std::string answer() const {
    std::string all;
    char part[65536];
    for (ssize_t count = 0; (count = ::recv(socket_, part, sizeof part, 0)) > 0;)
      all.append(part, static_cast<std::size_t>(count));
    return all;
  }

 private:
  int socket_;
};

using Clients = std::list<Client>;

/// Some say nothing, some begin a request, some ask for much and read none of it.
void add_slow(Clients& clients, const Viewer& viewer, int count) {
  for (int i = 0; i < count; ++i) {
    const Client& client = clients.emplace_back(viewer.port());
    if (i % 3 == 1) client.send("GET / HTTP/1.1\r\nHost");
    if (i % 3 == 2) client.ask("/rough/stock.vdb", viewer.port());
  }
}

/// How many of `count` clients who come at once are answered with the page. Each asks as soon as it
/// is connected, as browsers do: where room is short, who is silent gives way.
int answered_at_once(const Viewer& viewer, int count) {
  Clients clients;
  for (int i = 0; i < count; ++i)
    clients.emplace_back(viewer.port()).ask("/report.html", viewer.port());
  return static_cast<int>(std::count_if(clients.begin(), clients.end(), [](const Client& client) {
    return body_of(client.answer()) == "<!doctype html><title>page</title>";
  }));
}

/// Processor time of a process and its number of threads.
std::pair<double, int> cost_of(pid_t process) {
  const std::string stat = read_text("/proc/" + std::to_string(process) + "/stat");
  std::istringstream fields(stat.substr(stat.rfind(')') + 2));
  std::vector<std::string> words;
  for (std::string word; fields >> word;) words.push_back(word);
  const double ticks = std::stod(words.at(11)) + std::stod(words.at(12));
  return {ticks / static_cast<double>(::sysconf(_SC_CLK_TCK)), std::stoi(words.at(17))};
}

void few_descriptors() {
  const rlimit limit{64, 64};
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

TEST_CASE("200 slow clients hold up neither others nor the end", "[e2e][view]") {
  const Scratch scratch;
  write_finished(scratch);
  // Larger than what sockets hold: whoever does not read it is waited for.
  write_text(scratch / "out/rough/stock.vdb", std::string(std::size_t{16} << 20, 'x'));
  Viewer viewer(scratch);
  Clients slow;
  add_slow(slow, viewer, 200);
  for (int i = 0; i < 3; ++i) {
    for (const Client& client : slow) client.send("x");
    const auto began = LoadClock::now();
    CHECK(answered_at_once(viewer, 1) == 1);
    CHECK(LoadClock::now() - began < kPromptly);
  }
  CHECK(answered_at_once(viewer, 250) == 250);
  const auto began = LoadClock::now();
  CHECK(viewer.end(SIGTERM) == 0);
  CHECK(LoadClock::now() - began < kPromptly);
}

TEST_CASE("500 connections at once are answered, without a thread for each", "[e2e][view]") {
  const Scratch scratch;
  write_finished(scratch);
  Viewer viewer(scratch);
  // Threads that libraries have are there before.
  const int threads = cost_of(viewer.id()).second;
  Clients slow;
  add_slow(slow, viewer, 50);
  CHECK(answered_at_once(viewer, 500) == 500);
  CHECK(cost_of(viewer.id()).second == threads);
  CHECK(viewer.end(SIGINT) == 0);
}

TEST_CASE("view gets along with few file descriptors", "[e2e][view]") {
  const Scratch scratch;
  write_finished(scratch);
  Viewer viewer(scratch, {"--no-browser"}, few_descriptors);
  CHECK(answered_at_once(viewer, 500) == 500);
  {
    Clients silent;
    add_slow(silent, viewer, 200);
    const auto began = LoadClock::now();
    CHECK(answered_at_once(viewer, 1) == 1);
    CHECK(LoadClock::now() - began < kPromptly);
    // Whoever waits before the door costs nothing.
    add_slow(silent, viewer, 200);
    const double before_s = cost_of(viewer.id()).first;
    std::this_thread::sleep_for(seconds(1));
    CHECK(cost_of(viewer.id()).first - before_s < 0.3);
  }
  CHECK(status_of(viewer.get("/report.html")) == 200);
  CHECK(viewer.end(SIGTERM) == 0);
}

TEST_CASE("view ends at once while it starts", "[e2e][view]") {
  const Scratch scratch;
  write_finished(scratch);
  for (int i = 0; i < 20; ++i) {
    CAPTURE(i);
    RunningProgram program(scratch, {"view", "out", "--no-browser"});
    std::this_thread::sleep_for(milliseconds(4 * (i + 1)));
    const auto began = LoadClock::now();
    const int code = program.end(SIGTERM);
    // Before the program has looked at its signals, they are the system's.
    CHECK((code == 0 || code == -SIGTERM));
    CHECK(LoadClock::now() - began < kPromptly);
  }
}

}  // namespace
}  // namespace limitgauge::e2e
