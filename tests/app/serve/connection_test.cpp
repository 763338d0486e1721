#include "app/serve/connection.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <fstream>

#include "app/serve/report_answers.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::app {
namespace {

using Time = Connection::Clock::time_point;
using std::chrono::milliseconds;
using std::chrono::seconds;

/// A connection with the browser's end of it, and a clock that is set by hand.
class Line {
 public:
  Line() {
    REQUIRE(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends_) == 0);
    connection_.emplace(ends_[1], now_);
  }
  ~Line() { ::close(ends_[0]); }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  Connection& connection() { return *connection_; }
  Time now() const { return now_; }
  void send(const std::string& text) {
    REQUIRE(::send(ends_[0], text.data(), text.size(), MSG_NOSIGNAL) > 0);
    turn();
  }
  void stop_sending() { ::shutdown(ends_[0], SHUT_WR); }
  void pass(milliseconds time) {
    now_ += time;
    connection_->look_at_clock(now_);
  }
  void turn() {
    for (int i = 0; i < 3 && !connection_->has_ended(); ++i)
      connection_->go_on([this](const HttpRequest& request) { return answer_(request); }, now_);
  }
  std::string got() {
    std::string all;
    char part[65536];
    for (ssize_t count = 0; (count = ::recv(ends_[0], part, sizeof part, 0)) > 0;)
      all.append(part, static_cast<std::size_t>(count));
    return all;
  }
  void answer_with(Connection::Answerer answer) { answer_ = std::move(answer); }

 private:
  int ends_[2];
  Time now_{};
  std::optional<Connection> connection_;
  Connection::Answerer answer_ = [](const HttpRequest& request) {
    HttpAnswer answer;
    answer.body.push_back({request.target, nullptr, 0, 0});
    answer.ends_connection = !request.stays;
    return answer;
  };
};

TEST_CASE("requests of one connection are answered one after the other", "[unit][view]") {
  Line line;
  line.send(
      "GET /a HTTP/1.1\r\n\r\nGET /b HTTP/1.1\r\n\r\nGET /c HTTP/1.1\r\nConnection: close\r\n");
  const std::string two = line.got();
  CHECK_THAT(two, ContainsSubstring("\r\n\r\n/a") && ContainsSubstring("\r\n\r\n/b"));
  CHECK_THAT(two, !ContainsSubstring("Connection: close"));
  line.send("\r\nGET /d HTTP/1.1\r\n\r\n");
  const std::string last = line.got();
  CHECK_THAT(last, ContainsSubstring("Connection: close\r\n\r\n/c") && !ContainsSubstring("/d"));
  CHECK(line.connection().has_ended());
}

TEST_CASE("a head that trickles in is given up after 15 s", "[unit][view]") {
  Line line;
  for (int i = 0; i < 15; ++i) {
    line.pass(seconds(1));
    line.send(i == 0 ? "GET / HTTP/1.1\r\nA: " : "x");
    REQUIRE(line.got().empty());
  }
  line.pass(seconds(1));
  line.turn();
  CHECK_THAT(line.got(), ContainsSubstring("408 Request Timeout"));
  line.pass(milliseconds(1100));
  CHECK(line.connection().has_ended());
}

TEST_CASE("who says nothing, and who reads nothing, is given up", "[unit][view]") {
  Line silent;
  silent.pass(seconds(16));
  CHECK(silent.connection().has_ended());

  const tests::TemporaryFolder folder;
  const auto path = folder.path() / "large";
  std::ofstream(path) << std::string(std::size_t{1} << 22, 'x');
  const auto file = std::make_shared<const OpenFile>(::open(path.c_str(), O_RDONLY), 1 << 22);
  Line slow;
  slow.answer_with([&](const HttpRequest&) {
    HttpAnswer answer;
    answer.body.push_back({{}, file, 0, file->bytes()});
    return answer;
  });
  slow.send("GET / HTTP/1.1\r\n\r\n");
  for (int i = 0; i < 4; ++i) {
    slow.pass(seconds(29));
    REQUIRE_FALSE(slow.connection().has_ended());
    REQUIRE_FALSE(slow.got().empty());
    slow.turn();
  }
  slow.pass(seconds(31));
  CHECK(slow.connection().has_ended());
}

TEST_CASE("a head without end, or one that is none, is answered and the connection ends",
          "[unit][view]") {
  Line endless;
  for (int i = 0; i < 5; ++i) endless.send(std::string(4000, 'x'));
  CHECK_THAT(endless.got(), ContainsSubstring("431 ") && ContainsSubstring("Connection: close"));
  // What is still under way is read, so that the answer is not lost.
  endless.send("more");
  CHECK_FALSE(endless.connection().has_ended());
  endless.stop_sending();
  endless.turn();
  CHECK(endless.connection().has_ended());
  Line nonsense;
  nonsense.send("hello\r\n\r\n");
  CHECK_THAT(nonsense.got(), ContainsSubstring("400 ") && ContainsSubstring("Connection: close"));
}

TEST_CASE("a client that has said all that it will say is answered", "[unit][view]") {
  Line line;
  line.send("GET /a HTTP/1.1\r\n");
  line.stop_sending();
  line.turn();
  CHECK(line.connection().has_ended());
  Line whole;
  whole.stop_sending();
  whole.turn();
  CHECK(whole.connection().has_ended());
}

TEST_CASE("a file that has become shorter ends the connection", "[unit][view]") {
  const tests::TemporaryFolder folder;
  const auto path = folder.path() / "file";
  std::ofstream(path) << "0123456789";
  const auto file = std::make_shared<const OpenFile>(::open(path.c_str(), O_RDONLY), 20);
  Line line;
  line.answer_with([&](const HttpRequest&) {
    HttpAnswer answer;
    answer.body.push_back({{}, file, 0, file->bytes()});
    return answer;
  });
  line.send("GET / HTTP/1.1\r\n\r\n");
  CHECK_THAT(line.got(), ContainsSubstring("Content-Length: 20\r\n\r\n0123456789"));
  CHECK(line.connection().has_ended());
}

TEST_CASE("the silent give way first, and nobody at once", "[unit][view]") {
  Line one, other;
  CHECK_FALSE(one.connection().may_give_way(one.now()));
  one.pass(milliseconds(300));
  CHECK(one.connection().may_give_way(one.now()));
  one.send("GET /a HTTP/1.1\r\n\r\n");
  CHECK_FALSE(one.connection().may_give_way(one.now()));
  CHECK(other.connection().gives_way_before(one.connection()));
  CHECK_FALSE(one.connection().gives_way_before(other.connection()));
}

}  // namespace
}  // namespace limitgauge::app
