#include "tests/model/gcode/flow/flow_run.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

/// A subroutine that calls the next one, `count` times over; the last one moves.
std::string chain_of_calls(int count) {
  std::string text;
  for (int i = 1; i <= count; ++i) {
    const std::string label = "o" + std::to_string(i);
    text += label + " sub\n" +
            (i < count ? "o" + std::to_string(i + 1) + " call\n" : std::string("X1\n")) + label +
            " endsub\n";
  }
  return text + "o1 call\n";
}

}  // namespace

TEST_CASE("a loop without end is found, with a motion or without", "[unit][program][flow]") {
  CHECK(lines_of("X1\n o1 while [1]\no1 endwhile\n") ==
        "1 flow.ngc:2:2: error: a loop without end: more than 500000 blocks without a motion; "
        "expected a loop that ends");
  const std::string in_line_one =
      "flow.ngc:1:1: error: a loop without end: more than 500000 blocks without a motion; "
      "expected a loop that ends";
  CHECK(lines_of("o1 do\n#1=0\no1 while [1]\n") == in_line_one);
  CHECK(lines_of("o1 repeat [1000000]\no2 repeat [0]\no2 endrepeat\no1 endrepeat\n") ==
        in_line_one);
  CHECK(lines_of("M98 P2 L1000000\nM30\nO2\nM99\n") == in_line_one);
  gcode::FlowLimits limits;
  limits.most_blocks = 10;
  limits.most_times_before = 0;
  // The motion of the fifth turn is the tenth block.
  CHECK(lines_of("o1 while [1]\nX1\no1 endwhile\n", limits) ==
        "2 2 2 2 flow.ngc:1:1: error: a loop without end: more than 10 blocks in loops and "
        "subroutines; expected a loop that ends");
}

TEST_CASE("blocks and bytes in loops are bounded, plain ones are not", "[unit][program][flow]") {
  gcode::FlowLimits limits;
  limits.most_blocks = 4;
  limits.most_times_before = 0;
  CHECK(lines_of(repeated("X1\n", 50), limits).ends_with(" 50"));
  CHECK(lines_of("o1 repeat [3]\nX1\no1 endrepeat\n", limits).find("without end") !=
        std::string::npos);
  // Each line before a call allows for more.
  limits.most_times_before = 1;
  CHECK(lines_of("\n\no1 repeat [3]\nX1\no1 endrepeat\n", limits) == "4 4 4");
  limits = {};
  limits.most_bytes = 60;
  limits.most_times_before = 0;
  CHECK(lines_of("o1 repeat [2]\nX1 (12345678)\no1 endrepeat\n", limits) == "2 2");
  CHECK(lines_of("o1 repeat [2]\nX1 (123456789012345678901234567890)\no1 endrepeat\n", limits)
            .find("0 MB of blocks") != std::string::npos);
}

TEST_CASE("blocks that move begin the count of idle ones anew", "[unit][program][flow]") {
  gcode::FlowLimits limits;
  limits.most_idle_blocks = 6;
  CHECK(lines_of("o1 repeat [9]\nX1\no2 repeat [1]\no2 endrepeat\no1 endrepeat\n", limits) ==
        "2 2 2 2 2 2 2 2 2");
  CHECK(lines_of("o1 repeat [9]\nM8\no2 repeat [2]\no2 endrepeat\no1 endrepeat\n", limits)
            .find("without a motion") != std::string::npos);
}

TEST_CASE("calls are nine deep at most, blocks a hundred", "[unit][program][flow]") {
  CHECK(lines_of(chain_of_calls(9)) == "26");
  CHECK_THAT(lines_of(chain_of_calls(10)),
             ContainsSubstring("flow.ngc:26:1: error: more than 9 calls within each other"));
  const auto nested = [](int count) {
    std::string open, close;
    for (int i = 1; i <= count; ++i) {
      open += "o" + std::to_string(i) + " if [1]\n";
      close = "o" + std::to_string(i) + " endif\n" + close;
    }
    return open + "X1\n" + close;
  };
  CHECK(lines_of(nested(100)) == "101");
  CHECK_THAT(lines_of(nested(101)),
             ContainsSubstring("flow.ngc:101:1: error: more than 100 O words within each other"));
  // Calls and blocks together: 40 blocks in each of three calls.
  std::string text = "M98 P1\nM30\n";
  for (int i = 1; i <= 3; ++i)
    text += "O" + std::to_string(i) + "\n" + [&] {
      std::string body = nested(40);
      return body.replace(body.find("X1"), 2, "M98 P" + std::to_string(i + 1));
    }() + "M99\n";
  CHECK_THAT(lines_of(text + "O4\nM99\n"),
             ContainsSubstring("more than 100 loops, conditions and calls within each other"));
}

TEST_CASE("a label opens one span only", "[unit][program][flow]") {
  CHECK_THAT(lines_of("o1 if [0]\no1 endif\no1 if [1]\no1 endif\n"),
             ContainsSubstring("flow.ngc:3:1: error: o1 was used in line 1"));
  CHECK_THAT(lines_of("o1 if [0]\no2 while [0]\no1 if [0]\n"),
             ContainsSubstring("flow.ngc:3:1: error: o1 is open already, since line 1"));
  // In a branch that is not carried out nothing is used; LinuxCNC does the same.
  CHECK(lines_of("o1 if [0]\no2 if [1]\no2 endif\no1 endif\no2 if [1]\nX1\no2 endif\n") == "6");
}

