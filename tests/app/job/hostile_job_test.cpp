// Jobs that nobody writes in earnest: what the fuzz target of the job reader has found.
#include <array>
#include <string>

#include "model/base/error.h"
#include "model/text/message_text.h"
#include "tests/app/job_text.h"
#include "tests/support/catch.h"

namespace limitgauge::app {
namespace {

std::string repeated(const std::string& part, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += part;
  return text;
}

TEST_CASE("a key of many parts is refused before it exhausts the stack", "[unit][job]") {
  const std::string deep = "a" + repeated(".a", 100'000);
  CHECK(error_of(good_job() + "\n" + deep + " = 1\n")
            .starts_with("job.toml:22:202: error: more than 100 dots in one line; "));
  CHECK_THAT(error_of("[" + deep + "]\n"), ContainsSubstring("more than 100 dots in one line"));
  CHECK_THAT(error_of("a" + repeated(".'..'", 200) + " = 1\n"),
             ContainsSubstring("more than 100 dots in one line"));
  CHECK_THAT(error_of(good_job(), {deep + "=1"}), ContainsSubstring("more than 100 dots"));
  CHECK_THAT(error_of(good_job(), {"x={" + deep + "=1}"}),
             ContainsSubstring("the value cannot be read"));
  // As deep as lines and values within values may go.
  std::string nested = "1";
  for (int level = 0; level < 120; ++level)
    nested = "[\n{a" + repeated(".a", 99) + " = " + nested + "}]";
  CHECK_THAT(error_of("x = " + nested + "\n"), ContainsSubstring("unknown key \"x\""));
  // Rows of dots in a comment are no key.
  CHECK_NOTHROW(read("# " + repeated(".", 500) + "\n" + good_job()));
}

TEST_CASE("a file name that no file can have is no file", "[unit][job]") {
  const std::string name(5000, 'a');
  CHECK_THAT(error_of(with(good_job(), "cages/quick-dome.obj", name)),
             ContainsSubstring("job.toml:3:8: error: no file \"aaa"));
}

TEST_CASE("an override that is no TOML in quotes either is refused", "[unit][job]") {
  for (const std::string value : {"a\x01", "a\rb", "\xff"})
    CHECK_THAT(error_of(good_job(), {"name=" + value}),
               ContainsSubstring("error: the value cannot be read"));
}

TEST_CASE("names of megabytes are not compared letter by letter", "[unit][job]") {
  const std::string a(1'000'000, 'a'), b(1'000'000, 'b');
  CHECK(model::nearest_word(a, std::array<std::string_view, 2>{b, a}) == a);
  CHECK_THAT(error_of(with(with(good_job(), "id = \"ball3\"", "id = \"" + a + "\""),
                           "tool = \"ball3\"", "tool = \"" + b + "\"")),
             ContainsSubstring("no tool has the id"));
}

}  // namespace
}  // namespace limitgauge::app
