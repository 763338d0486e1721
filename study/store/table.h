#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace limitgauge::study {

/// One value of a varied key: what is put into the job, and the number it stands for where it is
/// one (in the unit that the key has in the job file).
struct Setting {
  std::string toml;              ///< as TOML writes it: `0.2`, `"zigzag"`, `[0, 1]`
  std::optional<double> number;  ///< empty for text, lists and switches

  friend bool operator==(const Setting&, const Setting&) = default;
};

/// One case of a study: a setting for each of its variables, in their order.
struct Case {
  std::size_t index = 0;  ///< in the order of the design, from 0
  std::vector<Setting> settings;
};

/// How a case ended. `error`: the job could not be run with these settings; `lost`: whoever ran it
/// died or did not answer, as often as it was tried.
enum class Status { pass, fail, indeterminate, error, lost };
const char* name(Status status);

/// A figure of finished cases: "finish.uncut_mm.high", "machining_time_s".
struct Figure {
  std::string id;                 ///< unique; what CSV, JSON and study files call it
  std::string label;              ///< for people, without the unit
  std::string unit;               ///< "mm", "s", "mm³", "" for a plain number
  bool optional = false;          ///< a case that came to its end may be without it
  bool larger_is_better = false;  ///< of an objective that is to be large
};

/// One case as it came out.
struct Row {
  Case asked;
  std::string key;  ///< of its result in the store: 64 hexadecimal digits; empty: never known
  Status status = Status::lost;
  std::string reason;  ///< of anything but a pass, one line
  /// In the order of Table::figures; empty where a stage was not run.
  std::vector<std::optional<double>> figures;
  bool reused = false;    ///< the result was in the store already
  unsigned attempts = 0;  ///< 0 for a reused one
  double seconds = 0;     ///< that running it took; says nothing of the result
};

/// What a study found: a row for each case, whatever became of it.
struct Table {
  std::string name, job;          ///< of the study; the job file as the study states it
  std::vector<std::string> keys;  ///< varied ones, in the order of Case::settings
  std::vector<Figure> figures;
  std::vector<Row> rows;  ///< by Case::index
};

}  // namespace limitgauge::study
