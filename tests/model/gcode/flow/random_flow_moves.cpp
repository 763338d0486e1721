#include <map>
#include <optional>

#include "tests/model/gcode/flow/random_flow.h"

namespace limitgauge::model::test {
namespace {

using Kind = FlowStatement::Kind;

constexpr int kCalls = 9;

struct TooLong {};

/// Carries out statements with C++'s own loops and calls.
class Walker {
 public:
  Walker(const RandomFlow& program, std::size_t most_moves)
      : program_(program), most_moves_(most_moves) {}

  std::vector<FlowMove> moves() {
    first_ = 1;
    body(program_.units[0].body);
    return moves_;
  }

 private:
  /// How a body was left: by its end, by return, or by break or continue of a loop.
  struct Exit {
    enum class Way : std::uint8_t { end, leave, break_loop, continue_loop } way = Way::end;
    int label = 0;
  };
  using Way = Exit::Way;

  Exit body(const std::vector<FlowStatement>& statements) {
    for (const FlowStatement& statement : statements) {
      const Exit exit = walk(statement);
      if (exit.way != Way::end) return exit;
    }
    return {};
  }

  Exit walk(const FlowStatement& statement) {
    if (++steps_ > 20 * most_moves_) throw TooLong();
    switch (statement.kind) {
      case Kind::move:
        if (moves_.size() == most_moves_) throw TooLong();
        moves_.push_back({statement.line, shared_, first_});
        return {};
      case Kind::shuffle:
        shared_ = (shared_ * 3 + statement.number) % 7;
        return {};
      case Kind::add:
        first_ += statement.number;
        return {};
      case Kind::choose:
        return choose(statement);
      case Kind::break_loop:
        return {Way::break_loop, statement.label};
      case Kind::continue_loop:
        return {Way::continue_loop, statement.label};
      case Kind::call:
        return call(statement), Exit();
      case Kind::leave:
        result_ = shared_ + statement.number;
        return {Way::leave, 0};
      default:
        return loop(statement);
    }
  }

  Exit choose(const FlowStatement& statement) {
    if (shared_ > statement.number) return body(statement.bodies[0]);
    if (statement.bodies.size() > 1 && shared_ == statement.number)
      return body(statement.bodies[1]);
    if (statement.bodies.size() > 2) return body(statement.bodies[2]);
    return {};
  }

  Exit loop(const FlowStatement& statement) {
    const bool tests_last = statement.kind == Kind::do_loop;
    for (int turn = 0; tests_last ? turn == 0 || turn < statement.number : turn < statement.number;
         ++turn) {
      const Exit exit = body(statement.bodies[0]);
      const bool is_mine = exit.label == statement.label;
      if (exit.way == Way::break_loop && is_mine) return {};
      if (exit.way == Way::end || (exit.way == Way::continue_loop && is_mine)) continue;
      return exit;
    }
    return {};
  }

  void call(const FlowStatement& statement) {
    if (statement.is_recursive && first_ <= 1) return;
    if (statement.is_recursive) first_ -= 2;
    const FlowUnit& unit = program_.units[static_cast<std::size_t>(statement.unit)];
    for (int run = 0; run < (unit.is_program ? 1 + statement.number % 2 : 1); ++run) {
      if (++depth_ > kCalls) throw TooLong();
      const int kept = first_;
      if (!unit.is_program && !statement.is_recursive) first_ += statement.number;
      const Exit exit = body(unit.body);
      --depth_;
      if (!unit.is_program) first_ = kept;  // programs share #1, and return nothing
      returned_ = exit.way == Way::leave && !unit.is_program ? 1 : 0;
      value_ = returned_ == 1 ? result_ : 0;
    }
    shared_ = (value_ + returned_) % 7;
  }

  const RandomFlow& program_;
  std::size_t most_moves_, steps_ = 0;
  std::vector<FlowMove> moves_;
  int shared_ = 0, first_ = 0, result_ = 0, value_ = 0, returned_ = 0, depth_ = 0;
};

}  // namespace

std::vector<FlowMove> moves_of(const RandomFlow& program, std::size_t most_moves) {
  try {
    return Walker(program, most_moves).moves();
  } catch (const TooLong&) {
    return {};
  }
}

}  // namespace limitgauge::model::test
