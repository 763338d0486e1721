#include "app/serve/connection.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "app/serve/report_answers.h"

namespace limitgauge::app {
namespace {

/// From the first moment to the end of a request's head, whatever trickles in.
constexpr std::chrono::seconds kLongestAsking{15};
/// Without a byte taken: a browser that halts a download longer has forgotten it.
constexpr std::chrono::seconds kLongestSilence{30};
constexpr std::chrono::seconds kLongestLeaving{1};
/// An honest browser's request is under way when it is connected.
constexpr std::chrono::milliseconds kGraceForAsking{250};
constexpr std::chrono::milliseconds kGraceForReading{2000};
/// Of a file at a time: one browser's large file does not keep others waiting.
constexpr std::uint64_t kChunk = std::uint64_t{1} << 18;

bool would_block() {
  return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

/// Sends the beginning of `part`. How much; 0 where there is no room now, -1 where all is over.
ssize_t send_some(int socket, const AnswerPart& part) {
  std::string chunk;
  const std::string* bytes = &part.text;
  if (part.file) {
    chunk = part.file->read(part.offset, std::min(part.bytes, kChunk));
    // Shorter than it was when its length was told.
    if (chunk.empty()) return -1;
    bytes = &chunk;
  }
  const ssize_t sent = ::send(socket, bytes->data(), bytes->size(), MSG_NOSIGNAL);
  return sent < 0 && would_block() ? 0 : sent;
}

/// Takes off what was sent; true where nothing is left of it.
bool take_off(AnswerPart& part, std::uint64_t sent) {
  if (part.file) {
    part.offset += sent;
    part.bytes -= sent;
  } else {
    part.text.erase(0, sent);
  }
  return part.size() == 0;
}

}  // namespace

Connection::Connection(int socket, Clock::time_point now) : socket_(socket), since_(now) {}

Connection::~Connection() {
  ::close(socket_);
}

short Connection::wanted() const {
  return stage_ == Stage::answering ? POLLOUT : POLLIN;
}

void Connection::enter(Stage stage, Clock::time_point now) {
  stage_ = stage;
  since_ = now;
}

void Connection::go_on(const Answerer& answer, Clock::time_point now) {
  if (stage_ == Stage::asking) hear(answer, now);
  if (stage_ == Stage::leaving) listen_to_end();
  if (stage_ == Stage::answering) say(now);
  // What came together with the request before.
  if (stage_ == Stage::asking && !received_.empty()) answer_next(answer, now);
}

void Connection::hear(const Answerer& answer, Clock::time_point now) {
  char bytes[4096];
  const ssize_t count = ::recv(socket_, bytes, sizeof bytes, 0);
  if (count < 0 && would_block()) return;
  if (count <= 0) {
    enter(Stage::ended, now);
    return;
  }
  received_.append(bytes, static_cast<std::size_t>(count));
  answer_next(answer, now);
}

void Connection::answer_next(const Answerer& answer, Clock::time_point now) {
  const std::optional<std::size_t> length = head_length(received_);
  if (length.value_or(received_.size()) > kLongestHead) {
    refuse(431, "The head of this request is too long.", now);
    return;
  }
  if (!length) return;
  const auto head = request_of(std::string_view(received_).substr(0, *length));
  received_.erase(0, *length);
  if (const auto* refused = std::get_if<RefusedHead>(&head))
    refuse(refused->status, refused->why, now);
  else
    start(answer(std::get<HttpRequest>(head)), now);
}

void Connection::refuse(int status, const std::string& why, Clock::time_point now) {
  HttpAnswer answer = refusal(status, why);
  // Where the next request begins is not known.
  answer.ends_connection = true;
  start(std::move(answer), now);
}

void Connection::start(HttpAnswer answer, Clock::time_point now) {
  is_last_ = answer.ends_connection;
  more_may_come_ = answer.status >= 400;
  to_send_ = parts_of(std::move(answer));
  enter(Stage::answering, now);
}

/// One chunk of a file at most: others shall have their turn.
void Connection::say(Clock::time_point now) {
  for (bool turn_over = false; !turn_over && !to_send_.empty();) {
    turn_over = to_send_.front().file != nullptr;
    const ssize_t sent = send_some(socket_, to_send_.front());
    if (sent < 0) {
      enter(Stage::ended, now);
      return;
    }
    if (sent == 0) return;
    since_ = now;
    if (take_off(to_send_.front(), static_cast<std::uint64_t>(sent))) to_send_.pop_front();
  }
  if (to_send_.empty()) end_answer(now);
}

void Connection::end_answer(Clock::time_point now) {
  if (!is_last_) {
    enter(Stage::asking, now);
  } else if (more_may_come_) {
    // Closed at once, with something of the other side unread, the answer itself could be lost.
    enter(Stage::leaving, now);
    ::shutdown(socket_, SHUT_WR);
  } else {
    enter(Stage::ended, now);
  }
}

void Connection::listen_to_end() {
  char bytes[4096];
  const ssize_t count = ::recv(socket_, bytes, sizeof bytes, 0);
  if (count == 0 || (count < 0 && !would_block())) stage_ = Stage::ended;
}

void Connection::look_at_clock(Clock::time_point now) {
  const auto waited = now - since_;
  if (stage_ == Stage::asking && waited > kLongestAsking) {
    if (received_.empty())
      enter(Stage::ended, now);
    else
      refuse(408, "The head of this request did not come to its end.", now);
  } else if ((stage_ == Stage::answering && waited > kLongestSilence) ||
             (stage_ == Stage::leaving && waited > kLongestLeaving)) {
    enter(Stage::ended, now);
  }
}

bool Connection::may_give_way(Clock::time_point now) const {
  return now - since_ > (stage_ == Stage::answering ? kGraceForReading : kGraceForAsking);
}

bool Connection::gives_way_before(const Connection& other) const {
  const bool sends = stage_ == Stage::answering, other_sends = other.stage_ == Stage::answering;
  return sends != other_sends ? other_sends : since_ < other.since_;
}

}  // namespace limitgauge::app
