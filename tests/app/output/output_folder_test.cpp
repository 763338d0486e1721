#include "app/output/output_folder.h"

#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "app/output/manifest.h"
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

/// A finished folder of results, one file in a folder of its own.
void finish(const fs::path& target, const std::string& text) {
  OutputFolder folder(target, false);
  folder.prepare();
  put(folder.working() / "result.json", text);
  fs::create_directory(folder.working() / "finish");
  put(folder.working() / "finish" / "stock.vdb", text);
  folder.finish();
}

std::string text_of(const fs::path& file) {
  std::string text;
  std::getline(std::ifstream(file), text);
  return text;
}

TEST_CASE("a manifest vouches for its files, and for no other", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  const fs::path folder = scratch.path() / "job";
  finish(folder, "as it was");
  CHECK(sealed(folder, "result.json") == Sealed::as_written);
  CHECK(sealed(folder, "finish/stock.vdb") == Sealed::as_written);
  CHECK(sealed(folder, "finish/other.vdb") == Sealed::otherwise);
  put(folder / "finish" / "stock.vdb", "as it is");
  CHECK(sealed(folder, "finish/stock.vdb") == Sealed::otherwise);
  fs::remove(folder / kManifestFile);
  CHECK(sealed(folder, "result.json") == Sealed::unknown);
}

TEST_CASE("a finished folder is overwritten only when asked for", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  const fs::path target = scratch.path() / "job";
  finish(target, "old");
  CHECK_THROWS_WITH(OutputFolder(target, false),
                    ContainsSubstring("the output folder exists already"));
  OutputFolder folder(target, true);
  folder.prepare();
  put(folder.working() / "result.json", "new");
  CHECK(text_of(target / "result.json") == "old");
  folder.finish();
  CHECK(text_of(target / "result.json") == "new");
  CHECK_FALSE(fs::exists(target / "finish"));
  CHECK(entries(scratch.path()) == 1);
}

TEST_CASE("a file of the user's is never overwritten, forced or not", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  const fs::path target = scratch.path() / "job", theirs = target / "finish" / "notes.txt";
  finish(target, "old");
  SECTION("added") {
    put(theirs, "theirs");
  }
  SECTION("written over one of ours") {
    put(target / "result.json", "theirs");
  }
  SECTION("a link") {
    fs::create_symlink("/etc/passwd", theirs);
  }
  SECTION("a folder") {
    fs::create_directory(theirs);
  }
  SECTION("all of it, without a manifest") {
    fs::remove(target / "manifest.sha256");
  }
  CHECK_THROWS_AS(OutputFolder(target, true), model::InputError);
  CHECK(fs::exists(target / "result.json"));
}

TEST_CASE("what comes into a folder while it is to be overwritten is kept", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  const fs::path target = scratch.path() / "job";
  finish(target, "old");
  OutputFolder folder(target, true);
  folder.prepare();
  put(folder.working() / "result.json", "new");
  put(target / "notes.txt", "theirs");
  CHECK_THROWS_AS(folder.finish(), NotPublished);
  CHECK(text_of(target / "notes.txt") == "theirs");
  CHECK(text_of(target / "result.json") == "old");
  CHECK(text_of(scratch.path() / "job.unpublished" / "result.json") == "new");
}

TEST_CASE("results that have come to stand there meanwhile are kept", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  const fs::path target = scratch.path() / "job";
  const bool force = GENERATE(false, true);
  if (force) finish(target, "old");
  OutputFolder late(target, force), later(target, force);
  for (OutputFolder* folder : {&late, &later}) {
    folder->prepare();
    put(folder->working() / "result.json", "late");
  }
  CHECK(late.working() != later.working());
  if (force) {
    OutputFolder first(target, true);
    first.prepare();
    put(first.working() / "result.json", "first");
    first.finish();
  } else {
    finish(target, "first");
  }
  CHECK_THROWS_AS(late.finish(), NotPublished);
  CHECK_THROWS_WITH(later.finish(), ContainsSubstring("job.unpublished-2"));
  CHECK(text_of(target / "result.json") == "first");
  CHECK(text_of(scratch.path() / "job.unpublished" / "result.json") == "late");
  CHECK(entries(scratch.path()) == 3);
}

TEST_CASE("what a killed process left is removed, what a living one writes is not",
          "[unit][output]") {
  const tests::TemporaryFolder scratch;
  const fs::path target = scratch.path() / "job";
  OutputFolder living(target, false);
  living.prepare();
  put(living.working() / "result.json", "{}");
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    OutputFolder killed(target, false);
    killed.prepare();
    put(killed.working() / "result.json", "{}");
    _exit(0);
  }
  REQUIRE(waitpid(child, nullptr, 0) == child);
  CHECK(entries(scratch.path()) == 2);
  // Of whatever name: nobody may ever run that job again.
  OutputFolder next(scratch.path() / "other", false);
  next.prepare();
  CHECK(fs::exists(living.working() / "result.json"));
  CHECK(entries(scratch.path()) == 2);
}