TEST_CASE("what is open when a span ends is named", "[unit][program][flow]") {
  CHECK(lines_of("o1 if [1]\nX1\no2 if [1]\no1 endif\no2 endif\n") ==
        "flow.ngc:4:1: error: 'o1 endif' inside 'o2 if' in line 3; expected 'o2 endif' first");
  CHECK_THAT(lines_of("o1 while [1]\no1 endrepeat\n"), ContainsSubstring("expected 'o1 endwhile'"));
  CHECK_THAT(lines_of("o1 do\no1 endwhile\n"), ContainsSubstring("expected 'o1 while' first"));
  CHECK_THAT(lines_of("o1 repeat [1]\no1 else\no1 endrepeat\n"),
             ContainsSubstring("'o1 else' inside 'o1 repeat'"));
  CHECK_THAT(lines_of("o<a b> sub\no<ab> endif\n"),
             ContainsSubstring("'o<ab> endif' inside 'o<ab> sub'"));
}

TEST_CASE("what LinuxCNC does otherwise than it says is refused", "[unit][program][flow]") {
  const std::string do_loop = "#9=0\no9 do\n#9=[#9+1]\nX#9\no9 while [#9 LT 2]\n";
  // It forgets a break out of a while loop at the next do loop only.
  CHECK_THAT(lines_of("o1 while [1]\no1 break\no1 endwhile\n" + do_loop),
             ContainsSubstring("7 flow.ngc:8:1: error: LinuxCNC would leave this do loop after one "
                               "turn, because of the break in line 2"));
  // It meets the break when it goes over the body at the end, too.
  CHECK_THAT(lines_of("o1 while [0]\no1 break\no1 endwhile\n" + do_loop),
             ContainsSubstring("the break in line 2"));
  CHECK(lines_of("o1 while [0]\no1 endwhile\n" + do_loop) == "6 6");
  // A break out of a do loop is forgotten in time.
  CHECK(lines_of("o1 do\no1 break\no1 while [1]\n" + do_loop) == "7 7");
  // It goes over a break behind continue as well.
  CHECK_THAT(lines_of("#1=0\no1 do\n#1=[#1+1]\no1 continue\no1 break\no1 while [#1 LT 3]\n"),
             ContainsSubstring("flow.ngc:6:1"));
  // A continue in a do loop is forgotten at the end of the next other loop only.
  const std::string continued = "#1=0\no1 do\n#1=[#1+1]\no1 continue\no1 while [#1 LT 2]\n";
  CHECK_THAT(lines_of(continued + "o2 while [1]\no2 break\no2 endwhile\n"),
             ContainsSubstring("flow.ngc:7:1: error: LinuxCNC would not leave this loop"));
  CHECK_THAT(lines_of(continued + "o2 repeat [2]\nX1\no2 endrepeat\n"),
             ContainsSubstring("7 7 flow.ngc:8:1: error: LinuxCNC would carry out this repeat "
                               "twice, because of the continue in line 4"));
  CHECK(lines_of(continued + "o3 while [0]\no3 endwhile\no2 repeat [2]\nX1\no2 endrepeat\n") ==
        "9 9");
  CHECK(lines_of(continued + "o3 repeat [0]\no3 endrepeat\no2 repeat [2]\nX1\no2 endrepeat\n") ==
        "9 9");
  // It goes on with the count of a repeat that was not carried out to its end.
  const std::string left = "o1 sub\no2 repeat [2]\nX1\no1 return\no2 endrepeat\no1 endsub\n";
  CHECK(lines_of(left + "o1 call\no1 call\n") == "3 3");
  CHECK_THAT(lines_of(left + "o1 call\no1 call\no1 call\n"),
             ContainsSubstring("3 3 flow.ngc:2:1: error: 'o2 repeat' was not carried out to its "
                               "end before"));
  CHECK_THAT(lines_of("o1 sub\no2 repeat [2]\no3 if [#1 EQ 1]\no1 call\no3 endif\no2 endrepeat\n"
                      "o1 endsub\no1 call [1]\n"),
             ContainsSubstring("flow.ngc:6:1: error: 'o2 repeat' was not carried out"));
}

TEST_CASE("text behind the end of a program is gone over when a call is sought",
          "[unit][program][flow]") {
  CHECK(lines_of("o1 call\nM2\nX#7 no block\n(o1 sub)\no1 sub\nX1\no1 endsub\n") == "6 2");
}

TEST_CASE("calls and loops cost nothing for the text between", "[unit][program][flow]") {
  // Looked through for each turn, this text would cost 20 000 times 200 000 lines.
  const std::string text = "o1 repeat [20000]\no2 call\no3 if [0]\n" + repeated("X1\n", 200'000) +
                           "o3 endif\no1 endrepeat\nM2\no2 sub\no2 endsub\n";
  CHECK(lines_of(text) == "200006");
}
