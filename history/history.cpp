#include "history/history.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "history/database.h"
#include "history/schema.h"
#include "model/base/error.h"

namespace limitgauge::history {
namespace fs = std::filesystem;
namespace {

std::unique_ptr<Database> opened(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored))
    throw model::InputError({file.string(), 0, 0}, "there is no such history",
                            "a file that run --history wrote");
  require_history(file);
  auto database = std::make_unique<Database>(file, Database::Mode::read);
  if (database->number("PRAGMA user_version") < newest_version()) {
    // Migrated where nobody sees it: whoever only reads may not be allowed to write.
    database = std::make_unique<Database>(database->private_copy());
    migrate(*database);
  }
  database->execute("PRAGMA query_only = ON");
  return database;
}

bool is_asked(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

/// `what` of the runs that are asked for. Conditions that are not stated are not there, so that the
/// indices serve.
Statement asked_runs(const Database& database, const Query& query, const std::string& what,
                     const std::string& order) {
  std::string sql = "SELECT " + what + " FROM run WHERE true";
  if (query.job) sql += " AND job = ?1";
  if (!query.since.empty()) sql += " AND created >= ?2";
  Statement row(database, sql + order);
  if (query.job) row.bind(1, *query.job);
  if (!query.since.empty()) row.bind(2, query.since);
  return row;
}

std::vector<Entry> read_runs(const Database& database, const Query& query) {
  constexpr std::size_t kAll = std::numeric_limits<std::int64_t>::max();
  Statement row = asked_runs(database, query,
                             "id, created, job, version, commit_id, label, verdict, result_schema",
                             " ORDER BY id DESC LIMIT ?3");
  row.bind(3, static_cast<std::int64_t>(std::min(query.last.value_or(kAll), kAll)));
  std::vector<Entry> entries;
  while (row.step()) {
    Entry& entry = entries.emplace_back();
    entry.id = row.integer(0);
    entry.created = row.text(1);
    entry.job = row.text(2);
    entry.version = row.text(3);
    entry.commit = row.text(4);
    entry.label = row.text(5);
    entry.verdict = row.text(6);
    entry.result_schema = static_cast<int>(row.integer(7));
  }
  std::reverse(entries.begin(), entries.end());
  return entries;
}

void read_stages(const Database& database, std::vector<Entry>& entries) {
  Statement stage(database, "SELECT name, verdict FROM stage WHERE run = ?1 ORDER BY place");
  for (Entry& entry : entries) {
    stage.bind(1, entry.id);
    while (stage.step()) entry.stages.push_back({stage.text(0), stage.text(1)});
    stage.reset();
  }
}

/// Series that are asked for, in the order of their ids.
std::vector<std::pair<std::int64_t, Series>> asked_series(const Database& database,
                                                          const Query& query) {
  std::vector<std::pair<std::int64_t, Series>> asked;
  Statement row(database, "SELECT id, stage, metric FROM series ORDER BY id");
  while (row.step()) {
    const Series one{row.text(1), row.text(2)};
    if ((one.stage.empty() || is_asked(query.stages, one.stage)) &&
        is_asked(query.metrics, one.metric))
      asked.emplace_back(row.integer(0), one);
  }
  return asked;
}

void read_values(const Database& database, const Query& query, std::vector<Entry>& entries) {
  // A few of many figures are looked up one by one: the others are never read.
  Statement value(database, "SELECT low, high FROM value WHERE run = ?1 AND series = ?2");
  const auto asked = asked_series(database, query);
  for (Entry& entry : entries) {
    for (const auto& [id, series] : asked) {
      value.bind(1, entry.id).bind(2, id);
      if (value.step())
        entry.values.push_back({series.stage, series.metric, value.number(0), value.number(1)});
      value.reset();
    }
  }
}

}  // namespace

History::History(const fs::path& file) : database_(opened(file)) {}
History::~History() = default;
History::History(History&&) noexcept = default;
History& History::operator=(History&&) noexcept = default;

std::vector<Entry> History::runs(const Query& query) const {
  const Transaction snapshot(*database_, Transaction::Kind::read);
  std::vector<Entry> entries = read_runs(*database_, query);
  read_stages(*database_, entries);
  read_values(*database_, query, entries);
  return entries;
}

std::size_t History::count(const Query& query) const {
  Statement row = asked_runs(*database_, query, "count(*)", "");
  row.step();
  return static_cast<std::size_t>(row.integer(0));
}

std::vector<Series> History::series() const {
  std::vector<Series> all;
  Statement row(*database_, "SELECT stage, metric FROM series ORDER BY stage, metric");
  while (row.step()) all.push_back({row.text(0), row.text(1)});
  return all;
}

std::vector<std::string> History::jobs() const {
  std::vector<std::string> names;
  Statement row(*database_, "SELECT DISTINCT job FROM run ORDER BY job");
  while (row.step()) names.push_back(row.text(0));
  return names;
}

}  // namespace limitgauge::history
