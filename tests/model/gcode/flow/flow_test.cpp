#include "tests/model/gcode/flow/flow_run.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

// The expected lines were worked out by hand, and agree with the motions of LinuxCNC 2.9.

TEST_CASE("a plain program comes line by line", "[unit][program][flow]") {
  CHECK(lines_of("G0 X1\n\n(note)\nX2\nM2\nX3\n") == "1 4 5");
  CHECK(lines_of("") == "");
}

TEST_CASE("if carries out the first branch that holds", "[unit][program][flow]") {
  const auto chosen = [](const std::string& value) {
    return lines_of("#1=" + value +
                    "\no1 if [#1 EQ 1]\nX2\no1 elseif [#1 EQ 2]\nX4\no1 elseif [#1 LT 4]\nX6\n"
                    "o1 else\nX8\no1 endif\nX10\n");
  };
  CHECK(chosen("1") == "3 11");
  CHECK(chosen("2") == "5 11");
  CHECK(chosen("3") == "7 11");
  CHECK(chosen("4") == "9 11");
  // Every value but 0 holds.
  CHECK(lines_of("o1 if [-0.1]\nX1\no1 endif\no2 if [0]\nX2\no2 endif\n") == "2");
}

TEST_CASE("if goes over what stands within it", "[unit][program][flow]") {
  CHECK(lines_of("o1 if [0]\no2 if [1]\nX1\no2 else\nX2\no2 endif\no3 while [1]\no3 endwhile\n"
                 "X#9\no1 else\nX3\no1 endif\n") == "11");
}

TEST_CASE("while tests first and do tests last", "[unit][program][flow]") {
  CHECK(lines_of("#1=0\no1 while [#1 LT 2]\nX1\n#1=[#1+1]\no1 endwhile\nX2\n") == "3 3 6");
  CHECK(lines_of("o1 while [0]\nX1\no1 endwhile\nX2\n") == "4");
  CHECK(lines_of("#1=0\no1 do\nX1\n#1=[#1+1]\no1 while [#1 LT 2]\nX2\n") == "3 3 6");
  CHECK(lines_of("o1 do\nX1\no1 while [0]\nX2\n") == "2 4");
}

TEST_CASE("repeat counts to the nearest integer, halves to the even one", "[unit][program][flow]") {
  const auto turns = [](const std::string& count) {
    return lines_of("o1 repeat [" + count + "]\nX1\no1 endrepeat\n");
  };
  CHECK(turns("3") == "2 2 2");
  CHECK(turns("1.4") == "2");
  CHECK(turns("0.5") == "");
  CHECK(turns("1.5") == "2 2");
  CHECK(turns("2.5") == "2 2");
  CHECK(turns("-4") == "");
}

TEST_CASE("break and continue of an outer loop leave the inner ones", "[unit][program][flow]") {
  const std::string inner =
      "#1=0\no1 while [#1 LT 3]\n#1=[#1+1]\no2 while [1]\nX#1\no3 if [#1 EQ 2]\n";
  const std::string rest = "o3 endif\no1 continue\no2 endwhile\no1 endwhile\nX9\n";
  CHECK(lines_of(inner + "o1 break\n" + rest) == "5 5 12");
  CHECK(lines_of(inner + "o2 break\n" + rest) == "5 5 5 12");
  CHECK(lines_of(inner + "o1 continue\n" + rest) == "5 5 5 12");
}

TEST_CASE("continue in a do loop goes to its condition", "[unit][program][flow]") {
  CHECK(lines_of("#1=0\no1 do\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\nX#1\n"
                 "o1 while [#1 LT 4]\n") == "7 7 7");
  CHECK(lines_of("o1 do\no1 break\nX1\no1 while [1]\nX2\n") == "5");
}

TEST_CASE("a subroutine may stand before or behind its call", "[unit][program][flow]") {
  CHECK(lines_of("o100 sub\nX1\no100 endsub\nX2\no100 call\no100 call\nX3\n") == "4 2 2 7");
  CHECK(lines_of("o<Hole> call\nX2\nM2\no<hole> sub\nX1\no<HOLE> endsub\n") == "5 2 3");
  // Calls of calls, and the number of a name.
  CHECK(lines_of("o1 sub\nX1\no2 call\nX2\no1 endsub\no2 sub\nX3\no2 endsub\no<1> call\n") ==
        "2 7 4");
}

TEST_CASE("calls may calculate the number of their subroutine", "[unit][program][flow]") {
  CHECK(lines_of("o100 sub\nX1\no100 endsub\no101 sub\nX2\no101 endsub\n#5=100\no#5 call\n"
                 "o[#5+1] call\n") == "2 5");
}

