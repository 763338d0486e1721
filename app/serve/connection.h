#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <string>

#include "app/serve/http_answer.h"
#include "app/serve/http_request.h"

namespace limitgauge::app {

/// One browser's connection: requests one after the other, each answered before the next is read.
/// It never waits for its browser, who is given up when too slow.
class Connection {
 public:
  using Clock = std::chrono::steady_clock;
  using Answerer = std::function<HttpAnswer(const HttpRequest&)>;

  /// Takes over a connected socket that does not block.
  Connection(int socket, Clock::time_point now);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  int socket() const { return socket_; }
  /// What poll() is to look for.
  short wanted() const;
  /// Does what can be done without waiting, after poll() has found something.
  void go_on(const Answerer& answer, Clock::time_point now);
  /// Gives up what has taken too long.
  void look_at_clock(Clock::time_point now);
  bool has_ended() const { return stage_ == Stage::ended; }

  /// Whether it may be ended for the sake of a newcomer.
  bool may_give_way(Clock::time_point now) const;
  /// Whether it should be the one, rather than `other`: one without a request first, then the one
  /// that has been silent longest.
  bool gives_way_before(const Connection& other) const;

 private:
  enum class Stage {
    asking,     ///< the head of a request has not come yet
    answering,  ///< the other side has not taken all of an answer yet
    leaving,    ///< the other side is to close, having read why it was refused
    ended,
  };
  void enter(Stage stage, Clock::time_point now);
  void hear(const Answerer& answer, Clock::time_point now);
  void answer_next(const Answerer& answer, Clock::time_point now);
  void refuse(int status, const std::string& why, Clock::time_point now);
  void start(HttpAnswer answer, Clock::time_point now);
  void say(Clock::time_point now);
  void end_answer(Clock::time_point now);
  void listen_to_end();

  const int socket_;
  Stage stage_ = Stage::asking;
  Clock::time_point since_;  ///< of this stage, or of the last bytes that were taken
  std::string received_;
  std::deque<AnswerPart> to_send_;
  bool is_last_ = false;        ///< the answer that is being sent
  bool more_may_come_ = false;  ///< of the request that it refuses
};

}  // namespace limitgauge::app
