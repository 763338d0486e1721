#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "history/entry.h"

namespace limitgauge::tests {

/// A run of two stages with `figures` figures each, all told apart by `number`.
history::Entry sample_entry(int number, int figures = 3);

/// A history as version 1 wrote it, with one run.
inline constexpr const char* kVersion1 = R"sql(
CREATE TABLE run (id INTEGER PRIMARY KEY AUTOINCREMENT, created TEXT NOT NULL, job TEXT NOT NULL,
  version TEXT NOT NULL, commit_id TEXT NOT NULL, label TEXT NOT NULL, verdict TEXT NOT NULL) STRICT;
CREATE TABLE series (id INTEGER PRIMARY KEY, stage TEXT NOT NULL, metric TEXT NOT NULL,
  UNIQUE (stage, metric)) STRICT;
CREATE TABLE value (run INTEGER NOT NULL REFERENCES run ON DELETE CASCADE,
  series INTEGER NOT NULL REFERENCES series, low REAL NOT NULL, high REAL NOT NULL,
  PRIMARY KEY (run, series)) STRICT, WITHOUT ROWID;
CREATE VIEW figure AS SELECT value.run AS run, series.stage AS stage, series.metric AS metric,
  value.low AS low, value.high AS high FROM value JOIN series ON series.id = value.series;
INSERT INTO run VALUES (41, '2026-01-02T03:04:05Z', 'old', '0.1.0', 'abc', 'first', 'fail');
INSERT INTO series VALUES (1, 'finish', 'gouge_mm');
INSERT INTO value VALUES (41, 1, 0.125, 0.25);
PRAGMA application_id = 0x4C474849;
PRAGMA user_version = 1;
)sql";

/// Runs SQL as anybody could, and gives the first column of its last row, as text. Throws
/// std::runtime_error.
std::string query(const std::filesystem::path& file, const std::string& sql);

/// How SQLite would answer `sql`: a line a step.
std::string plan(const std::filesystem::path& file, const std::string& sql);

std::string bytes_of(const std::filesystem::path& file);

/// Process id of a child in which `work` runs; it ends with what that returns, 99 after an
/// exception.
int start_child(const std::function<int()>& work);
/// Its exit code, or minus the signal that ended it.
int wait_for(int child);

}  // namespace limitgauge::tests