TEST_CASE("return leaves loops and conditions", "[unit][program][flow]") {
  CHECK(lines_of("o1 sub\no2 while [1]\nX1\no3 if [1]\no1 return\no3 endif\no2 endwhile\nX2\n"
                 "o1 endsub\no1 call\no1 call\nX3\n") == "3 3 12");
}

TEST_CASE("labels of a subroutine are its own", "[unit][program][flow]") {
  CHECK(lines_of("o9 sub\no1 if [1]\nX1\no1 endif\no9 endsub\no1 if [1]\no9 call\no1 endif\n"
                 "o9 if [1]\nX2\no9 endif\n") == "3 10");
}

TEST_CASE("a call has parameters and locals of its own", "[unit][program][flow]") {
  const std::string sub = "o1 sub\n#3=[#1+#2+#30]\n#40=#3\n#<a>=7\n#<_g>=#<a>\no1 endsub\n";
  // 12: 3 is the caller's again; 13: #40 and <_g> are everybody's.
  CHECK(lines_of(sub + "#3=5\n#<a>=1\no1 call [4] [6]\no2 if [#3 EQ 5 AND #<a> EQ 1]\nX1\n"
                       "o3 if [#40 EQ 10 AND #<_g> EQ 7]\nX2\no3 endif\no2 endif\n") == "11 13");
}

TEST_CASE("a value is returned, and forgotten by the next call", "[unit][program][flow]") {
  const std::string subs =
      "o1 sub\no1 return [#1*2]\no1 endsub\no2 sub\no2 endsub\no3 sub\no3 endsub [#1]\n";
  const auto holds = [&](const std::string& calls, const std::string& value,
                         const std::string& returned) {
    return lines_of(subs + calls + "\no9 if [#<_value> EQ " + value +
                    " AND #<_value_returned> EQ " + returned + "]\nX1\no9 endif\n") != "";
  };
  CHECK(holds("", "0", "0"));
  CHECK(holds("o1 call [4]", "8", "1"));
  CHECK(holds("o3 call [-3]", "-3", "1"));
  CHECK(holds("o1 call [4]\no2 call", "0", "0"));
}

TEST_CASE("a subroutine may call itself", "[unit][program][flow]") {
  CHECK(lines_of("o1 sub\nX#1\no2 if [#1 GT 0]\no1 call [#1-1]\no2 endif\nY#1\no1 endsub\n"
                 "o1 call [2]\n") == "2 2 2 6 6 6");
}

TEST_CASE("M98 runs a program of the file, L times", "[unit][program][flow]") {
  const std::string programs = "M30\nO100\nX1\nM98 P200\nM99\nO200 (inner)\nX2\nM99\n";
  CHECK(lines_of("M98 P100\nM98 P200 L2\n" + programs) == "5 9 9 9 3");
  CHECK(lines_of("O1\nM98 P0100 L0\n\n" + programs) == "4");
  // Backwards too, as on Fanuc controls.
  CHECK(lines_of("M98 P300\n\n" + programs + "O300\nM98 P200\nM99\n") == "9 3");
  CHECK(lines_of("%\nO1\nM98 P2\nM30\nO2\nX1\nM99\n%\n") == "6 4");
}

TEST_CASE("M98 may have the count before a number of four digits", "[unit][program][flow]") {
  CHECK(lines_of("M98 P21000\nM30\nO1000\nX1\nM99\n") == "4 4 2");
  CHECK(lines_of("M98 P00030007\nM30\nO0007\nX1\nM99\n") == "4 4 4 2");
  CHECK(lines_of("M98 P21000 L1\nM30\nO21000\nX1\nM99\nO1000\nX2\nM99\n") == "4 2");
}

TEST_CASE("a program shares #1 to #30 with its caller, and no names", "[unit][program][flow]") {
  CHECK(
      lines_of("#1=4\n#<a>=3\nM98 P5\no1 if [#1 EQ 9 AND #<a> EQ 3 AND #<_g> EQ 2]\nX1\no1 endif\n"
               "M30\nO5\n#1=[#1+5]\n#<a>=7\n#<_g>=2\nM99\n") == "5 7");
  CHECK_THAT(lines_of("#<a>=3\nM98 P5\nM30\nO5\nX#<a>\nM99\n"), ContainsSubstring("flow.ngc:5:2"));
}

TEST_CASE("lines that begin with / are carried out and come to be listed",
          "[unit][program][flow]") {
  CHECK(lines_of("/o1 if [1]\nX1\n/ N5 o1 endif\n/M98 P7\n/X2\nM30\nO7\nX3\n/M99\n") ==
        "/1 2 /3 /4 8 /9 5 6");
}

TEST_CASE("settings of a line count from the next line on", "[unit][program][flow]") {
  CHECK(lines_of("#1=0\n#1=1 #2=#1\no1 if [#2 EQ 0 AND #1 EQ 1]\nX1\no1 endif\n") == "4");
}
