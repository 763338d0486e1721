#include "app/output/output_folder.h"

#include <fstream>

#include "model/base/error.h"
#include "model/base/output_file.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::app {
namespace fs = std::filesystem;
namespace {

void put(const fs::path& file, const std::string& text) {
  model::write_file(file, [&](std::ostream& out) { out << text; });
}

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

TEST_CASE("results take their name only at the end", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  OutputFolder folder(scratch.path() / "out" / "job/", false);
  CHECK(entries(scratch.path()) == 0);
  folder.prepare();
  put(folder.working() / "result.json", "{}");
  CHECK_FALSE(fs::exists(scratch.path() / "out" / "job"));
  folder.finish();
  CHECK(fs::exists(scratch.path() / "out" / "job" / "result.json"));
  CHECK(entries(scratch.path() / "out") == 1);
}

TEST_CASE("without its end a run leaves nothing, not even the folders above", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  {
    OutputFolder folder(scratch.path() / "a" / "b" / "job", false);
    folder.prepare();
    put(folder.working() / "result.json", "{}");
  }
  CHECK(entries(scratch.path()) == 0);
}

TEST_CASE("a finished folder is overwritten only when asked for", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  const fs::path target = scratch.path() / "job";
  fs::create_directory(target);
  put(target / "result.json", "old");
  put(target / "left.txt", "old");
  CHECK_THROWS_WITH(OutputFolder(target, false),
                    ContainsSubstring("the output folder exists already"));
  OutputFolder folder(target, true);
  folder.prepare();
  put(folder.working() / "result.json", "new");
  folder.finish();
  CHECK_FALSE(fs::exists(target / "left.txt"));
  CHECK(entries(scratch.path()) == 1);
}

TEST_CASE("somebody else's folder is never overwritten", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  put(scratch.path() / "thesis.tex", "years of work");
  CHECK_THROWS_AS(OutputFolder(scratch.path(), true), model::InputError);
  CHECK(fs::exists(scratch.path() / "thesis.tex"));
}

TEST_CASE("what was finished is kept under a name that says so", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  OutputFolder folder(scratch.path() / "job", false);
  folder.prepare();
  put(folder.working() / "toolpath.ngc", "G0");
  const fs::path kept = folder.keep_incomplete("the disk was full");
  CHECK(kept == scratch.path() / "job.incomplete");
  CHECK(fs::exists(kept / "toolpath.ngc"));
  std::string note;
  std::getline(std::ifstream(kept / "INCOMPLETE.txt"), note);
  CHECK(note == "the disk was full");
  CHECK(entries(scratch.path()) == 1);
}

TEST_CASE("a file that cannot be written is an error that names it", "[unit][output]") {
  CHECK_THROWS_AS(put("/dev/full", std::string(100000, 'x')), model::ResourceError);
  CHECK_THROWS_WITH(put("/dev/full", "x"), ContainsSubstring("/dev/full: error: cannot write"));
}

}  // namespace
}  // namespace limitgauge::app
