#include "model/gcode/text/parameters.h"

#include "tests/support/catch.h"

using limitgauge::model::gcode::Parameters;

TEST_CASE("parameters have no value before they are set", "[unit][program]") {
  Parameters parameters;
  CHECK_FALSE(parameters.numbered(1));
  CHECK_FALSE(parameters.numbered(31));
  CHECK_FALSE(parameters.numbered(5999));
  CHECK_FALSE(parameters.named("width"));
  CHECK_FALSE(parameters.named("_width"));
  parameters.set(31, 7);
  parameters.set("width", 8);
  CHECK(parameters.numbered(31) == 7);
  CHECK(parameters.named("width") == 8);
  parameters.set("width", 9);
  CHECK(parameters.named("width") == 9);
}

TEST_CASE("numbers beyond the table are neither read nor set", "[unit][program]") {
  Parameters parameters;
  for (const int number : {-1, 0, Parameters::kLargest + 1}) {
    parameters.set(number, 1);
    CHECK_FALSE(parameters.numbered(number));
    CHECK_FALSE(Parameters::is_settable(number));
  }
}

TEST_CASE("a call has its own low numbers and local names", "[unit][program]") {
  Parameters parameters;
  parameters.set(1, 10);
  parameters.set(30, 11);
  parameters.set(31, 12);
  parameters.set("local", 13);
  parameters.set("_global", 14);
  parameters.enter({100, 200});
  CHECK(parameters.depth() == 2);
  CHECK(parameters.numbered(1) == 100);
  CHECK(parameters.numbered(2) == 200);
  CHECK(parameters.numbered(3) == 0);
  CHECK(parameters.numbered(30) == 0);
  CHECK(parameters.numbered(31) == 12);
  CHECK_FALSE(parameters.named("local"));
  CHECK(parameters.named("_global") == 14);
  parameters.set(1, 101);
  parameters.set(31, 102);
  parameters.set("local", 103);
  parameters.set("_global", 104);
  parameters.leave();
  CHECK(parameters.depth() == 1);
  CHECK(parameters.numbered(1) == 10);
  CHECK(parameters.numbered(30) == 11);
  CHECK(parameters.numbered(31) == 102);
  CHECK(parameters.named("local") == 13);
  CHECK(parameters.named("_global") == 104);
}

TEST_CASE("the program itself cannot be left", "[unit][program]") {
  Parameters parameters;
  parameters.set(1, 10);
  parameters.leave();
  CHECK(parameters.depth() == 1);
  CHECK(parameters.numbered(1) == 10);
}

TEST_CASE("more arguments than local numbers leave the others alone", "[unit][program]") {
  Parameters parameters;
  parameters.enter(std::vector<double>(40, 5));
  CHECK(parameters.numbered(30) == 5);
  CHECK_FALSE(parameters.numbered(31));
}

TEST_CASE("the machine answers for its own parameters", "[unit][program]") {
  Parameters parameters;
  parameters.set_system(
      [](int number) { return number == 5420 ? std::optional(1.5) : std::nullopt; },
      [](std::string_view name) { return name == "_x" ? std::optional(2.5) : std::nullopt; });
  parameters.set(5399, 4);
  parameters.set("_y", 5);
  CHECK(parameters.numbered(5420) == 1.5);
  CHECK(parameters.numbered(5399) == 4);
  CHECK_FALSE(parameters.numbered(5421));
  CHECK(parameters.named("_x") == 2.5);
  CHECK(parameters.named("_y") == 5);
}

TEST_CASE("what the machine owns is not the program's to set", "[unit][program]") {
  for (const int number : {5021, 5161, 5181, 5210, 5221, 5390, 5400, 5413, 5420, 5428}) {
    CAPTURE(number);
    CHECK_FALSE(Parameters::is_settable(number));
  }
  for (const int number : {1, 30, 31, 5000, 5020, 5399, 5419, 5429, 5999}) {
    CAPTURE(number);
    CHECK(Parameters::is_settable(number));
  }
  for (const char* name : {"_a", "_metric", "_x", "_z", "_value", "_vmajor", "_ini[axis]x"}) {
    CAPTURE(name);
    CHECK_FALSE(Parameters::is_settable(name));
  }
  for (const char* name : {"x", "metric", "_mine", "_xx"}) {
    CAPTURE(name);
    CHECK(Parameters::is_settable(name));
  }
}
