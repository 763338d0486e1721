#include "history/database.h"

#include <utility>

#include <sqlite3.h>

#include "model/base/absolute_path.h"
#include "model/base/error.h"
#include "model/text/hexadecimal.h"

namespace limitgauge::history {
namespace {

/// One append takes some ten milliseconds: this is a queue of thousands, or a writer that hangs.
constexpr int kWaitForOthers_ms = 60'000;

/// `file` as the URI that SQLite takes options with.
std::string uri(const std::filesystem::path& file, const std::string& option) {
  return "file:" + model::percent_encoded(model::absolute_path(file).string()) + "?" + option;
}

struct Opening {
  std::string name;
  int flags;
};

Opening opening(const std::filesystem::path& file, Database::Mode mode) {
  switch (mode) {
    case Database::Mode::look:
      // Without it a foreign database that a killed writer left would be rolled back by us.
      return {uri(file, "immutable=1"), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI};
    case Database::Mode::read:
      // Read-only, SQLite could not roll back what a killed writer of ours has left.
      return {file.string(), SQLITE_OPEN_READWRITE};
    case Database::Mode::write:
      break;
  }
  return {file.string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE};
}

[[noreturn]] void fail(const std::filesystem::path& file, int code, const std::string& words) {
  const model::SourcePlace place{file.string(), 0, 0};
  const auto resource = [&](const std::string& wrong) {
    return model::ResourceError(file.string() + ": error: " + wrong + ": " + words);
  };
  switch (code & 0xFF) {
    case SQLITE_NOTADB:
      throw model::InputError(place, "this is no SQLite file", "a history that limitgauge wrote");
    case SQLITE_CORRUPT:
      throw model::InputError(place, "this history is damaged (" + words + ")",
                              "a copy of it that is whole");
    case SQLITE_ERROR:
    case SQLITE_CONSTRAINT:
      // Statements are the program's own: they fail where tables are not what it made.
      throw model::InputError(place, "this history is not as limitgauge wrote it (" + words + ")",
                              "a copy of it that is whole");
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_AUTH:
      throw model::InputError(place, "the history cannot be opened or written (" + words + ")",
                              "a file and a folder that may be written");
    case SQLITE_BUSY:
      throw resource("another process has kept the history locked for a minute");
    case SQLITE_FULL:
      throw resource("there is no room for the history");
    case SQLITE_NOMEM:
      throw resource("there is no memory for the history");
    default:
      throw resource("the history cannot be read or written");
  }
}

}  // namespace

void Database::Close::operator()(sqlite3* handle) const {
  sqlite3_close_v2(handle);
}

Database::Database(std::filesystem::path file, Mode mode) : file_(std::move(file)) {
  const Opening how = opening(file_, mode);
  sqlite3* handle = nullptr;
  const int code = sqlite3_open_v2(how.name.c_str(), &handle, how.flags, nullptr);
  handle_.reset(handle);
  if (handle == nullptr) fail(file_, SQLITE_NOMEM, "sqlite3_open_v2");
  check(code);
  sqlite3_extended_result_codes(handle, 1);
  sqlite3_busy_timeout(handle, kWaitForOthers_ms);
  // A view or trigger that somebody planted must not reach beyond the file.
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
}

Database Database::private_copy() const {
  Database copy("", Mode::write);
  copy.file_ = file_;
  sqlite3_backup* backup = sqlite3_backup_init(copy.handle(), "main", handle(), "main");
  if (backup == nullptr) copy.check(sqlite3_errcode(copy.handle()));
  sqlite3_backup_step(backup, -1);
  copy.check(sqlite3_backup_finish(backup));
  return copy;
}

void Database::execute(const char* sql) const {
  check(sqlite3_exec(handle(), sql, nullptr, nullptr, nullptr));
}

int Database::number(const char* pragma) const {
  Statement statement(*this, pragma);
  return statement.step() ? static_cast<int>(statement.integer(0)) : 0;
}

void Database::check(int code) const {
  if (code != SQLITE_OK) fail(file_, code, sqlite3_errmsg(handle()));
}

Transaction::Transaction(const Database& database, Kind kind) : database_(&database) {
  // A writer that began by reading could be refused its lock in the middle: it takes it at once.
  database.execute(kind == Kind::write ? "BEGIN IMMEDIATE" : "BEGIN");
}

Transaction::~Transaction() {
  // Where SQLite has rolled back by itself (a full disk), this is an error that says nothing new.
  if (open_) sqlite3_exec(database_->handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  database_->execute("COMMIT");
  open_ = false;
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

Statement::Statement(const Database& database, const std::string& sql) : database_(&database) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(database.handle(), sql.c_str(),
                                      static_cast<int>(sql.size()) + 1, &statement, nullptr);
  statement_.reset(statement);
  database.check(code);
}

Statement& Statement::bind(int parameter, std::string_view text) {
  database_->check(sqlite3_bind_text64(statement_.get(), parameter, text.data(), text.size(),
                                       SQLITE_STATIC, SQLITE_UTF8));
  return *this;
}

Statement& Statement::bind(int parameter, std::int64_t number) {
  database_->check(sqlite3_bind_int64(statement_.get(), parameter, number));
  return *this;
}

Statement& Statement::bind(int parameter, double number) {
  database_->check(sqlite3_bind_double(statement_.get(), parameter, number));
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) database_->check(code);
  return false;
}

void Statement::run() {
  while (step()) {
  }
  reset();
}

void Statement::reset() {
  sqlite3_reset(statement_.get());
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double Statement::number(int column) const {
  return sqlite3_column_double(statement_.get(), column);
}

std::string Statement::text(int column) const {
  const unsigned char* bytes = sqlite3_column_text(statement_.get(), column);
  if (bytes == nullptr) return {};
  return {reinterpret_cast<const char*>(bytes),
          static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))};
}

}  // namespace limitgauge::history
