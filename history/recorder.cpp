#include "history/recorder.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>
#include <utility>

#include "history/database.h"
#include "history/schema.h"
#include "model/base/absolute_path.h"
#include "model/base/error.h"
#include "model/base/output_file.h"

namespace limitgauge::history {
namespace fs = std::filesystem;
namespace {

/// Where file systems have no files without a name: what is killed between two calls leaves one,
/// under a name that nobody else has; the next one here removes it.
int reason_against_named_file(const fs::path& folder, const std::string& prefix) {
  const fs::path probe = folder / (prefix + model::random_digits());
  const int opened = ::open(probe.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0600);
  if (opened < 0) return errno;
  ::close(opened);
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().filename().string().starts_with(prefix)) fs::remove(entry.path(), ignored);
  return 0;
}

/// Why `folder` takes no new file; 0 where it does.
int reason_against_new_file(const fs::path& folder, const std::string& prefix) {
  // Without a name, nothing of it outlives whoever is killed.
  const int opened = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
  if (opened >= 0) return ::close(opened), 0;
  // Old kernels say that it is a folder; file systems that have no such files, that they do not.
  const bool unknown = errno == EISDIR || errno == EOPNOTSUPP || errno == EINVAL;
  return unknown ? reason_against_named_file(folder, prefix) : errno;
}

/// SQLite's journal stands beside the file: the folder must take new files. Asking for permission
/// would not do, a share may say yes and then refuse.
void require_room_beside(const fs::path& file) {
  const fs::path folder = model::behind_links(model::absolute_path(file)).parent_path();
  const int reason = reason_against_new_file(folder, "." + file.filename().string() + ".probe-");
  if (reason == 0) return;
  const std::string wrong =
      std::string("a history cannot be made or written here: ") + std::strerror(reason);
  if (reason == ENOSPC || reason == EDQUOT || reason == EMFILE || reason == ENFILE)
    throw model::ResourceError(file.string() + ": error: " + wrong);
  throw model::InputError({file.string(), 0, 0}, wrong, "a folder that exists and can be written");
}

void require_fit(const Entry& entry) {
  if (entry.label.size() > kLongestName || entry.commit.size() > kLongestName)
    throw std::invalid_argument("a label or a commit of a history is too long");
  for (const Value& value : entry.values)
    if (!std::isfinite(value.low) || !std::isfinite(value.high))
      throw std::invalid_argument("a figure of a history is not finite: " + value.metric);
}

std::int64_t insert_run(const Database& database, const Entry& entry) {
  Statement run(database,
                "INSERT INTO run (created, job, version, commit_id, label, verdict, result_schema) "
                "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7) RETURNING id");
  run.bind(1, entry.created).bind(2, entry.job).bind(3, entry.version);
  run.bind(4, entry.commit).bind(5, entry.label).bind(6, entry.verdict);
  run.bind(7, std::int64_t{entry.result_schema});
  run.step();
  const std::int64_t id = run.integer(0);
  run.run();
  return id;
}

void insert_stages(const Database& database, std::int64_t id, const Entry& entry) {
  Statement stage(database,
                  "INSERT INTO stage (run, place, name, verdict) VALUES (?1, ?2, ?3, ?4)");
  std::int64_t place = 0;
  for (const StageVerdict& one : entry.stages) {
    stage.bind(1, id).bind(2, place++).bind(3, one.stage).bind(4, one.verdict).run();
  }
}

void insert_values(const Database& database, std::int64_t id, const Entry& entry) {
  Statement series(database, "INSERT OR IGNORE INTO series (stage, metric) VALUES (?1, ?2)");
  Statement value(database,
                  "INSERT INTO value (run, series, low, high) VALUES (?1, "
                  "(SELECT id FROM series WHERE stage = ?2 AND metric = ?3), ?4, ?5)");
  for (const Value& one : entry.values) {
    series.bind(1, one.stage).bind(2, one.metric).run();
    value.bind(1, id).bind(2, one.stage).bind(3, one.metric);
    value.bind(4, one.low).bind(5, one.high).run();
  }
}

std::int64_t insert(const Database& database, const Entry& entry) {
  migrate(database);
  const std::int64_t id = insert_run(database, entry);
  insert_stages(database, id, entry);
  insert_values(database, id, entry);
  return id;
}

/// All pages, not only those that the next run is written to: a history that goes on being written
/// when it is damaged is one whose last whole copy grows older. 10,000 runs of 60 figures take 0.2
/// s.
void require_whole(const Database& database) {
  Statement check(database, "PRAGMA integrity_check(1)");
  const std::string found = check.step() ? check.text(0) : "ok";
  if (found != "ok")
    throw model::InputError({database.file().string(), 0, 0},
                            "this history is damaged (" + found + ")",
                            "a copy of it that is whole");
}

/// Adds a run as append() does, and takes it back: whatever would go wrong then goes wrong now.
void rehearse(const fs::path& file) {
  const Database database(file, Database::Mode::read);
  require_whole(database);
  const Transaction taken_back(database, Transaction::Kind::write);
  Entry entry;
  entry.stages.push_back({"rehearsal", "pass"});
  entry.values.push_back({"rehearsal", "rehearsal", 0, 0});
  insert(database, entry);
}

}  // namespace

Recorder::Recorder(fs::path file) : file_(std::move(file)) {
  require_history(file_);
  require_room_beside(file_);
  std::error_code missing;
  if (fs::exists(file_, missing)) rehearse(file_);
}

std::int64_t Recorder::append(const Entry& entry) const {
  require_fit(entry);
  require_history(file_);
  const Database database(file_, Database::Mode::write);
  // The journal that rolls back is SQLite's own way and stays: the one that is written ahead needs
  // memory that all its users share, which no network file system has. EXTRA has the folder
  // written out as well, so that no journal comes back after a power cut.
  database.execute("PRAGMA synchronous = EXTRA; PRAGMA foreign_keys = ON");
  Transaction transaction(database, Transaction::Kind::write);
  const std::int64_t id = insert(database, entry);
  transaction.commit();
  return id;
}

}  // namespace limitgauge::history
