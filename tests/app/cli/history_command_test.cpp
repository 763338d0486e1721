#include <fstream>
#include <sstream>

#include "app/cli/commands.h"
#include "history/recorder.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::app {
namespace {

namespace fs = std::filesystem;

struct HistorySaid {
  int code = -1;
  std::string out, errors;
};

HistorySaid run(std::vector<std::string> words) {
  words.insert(words.begin(), "limitgauge");
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  std::ostringstream out, errors;
  const Console console{out, errors};
  const ExitCode code =
      run_command_line(static_cast<int>(pointers.size()), pointers.data(), console);
  return {static_cast<int>(code), out.str(), errors.str()};
}

history::Entry entry(const std::string& job, double uncut_mm) {
  history::Entry one;
  one.created = "2026-11-22T01:00:00Z";
  one.job = job;
  one.version = "0.1.0";
  one.verdict = "pass";
  one.stages = {{"finish", "pass"}};
  one.values = {{"finish", "uncut_mm", uncut_mm, uncut_mm + 0.001},
                {"finish", "resolution_mm", 0.001, 0.001},
                {"", "machining_time_s", 60, 60}};
  return one;
}

/// A folder with a history of two runs of "part" and one of "other", and where to list it.
struct Listing {
  tests::TemporaryFolder folder;
  std::string file = (folder.path() / "runs.sqlite").string();
  std::string out = (folder.path() / "out").string();
  Listing() {
    const history::Recorder recorder(file);
    recorder.append(entry("part", 0.01));
    recorder.append(entry("other", 0.5));
    recorder.append(entry("part", 0.02));
  }
};

TEST_CASE("history lists runs and writes page, table and figures", "[unit][history]") {
  const Listing at;
  const HistorySaid said = run({"history", at.file, "-o", at.out});
  CHECK(said.code == 0);
  CHECK(said.errors.empty());
  CHECK_THAT(said.out, ContainsSubstring("part: 2 runs") && ContainsSubstring("other: 1 run\n") &&
                           ContainsSubstring("[20.0, 21.0] ↑ worse") &&
                           ContainsSubstring("page: " + at.out + "/history.html"));
  for (const char* name : {"history.html", "history.csv", "history.json"})
    CHECK(fs::file_size(fs::path(at.out) / name) > 100);
  CHECK(run({"history", at.file, "-o", at.out}).code == 3);
  CHECK(run({"history", at.file, "-o", at.out, "--force", "--quiet"}).out.empty());
}

TEST_CASE("history shows what is asked for", "[unit][history]") {
  const Listing at;
  const HistorySaid one = run({"history", at.file, "-o", at.out, "--job", "part", "--last", "1"});
  CHECK_THAT(one.out, ContainsSubstring("part: 1 run\n") && !ContainsSubstring("other") &&
                          ContainsSubstring("the newest 1 of 2 runs; --last shows more"));
  const HistorySaid other = run({"history", at.file, "-o", at.out, "--force", "--metric",
                                 "uncut_mm", "--metric", "resolution_mm", "--since", "2026-11-22"});
  CHECK_THAT(other.out,
             ContainsSubstring("finish resolution_mm") && !ContainsSubstring("machining"));
}

TEST_CASE("a history without runs says so and writes nothing", "[unit][history]") {
  const Listing at;
  const HistorySaid late = run({"history", at.file, "-o", at.out, "--since", "2026-11-23"});
  CHECK(late.code == 0);
  CHECK_THAT(late.out, ContainsSubstring("no run of those that are asked for"));
  const fs::path empty = at.folder.path() / "empty.sqlite";
  std::ofstream{empty};
  const HistorySaid none = run({"history", empty.string(), "-o", at.out});
  CHECK(none.code == 0);
  CHECK_THAT(none.out, ContainsSubstring("no runs yet"));
  CHECK_FALSE(fs::exists(at.out));
}

TEST_CASE("names that a history does not have are refused with the nearest", "[unit][history]") {
  const Listing at;
  const auto refused = [&](const std::string& option, const std::string& name) {
    const HistorySaid said = run({"history", at.file, "-o", at.out, option, name});
    CHECK(said.code == 3);
    return said.errors;
  };
  CHECK_THAT(refused("--metric", "uncut"), ContainsSubstring("\"uncut_mm\""));
  CHECK_THAT(refused("--stage", "finnish"), ContainsSubstring("\"finish\""));
  CHECK_THAT(refused("--job", "prat"), ContainsSubstring("\"part\""));
  for (const char* none :
       {"yesterday", "2026-13-45", "2026-02-29", "2026-11-22T24:00", "2026-11-22T10:00:60Z"})
    CHECK_THAT(refused("--since", none), ContainsSubstring("no date like 2026-11-22"));
  CHECK_THAT(refused("--last", "0"), ContainsSubstring("--last"));
  CHECK_FALSE(fs::exists(at.out));
}

TEST_CASE("a commit needs a history; a label is a name with it or without", "[unit][history]") {
  CHECK_THAT(run({"run", "a.toml", "--commit", "x"}).errors, ContainsSubstring("--history"));
  CHECK_THAT(run({"run", "a.toml", "--label", "x"}).errors, !ContainsSubstring("--history"));
  CHECK_THAT(run({"run", "a.toml", "--label", std::string(201, 'x')}).errors,
             ContainsSubstring("--label") && ContainsSubstring("longer than 200 bytes"));
  CHECK_THAT(run({"run", "a.toml", "--history", "h", "--commit", std::string(201, 'x')}).errors,
             ContainsSubstring("--commit") && ContainsSubstring("longer than 200 bytes"));
}

TEST_CASE("what is wrong with a history is said before a run", "[unit][history]") {
  const tests::TemporaryFolder folder;
  const std::string job = tests::fixtures().string() + "/jobs/quick-dome.toml";
  const std::string out = (folder.path() / "out").string();
  const auto refused = [&](const fs::path& history) {
    const HistorySaid said = run({"run", job, "-o", out, "--history", history.string()});
    CHECK(said.code == 3);
    CHECK_FALSE(fs::exists(out));
    return said.errors;
  };
  CHECK_THAT(refused(folder.path() / "none/h.sqlite"), ContainsSubstring("cannot be made"));
  CHECK_THAT(refused(fs::path(out) / "h.sqlite"), ContainsSubstring("lost with the output folder"));
  std::ofstream(folder.path() / "notes.txt") << "notes";
  CHECK_THAT(refused(folder.path() / "notes.txt"), ContainsSubstring("no SQLite file"));
}

}  // namespace
}  // namespace limitgauge::app
