#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;

struct sqlite3_stmt;

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

/// A prepared statement. Data only ever reach it through bind().
class Statement {
 public:
  Statement(const Database& database, const std::string& sql);

  /// Parameters count from 1. Text must live until the next step() or reset().
  Statement& bind(int parameter, std::string_view text);
  Statement& bind(int parameter, std::int64_t number);
  Statement& bind(int parameter, double number);

  /// To the next row; false where there is none.
  bool step();
  /// Runs it to its end and makes it ready for other parameters.
  void run();
  void reset();

  /// Columns count from 0.
  std::int64_t integer(int column) const;
  double number(int column) const;
  std::string text(int column) const;

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  const Database* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

}  // namespace limitgauge::history
