#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <variant>
#include <vector>

#include "model/part/cutter.h"
#include "model/part/stock.h"
#include "reports/record/run_record.h"

namespace limitgauge::reports::record {

/// Raw stock from a file: what a result says of it. The file itself is no part of a result.
struct StockFileRecord {
  bool is_vdb = false;
  std::string file;  ///< as the job states it
  std::size_t triangles = 0;
  model::Box3 box_mm;
};

/// What one stage cut with, and how exactly its moves stand for the program.
struct StageCut {
  std::string name;
  bool ran = false;  ///< where not, the rest says nothing
  verifier::Verdict verdict = verifier::Verdict::not_run;
  model::Cutter cutter;  ///< the fluted part alone
  std::size_t moves = 0;
  double chord_error_mm = 0;
  model::Pose from_part;  ///< how the part lay, its cutter along +Z
};

/// All that result.json says of the stock that was simulated.
struct StockRecord {
  std::string job, version;
  std::variant<model::BoxStock, model::CylinderStock, StockFileRecord> raw;
  std::vector<StageCut> stages;  ///< in the order of the job
  std::vector<InputRecord> inputs;
};

/// Reads it from result.json, schema limitgauge.result/2; `shown` names it in errors. Throws
/// model::InputError as read_result_json does, and for results of schema 1, whose figures mean
/// something else.
StockRecord read_stock_record(std::istream& in, const std::string& shown);

}  // namespace limitgauge::reports::record
