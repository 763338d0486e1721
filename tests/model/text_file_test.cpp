#include "model/base/text_file.h"

#include <sys/stat.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "model/base/error.h"
#include "tests/support/catch.h"
#include "tests/support/messages.h"
#include "tests/support/temporary_folder.h"

using namespace limitgauge::model;

namespace {

std::string refusal_to_read(const std::filesystem::path& file) {
  return limitgauge::tests::message_of<InputError>([&] { read_text_file(file); });
}

}  // namespace

TEST_CASE("what is no file is said, and nothing waits for it", "[unit][text_file]") {
  const limitgauge::tests::TemporaryFolder folder;
  CHECK(refusal_to_read("/dev/zero") == "/dev/zero: error: this is a device; expected a file");
  CHECK_THAT(refusal_to_read(folder.path()), ContainsSubstring("error: this is a directory"));
  CHECK_THAT(refusal_to_read(std::string(300, 'a')),
             ContainsSubstring("error: the file cannot be reached"));
  const std::filesystem::path pipe = folder.path() / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  const auto begin = std::chrono::steady_clock::now();
  CHECK_THAT(refusal_to_read(pipe), ContainsSubstring("error: nobody writes into this pipe"));
  // Without end, if it were waited for.
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(10));
  CHECK_THROWS_AS(require_file(pipe), InputError);
}

TEST_CASE("a pipe that somebody writes into is read to its end", "[unit][text_file]") {
  const limitgauge::tests::TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  std::thread writer([&] {
    std::ofstream out(pipe);
    out << "G21\n" << std::flush;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    out << "G90\n";
  });
  CHECK(read_text_file(pipe) == "G21\nG90\n");
  writer.join();
}