TEST_CASE("a hidden folder that no lock of ours is in stays", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  const fs::path theirs = scratch.path() / ".job.partial-0123456789abcdef0123456789abcdef";
  put(scratch.path() / ".job.partial-77", "a file");
  fs::create_directory(theirs);
  SECTION("no lock") {
    put(theirs / "thesis.tex", "years of work");
  }
  SECTION("another program's") {
    put(theirs / ".lock", "mine");
  }
  OutputFolder folder(scratch.path() / "job", false);
  folder.prepare();
  CHECK(fs::exists(theirs));
  CHECK(entries(scratch.path()) == 3);
}

TEST_CASE("results go to where a link leads, and the link stays", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  const fs::path link = scratch.path() / "link";
  SECTION("to an empty folder") {
    fs::create_directory(scratch.path() / "behind");
    fs::create_symlink("behind", link);
  }
  SECTION("to nothing, round a corner") {
    fs::create_symlink("corner", link);
    fs::create_symlink("behind", scratch.path() / "corner");
  }
  finish(link, "new");
  CHECK(fs::is_symlink(link));
  CHECK(text_of(scratch.path() / "behind" / "result.json") == "new");
  CHECK_FALSE(fs::is_symlink(scratch.path() / "behind"));
}

TEST_CASE("a link to itself is refused", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  fs::create_symlink("link", scratch.path() / "link");
  CHECK_THROWS_WITH(OutputFolder(scratch.path() / "link", false), ContainsSubstring("circle"));
}

TEST_CASE("a name as long as file systems take is one", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  const std::string name(255, 'n');
  finish(scratch.path() / name, "new");
  CHECK(text_of(scratch.path() / name / "result.json") == "new");
  CHECK_THROWS_WITH(OutputFolder(scratch.path() / (name + "n"), false),
                    ContainsSubstring("File name too long"));
}

TEST_CASE("somebody else's folder is never overwritten", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  put(scratch.path() / "thesis.tex", "years of work");
  CHECK_THROWS_AS(OutputFolder(scratch.path(), true), model::InputError);
  CHECK(fs::exists(scratch.path() / "thesis.tex"));
}

TEST_CASE("a list of somebody's own checksums proves nothing to be ours", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  put(scratch.path() / "thesis.tex", "years of work");
  // As `sha256sum thesis.tex > manifest.sha256` has it.
  seal(scratch.path());
  CHECK_THROWS_WITH(OutputFolder(scratch.path(), true), ContainsSubstring("thesis.tex"));
  CHECK_FALSE(remove_ours(scratch.path()));
  CHECK(fs::exists(scratch.path() / "thesis.tex"));
  // Beside results of ours it is one of them.
  put(scratch.path() / "result.json", "{}");
  fs::remove(scratch.path() / "manifest.sha256");
  seal(scratch.path());
  CHECK_NOTHROW(OutputFolder(scratch.path(), true));
}

TEST_CASE("what speaks of results does not take their place", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  CHECK_NOTHROW(require_no_result(scratch.path() / "nowhere"));
  CHECK_NOTHROW(require_no_result(scratch.path()));
  put(scratch.path() / "result.json", "{}");
  CHECK_THROWS_WITH(require_no_result(scratch.path()),
                    ContainsSubstring("the result's own folder"));
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

TEST_CASE("what is kept as incomplete replaces only what is ours", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  const auto keep = [&](const std::string& text) {
    OutputFolder folder(scratch.path() / "job", false);
    folder.prepare();
    put(folder.working() / "toolpath.ngc", text);
    return folder.keep_incomplete("the disk was full");
  };
  const fs::path kept = keep("first");
  CHECK(keep("second") == kept);
  CHECK(text_of(kept / "toolpath.ngc") == "second");
  put(kept / "notes.txt", "theirs");
  const fs::path beside = keep("third");
  CHECK(beside == scratch.path() / "job.incomplete-2");
  CHECK(text_of(kept / "notes.txt") == "theirs");
  CHECK(text_of(kept / "toolpath.ngc") == "second");
  CHECK(text_of(beside / "toolpath.ngc") == "third");
}

TEST_CASE("a file is written whole wherever its name leads", "[unit][output]") {
  const tests::TemporaryFolder scratch;
  const fs::path before = fs::current_path(), link = scratch.path() / "link.csv";
  fs::current_path(scratch.path());
  model::write_whole_file("here.csv", "text");
  fs::current_path(before);
  CHECK(text_of(scratch.path() / "here.csv") == "text");
  fs::create_symlink("here.csv", link);
  model::write_whole_file(link, "new");
  CHECK(fs::is_symlink(link));
  CHECK(text_of(scratch.path() / "here.csv") == "new");
  model::write_whole_file("/dev/null", "nobody's");
  CHECK_FALSE(fs::is_regular_file("/dev/null"));
  CHECK(entries(scratch.path()) == 2);
}

TEST_CASE("a file that cannot be written is an error that names it", "[unit][output]") {
  CHECK_THROWS_AS(put("/dev/full", std::string(100000, 'x')), model::ResourceError);
  CHECK_THROWS_WITH(put("/dev/full", "x"), ContainsSubstring("/dev/full: error: cannot write"));
}

}  // namespace
}  // namespace limitgauge::app
