#include "history/schema.h"

#include <array>
#include <string>

#include "history/database.h"
#include "model/base/error.h"

namespace limitgauge::history {
namespace {

// Each makes one version out of the one before, 1 out of nothing. What was once released stays as
// it is, word for word: files of every version are out there.
//
// A figure is some 25 bytes: its stage and metric stand once in `series`, and its row lies under
// the run, so that an append writes at one place and a run is read from one.
constexpr std::array kMigrations = {
    // 1: runs and their figures.
    R"sql(
CREATE TABLE run (
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  created TEXT NOT NULL,
  job TEXT NOT NULL,
  version TEXT NOT NULL,
  commit_id TEXT NOT NULL,
  label TEXT NOT NULL,
  verdict TEXT NOT NULL
) STRICT;
CREATE TABLE series (
  id INTEGER PRIMARY KEY,
  stage TEXT NOT NULL,
  metric TEXT NOT NULL,
  UNIQUE (stage, metric)
) STRICT;
CREATE TABLE value (
  run INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
  series INTEGER NOT NULL REFERENCES series,
  low REAL NOT NULL,
  high REAL NOT NULL,
  PRIMARY KEY (run, series)
) STRICT, WITHOUT ROWID;
CREATE VIEW figure AS
  SELECT value.run AS run, series.stage AS stage, series.metric AS metric, value.low AS low,
    value.high AS high
  FROM value JOIN series ON series.id = value.series;
)sql",
    // 2: the verdict of each stage; a job's runs, and those since a day, without reading all.
    R"sql(
CREATE TABLE stage (
  run INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
  place INTEGER NOT NULL,
  name TEXT NOT NULL,
  verdict TEXT NOT NULL,
  PRIMARY KEY (run, place)
) STRICT, WITHOUT ROWID;
CREATE INDEX run_of_job ON run (job, id);
CREATE INDEX run_by_time ON run (created);
)sql",
    // 3: the schema of the result that a run's figures are from. All before were
    // limitgauge.result/1.
    R"sql(
ALTER TABLE run ADD COLUMN result_schema INTEGER NOT NULL DEFAULT 1;
)sql"};

struct Header {
  int application_id = 0, version = 0;
};

Header header_of(const Database& database) {
  return {database.number("PRAGMA application_id"), database.number("PRAGMA user_version")};
}

Header read_header(const std::filesystem::path& file) {
  try {
    return header_of(Database(file, Database::Mode::look));
  } catch (const model::InputError&) {
    // Seen while a writer was at it, not all pages are there: with the lock they are.
    return header_of(Database(file, Database::Mode::read));
  }
}

void require_known(const std::filesystem::path& file, int version) {
  if (version <= newest_version()) return;
  throw model::InputError({file.string(), 0, 0},
                          "this history has version " + std::to_string(version) +
                              ", and this program knows those up to " +
                              std::to_string(newest_version()),
                          "a newer limitgauge");
}

}  // namespace

int newest_version() {
  return static_cast<int>(kMigrations.size());
}

void require_history(const std::filesystem::path& file) {
  const model::SourcePlace place{file.string(), 0, 0};
  std::error_code missing;
  const std::filesystem::file_status status = std::filesystem::status(file, missing);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw model::InputError(
        place, std::filesystem::is_directory(status) ? "this is a folder" : "this is no plain file",
        "a history that limitgauge wrote");
  if (std::filesystem::file_size(file, missing) == 0 || missing) return;
  const Header header = read_header(file);
  // A writer that was killed while it made the file: what it left is rolled back to nothing now.
  if (std::filesystem::file_size(file, missing) == 0 || missing) return;
  if (header.application_id != kApplicationId)
    throw model::InputError(place, "this SQLite file is none of limitgauge's",
                            "a history that limitgauge wrote, or a new file");
  require_known(file, header.version);
}

void migrate(const Database& database) {
  const int version = database.number("PRAGMA user_version");
  require_known(database.file(), version);
  if (version == newest_version()) return;
  for (std::size_t next = version; next < kMigrations.size(); ++next)
    database.execute(kMigrations[next]);
  // Pragmas take no parameters; both numbers are the program's own.
  database.execute(("PRAGMA application_id = " + std::to_string(kApplicationId)).c_str());
  database.execute(("PRAGMA user_version = " + std::to_string(newest_version())).c_str());
}

}  // namespace limitgauge::history
