#pragma once

#include <filesystem>
#include <memory>
#include <string>

struct sqlite3;

namespace limitgauge::history {

/// A connection to a file of SQLite; errors become the project's own.
class Database {
 public:
  enum class Mode {
    look,   ///< at the header: takes no lock, rolls nothing back
    read,   ///< the file must be there; what a killed writer left is rolled back where that may be
    write,  ///< makes the file
  };
  Database(std::filesystem::path file, Mode mode);

  /// The same content in a file of nobody's, gone with the connection.
  Database private_copy() const;

  /// One or more statements that give no rows and hold no data.
  void execute(const char* sql) const;
  /// The one number that `pragma` gives.
  int number(const char* pragma) const;

  sqlite3* handle() const { return handle_.get(); }
  const std::filesystem::path& file() const { return file_; }
  /// Throws what `code` of the last call means to the user, unless it is SQLITE_OK.
  void check(int code) const;

 private:
  struct Close {
    void operator()(sqlite3* handle) const;
  };
  std::filesystem::path file_;  ///< as errors name it
  std::unique_ptr<sqlite3, Close> handle_;
};

/// All that is done until commit(), or nothing of it. Waits for other writers where it is to write.
class Transaction {
 public:
  enum class Kind { read, write };
  Transaction(const Database& database, Kind kind);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  const Database* database_;
  bool open_ = true;
};

}  // namespace limitgauge::history
