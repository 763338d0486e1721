#include "history/schema.h"

#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <functional>

#include "history/history.h"
#include "history/recorder.h"
#include "model/base/error.h"
#include "tests/history/history_file.h"
#include "tests/support/catch.h"
#include "tests/support/messages.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::history {
namespace {

namespace fs = std::filesystem;
using tests::kVersion1;
using tests::query;
using tests::sample_entry;
using tests::TemporaryFolder;

Entry entry_of_version_1() {
  Entry entry;
  entry.id = 41;
  entry.created = "2026-01-02T03:04:05Z";
  entry.job = "old";
  entry.version = "0.1.0";
  entry.commit = "abc";
  entry.label = "first";
  entry.verdict = "fail";
  entry.result_schema = 1;  // there was no other
  entry.values = {{"finish", "gouge_mm", 0.125, 0.25}};
  return entry;
}

void put(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

std::string input_error(const std::function<void()>& work) {
  return tests::message_of<model::InputError>([&] { work(); });
}

/// Neither reading nor adding is possible, both say why, and not a byte changes.
void check_refused(const fs::path& file, const std::string& why) {
  const std::string before = tests::bytes_of(file);
  CHECK_THAT(input_error([&] { History{file}; }), ContainsSubstring(why));
  CHECK_THAT(input_error([&] { Recorder{file}; }), ContainsSubstring(why));
  CHECK(tests::bytes_of(file) == before);
  CHECK(entries(file.parent_path()) == 1);
}

TEST_CASE("a history of version 1 is read as it stands", "[unit][history]") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "old.sqlite";
  query(file, kVersion1);
  const std::string before = tests::bytes_of(file);
  CHECK(History(file).runs({}) == std::vector<Entry>{entry_of_version_1()});
  CHECK(tests::bytes_of(file) == before);
}

TEST_CASE("the first run that is added brings version 1 to the newest", "[unit][history]") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "old.sqlite";
  query(file, kVersion1);
  const Recorder recorder(file);
  CHECK(query(file, "PRAGMA user_version") == "1");
  Entry entry = sample_entry(1);
  entry.id = recorder.append(entry);
  CHECK(entry.id == 42);
  CHECK(query(file, "PRAGMA user_version") == std::to_string(newest_version()));
  CHECK(History(file).runs({}) == std::vector<Entry>{entry_of_version_1(), entry});
  // The same as a file that never was any other.
  const fs::path fresh = folder.path() / "new.sqlite";
  Recorder(fresh).append(entry);
  const char* kSchema =
      "SELECT group_concat(name || sql) FROM (SELECT name, sql FROM sqlite_schema "
      "WHERE name IN ('stage', 'run_of_job', 'run_by_time') ORDER BY name)";
  CHECK(query(file, kSchema) == query(fresh, kSchema));
}

TEST_CASE("a history of a newer version is refused", "[unit][history]") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "new.sqlite";
  Recorder(file).append(sample_entry(1));
  query(file, "PRAGMA user_version = 99");
  check_refused(file, "this history has version 99, and this program knows those up to 3");
}

TEST_CASE("what is no history is refused and not touched", "[unit][history]") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "file";
  for (const std::string& text :
       {std::string("hello"), std::string(5000, 'x'), std::string("SQLite format 3")}) {
    put(file, text);
    check_refused(file, "this is no SQLite file");
  }
}

TEST_CASE("a database of somebody else is refused and not touched", "[unit][history]") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "accounts.db";
  query(file, "CREATE TABLE run (id INTEGER); PRAGMA user_version = 1");
  check_refused(file, "none of limitgauge's");
  query(file, "PRAGMA application_id = 12345");
  check_refused(file, "none of limitgauge's");
}

TEST_CASE("a damaged history says so", "[unit][history]") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "runs.sqlite";
  Recorder(file).append(sample_entry(1));
  fs::resize_file(file, 4096);
  check_refused(file, "this history is damaged");
}

TEST_CASE("a page that is damaged deep inside a history is found before a run", "[unit][history]") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "runs.sqlite";
  for (int i = 0; i < 40; ++i) Recorder(file).append(sample_entry(i, 60));
  const std::string whole = tests::bytes_of(file);
  const int pages = std::stoi(query(file, "PRAGMA page_count"));
  REQUIRE(pages > 20);
  // An append reads the newest page of a table and those above it: this is none of them.
  const std::string inner = query(file,
                                  "SELECT pageno FROM dbstat WHERE name = 'value' AND "
                                  "pagetype = 'leaf' ORDER BY path LIMIT 1");
  const std::size_t at = (std::stoul(inner) - 1) * 4096;
  put(file, whole.substr(0, at) + std::string(4096, '\x5a') + whole.substr(at + 4096));
  CHECK_THAT(input_error([&] { Recorder{file}; }), ContainsSubstring("this history is damaged"));
}

