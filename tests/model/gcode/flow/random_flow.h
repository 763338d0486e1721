#pragma once

#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace limitgauge::model::test {

/// What a random program may hold. LinuxCNC carries out some mixtures otherwise than documented,
/// and the reader refuses them: while_loops and loops_without_jumps have
/// none of these.
enum class FlowMixture : std::uint8_t { while_loops, do_loops, loops_without_jumps, everything };

/// A statement of a random program; lines are set when its text is written.
struct FlowStatement {
  enum class Kind : std::uint8_t {
    move,     // G0 X#100 Y#1
    shuffle,  // #100 = [[#100 * 3 + number] MOD 7]
    add,      // #1 = [#1 + number]
    choose,   // if #100 GT number, elseif #100 EQ number, else; by the count of bodies
    while_loop,
    do_loop,
    repeat,
    break_loop,
    continue_loop,
    call,  // or M98, then #100 = [[#<_value> + #<_value_returned>] MOD 7]
    leave  // return or M99
  };
  Kind kind = Kind::move;
  int label = 0;
  int number = 0;  // of the kind's text; turns of a loop, runs of a program
  int unit = 0;    // called
  bool is_recursive = false;
  std::vector<std::vector<FlowStatement>> bodies;
  int line = 0;
};

/// The main program, a subroutine or a Fanuc program. Unit 0 is the main program.
struct FlowUnit {
  bool is_program = false, is_named = false, is_before_main = false;
  std::vector<FlowStatement> body;
};

/// A block that moves: its line, X and Y.
struct FlowMove {
  int line = 0, x = 0, y = 0;
  friend bool operator==(const FlowMove&, const FlowMove&) = default;
};

struct RandomFlow {
  std::vector<FlowUnit> units;
  std::string text;
};

RandomFlow random_flow(std::mt19937& random, FlowMixture mixture);
/// What the program does, from its statements and not from its text; empty where it goes on for
/// more than `most_moves` moves or nine calls deep.
std::vector<FlowMove> moves_of(const RandomFlow& program, std::size_t most_moves);

}  // namespace limitgauge::model::test
