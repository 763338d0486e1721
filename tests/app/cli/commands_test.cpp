#include "app/cli/commands.h"

#include <sstream>

#include "model/base/error.h"
#include "tests/support/catch.h"
#include "verifier/gate/verify.h"

namespace limitgauge::app {
namespace {

struct Said {
  ExitCode code;
  std::string text;
};

template <class Error>
Said say_of(const Error& thrown) {
  std::ostringstream out, errors;
  const Console console{out, errors};
  try {
    throw thrown;
  } catch (const std::exception&) {
    const ExitCode code = report_exception(console);
    CHECK(out.str().empty());
    return {code, errors.str()};
  }
}

}  // namespace

TEST_CASE("instruments that disagree end a run with exit code 4 and both readings", "[unit]") {
  const Said said = say_of(verifier::InstrumentDisagreement(
      "the two instruments disagree at (1, 2, 3): analytic instrument 0.1 mm, voxel instrument 0.2 "
      "mm"));
  CHECK(said.code == ExitCode::resources);
  CHECK(static_cast<int>(said.code) == 4);
  CHECK(said.text.find("internal error") != std::string::npos);
  CHECK(said.text.find("analytic instrument 0.1 mm") != std::string::npos);
  CHECK(said.text.find("voxel instrument 0.2 mm") != std::string::npos);
}

TEST_CASE("bad usage is exit code 3, lack of memory 4", "[unit]") {
  CHECK(say_of(UsageError("what is this")).code == ExitCode::bad_input);
  CHECK(say_of(std::bad_alloc()).code == ExitCode::resources);
  CHECK(say_of(model::ResourceError("disk full")).code == ExitCode::resources);
  CHECK(say_of(model::ResourceError("disk full")).text == "limitgauge: error: disk full\n");
  CHECK(say_of(model::ResourceError("a.vdb: error: disk full")).text ==
        "a.vdb: error: disk full\n");
}

}  // namespace limitgauge::app