TEST_CASE("a history whose tables were meddled with is found before a run", "[unit][history]") {
  for (const char* meddling :
       {"DROP TABLE value", "ALTER TABLE run RENAME COLUMN label TO name",
        "CREATE TRIGGER no BEFORE INSERT ON run BEGIN SELECT RAISE(ABORT, 'no'); END"}) {
    CAPTURE(meddling);
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "runs.sqlite";
    Recorder(file).append(sample_entry(1));
    query(file, std::string("DROP VIEW figure; ") + meddling);
    const std::string before = tests::bytes_of(file);
    CHECK_THAT(input_error([&] { Recorder{file}; }),
               ContainsSubstring("this history is not as limitgauge wrote it"));
    CHECK(tests::bytes_of(file) == before);
    CHECK(entries(folder.path()) == 1);
  }
}

TEST_CASE("what is no file, or leads to no place, is no history", "[unit][history]") {
  const TemporaryFolder folder;
  const fs::path pipe = folder.path() / "pipe", link = folder.path() / "link";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THAT(input_error([&] { Recorder{pipe}; }), ContainsSubstring("this is no plain file"));
  CHECK_THAT(input_error([&] { Recorder{"/dev/null"}; }),
             ContainsSubstring("this is no plain file"));
  fs::create_symlink("missing/runs.sqlite", link);
  CHECK_THAT(input_error([&] { Recorder{link}; }), ContainsSubstring("No such file or directory"));
  fs::create_directory(folder.path() / "missing");
  CHECK(Recorder(link).append(sample_entry(1)) == 1);
  CHECK(fs::is_regular_file(folder.path() / "missing/runs.sqlite"));
}

TEST_CASE("what is not there, or has no place to be, is said", "[unit][history]") {
  const TemporaryFolder folder;
  const fs::path nowhere = folder.path() / "missing" / "runs.sqlite";
  CHECK_THAT(input_error([&] { History{nowhere}; }), ContainsSubstring("there is no such history"));
  CHECK_THAT(input_error([&] { Recorder{nowhere}; }),
             ContainsSubstring("No such file or directory"));
  CHECK_THAT(input_error([&] { Recorder{folder.path()}; }), ContainsSubstring("this is a folder"));
  CHECK(entries(folder.path()) == 0);
}

TEST_CASE("seeing to it that a history can be written writes nothing", "[unit][history]") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "runs.sqlite";
  const Recorder fresh(file);
  CHECK(entries(folder.path()) == 0);
  put(file, "");
  CHECK(History(file).runs({}).empty());
  fresh.append(sample_entry(1));
  const std::string before = tests::bytes_of(file);
  const Recorder again(file);
  CHECK(tests::bytes_of(file) == before);
  CHECK(entries(folder.path()) == 1);
}

/// What a child that is not root, or no longer, is told by `Recorder(file)`.
int refusal(const fs::path& file) {
  if (getuid() == 0 && setuid(65534) != 0) return 98;
  try {
    const Recorder recorder(file);
    return 0;
  } catch (const model::InputError&) {
    return 3;
  } catch (const model::ResourceError&) {
    return 4;
  }
}

TEST_CASE("a history or a folder that may not be written is refused before a run",
          "[unit][history]") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "runs.sqlite";
  Recorder(file).append(sample_entry(1));
  const auto refused = [&](mode_t of_folder, mode_t of_file) {
    chmod(folder.path().c_str(), of_folder);
    chmod(file.c_str(), of_file);
    const int code = tests::wait_for(tests::start_child([&] { return refusal(file); }));
    chmod(folder.path().c_str(), 0700);
    return code;
  };
  CHECK(refused(0777, 0666) == 0);
  CHECK(refused(0777, 0444) == 3);
  CHECK(refused(0555, 0666) == 3);
  fs::resize_file(file, 0);
  CHECK(refused(0777, 0666) == 0);
  CHECK(refused(0777, 0444) == 3);
}

TEST_CASE("a history that another keeps locked for a minute is given up before a run",
          "[slow][history]") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "runs.sqlite";
  Recorder(file).append(sample_entry(1));
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const int child = tests::start_child([&] {
    sqlite3* handle = nullptr;
    sqlite3_open(file.c_str(), &handle);
    sqlite3_exec(handle, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr);
    return write(ends[1], "x", 1) == 1 ? pause() : 1;
  });
  char locked = 0;
  REQUIRE(read(ends[0], &locked, 1) == 1);
  CHECK_THAT(tests::message_of<model::ResourceError>([&] { Recorder{file}; }),
             ContainsSubstring("another process has kept the history locked for a minute"));
  kill(child, SIGKILL);
  tests::wait_for(child);
  CHECK(Recorder(file).append(sample_entry(2)) == 2);
}

TEST_CASE("a full disk is said, and the history stays whole", "[unit][history]") {
  const TemporaryFolder folder;
  const Recorder recorder(folder.path() / "runs.sqlite");
  for (int i = 0; i < 20; ++i) recorder.append(sample_entry(i));
  const auto size = fs::file_size(recorder.file());
  const int code = tests::wait_for(tests::start_child([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{size, size};
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      recorder.append(sample_entry(99, 400));
    } catch (const model::ResourceError&) {
      return 4;
    }
    return 0;
  }));
  CHECK(code == 4);
  CHECK(query(recorder.file(), "PRAGMA integrity_check") == "ok");
  CHECK(query(recorder.file(), "SELECT count(*) FROM run") == "20");
  CHECK(recorder.append(sample_entry(99, 400)) == 21);
}

}  // namespace
}  // namespace limitgauge::history
