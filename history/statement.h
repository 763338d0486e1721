#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3_stmt;

namespace limitgauge::history {

class Database;

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
