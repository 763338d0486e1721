#include "app/probe/result_stock.h"

#include <algorithm>
#include <memory>
#include <sstream>
#include <utility>

#include "app/inputs/stock_file.h"
#include "app/output/checksum.h"
#include "app/output/manifest.h"
#include "app/output/output_folder.h"
#include "model/base/error.h"
#include "model/base/text_file.h"
#include "model/text/message_text.h"
#include "reports/record/stock_record.h"
#include "reports/vtk/toolpath_reader.h"

namespace limitgauge::app {
namespace fs = std::filesystem;
namespace {

using reports::record::StageCut;
using reports::record::StockFileRecord;
using reports::record::StockRecord;

constexpr const char* kMovesFile = "toolpath.vtp";
/// A mesh is where the result says it was within this: the rounding of its coordinates in
/// result.json is none, that of a file's own digits less.
constexpr double kSamePlace_mm = 1e-6;

/// The files of one result, as far as its manifest vouches for them.
class ResultFolder {
 public:
  explicit ResultFolder(fs::path folder) : folder_(std::move(folder)) {}

  /// Throws where the file is missing or another one than was written.
  fs::path file(const fs::path& entry, const std::string& what) {
    const fs::path path = folder_ / entry;
    std::error_code ignored;
    if (!fs::exists(path, ignored))
      throw model::InputError({path.string(), 0, 0}, "is missing: " + what,
                              "the whole folder that run, verify or cut wrote, which that command "
                              "writes again; a study's cases have no toolpaths");
    const Sealed state = sealed(folder_, entry);
    if (state == Sealed::otherwise)
      throw model::InputError(
          {path.string(), 0, 0},
          "is not as it was written: " + std::string(kManifestFile) + " says otherwise",
          "the files of one result, unchanged");
    if (state == Sealed::unknown) is_checked_ = false;
    return path;
  }
  bool is_checked() const { return is_checked_; }

 private:
  fs::path folder_;
  bool is_checked_ = true;
};

[[noreturn]] void refuse_stage(const fs::path& file, const std::string& wrong,
                               const std::string& expected) {
  throw model::InputError({file.string(), 0, 0}, wrong, expected);
}

/// The place of the stage that is asked for, which ran.
std::size_t stage_asked_for(const StockRecord& record, const std::string& asked,
                            const std::vector<std::string_view>& ran, const fs::path& file) {
  const auto found = std::find_if(record.stages.begin(), record.stages.end(),
                                  [&](const StageCut& stage) { return stage.name == asked; });
  if (found == record.stages.end())
    refuse_stage(file, "has no stage " + model::in_quotes(asked),
                 model::in_quotes(model::nearest_word(asked, ran)) + " or another");
  if (!found->ran)
    refuse_stage(file, "stage " + model::in_quotes(asked) + " was not run",
                 "one up to " + model::in_quotes(ran.back()));
  return static_cast<std::size_t>(found - record.stages.begin());
}

/// How many stages cut the stock that is asked for.
std::size_t stages_asked_for(const StockRecord& record, const ProbeCommand& command,
                             const fs::path& file) {
  std::vector<std::string_view> ran;
  for (const StageCut& stage : record.stages)
    if (stage.ran) ran.push_back(stage.name);
  if (ran.empty()) refuse_stage(file, "no stage of it was run", "a result with a stock");
  if (command.stage.empty()) return ran.size();
  return stage_asked_for(record, command.stage, ran, file) + 1;
}

/// Stages run one after the other, each into a folder of its name.
void require_in_order(const StockRecord& record, std::size_t count, const fs::path& file) {
  const std::string expected = "a result as limitgauge writes it";
  for (std::size_t i = 0; i < count; ++i) {
    const StageCut& stage = record.stages[i];
    const std::string named = "stage " + model::in_quotes(stage.name);
    if (!stage.ran) refuse_stage(file, named + " was not run, but one behind it was", expected);
    if (fs::path(stage.name).filename() != stage.name || stage.name == "." || stage.name == "..")
      refuse_stage(file, named + " is no name of a folder", expected);
  }
}

model::Pass read_pass(const StageCut& stage, ResultFolder& folder) {
  const fs::path file = folder.file(fs::path(stage.name) / kMovesFile,
                                    "it has the moves of stage " + model::in_quotes(stage.name));
  auto [path, axes] = reports::read_toolpath_vtp(file);
  if (path.moves.size() != stage.moves)
    throw model::InputError({file.string(), 0, 0},
                            "has " + std::to_string(path.moves.size()) + " moves and result.json " +
                                "says " + std::to_string(stage.moves),
                            "the files of one result");
  path.chord_error_mm = stage.chord_error_mm;
  // The file has places of the part's frame.
  if (stage.from_part != model::Pose{}) {
    path = turned(path, stage.from_part);
    if (axes) axes = turned(*axes, stage.from_part);
  }
  model::Pass pass{stage.cutter, std::make_shared<const model::Toolpath>(std::move(path)),
                   stage.from_part.inverse()};
  if (axes) pass.axes = std::make_shared<const model::ToolAxes>(std::move(*axes));
  return pass;
}

/// What the result says of the file's contents, where it says it.
void require_same_file(const fs::path& file, const StockRecord& record) {
  for (const reports::record::InputRecord& input : record.inputs)
    if (input.role == "stock" && input.sha256 != file_checksum(file).sha256)
      throw model::InputError({file.string(), 0, 0},
                              "is not the raw stock of this result: its checksum is another",
                              "the file that the result calls " + model::in_quotes(input.file));
}

void require_same_place(const fs::path& file, const model::MeshStock& mesh,
                        const StockFileRecord& said) {
  const model::Box3 box = bounding_box(*mesh.mesh);
  const double apart =
      std::max(distance(box.low, said.box_mm.low), distance(box.high, said.box_mm.high));
  if (apart <= kSamePlace_mm && mesh.mesh->triangles.size() == said.triangles) return;
  throw model::InputError({file.string(), 0, 0},
                          "the job scaled or moved this stock, and the result does not say how",
                          "a result whose stock is taken as its file has it");
}

model::Stock stock_of_file(const StockFileRecord& said, const StockRecord& record,
                           const ProbeCommand& command, const fs::path& file,
                           std::vector<std::string>& remarks) {
  if (command.stock.empty())
    throw model::InputError({file.string(), 0, 0},
                            "the raw stock came from the file " + model::in_quotes(said.file) +
                                ", which is no part of a result",
                            "--stock FILE with that file");
  model::require_file(command.stock);
  require_same_file(command.stock, record);
  StockFile read = said.is_vdb ? load_vdb_stock(command.stock, said.file)
                               : load_mesh_stock(command.stock, said.file, {});
  require_same_place(command.stock, read.stock, said);
  remarks.insert(remarks.end(), read.assumptions.begin(), read.assumptions.end());
  return std::move(read.stock);
}

model::Stock raw_stock(const StockRecord& record, const ProbeCommand& command, const fs::path& file,
                       std::vector<std::string>& remarks) {
  if (const auto* said = std::get_if<StockFileRecord>(&record.raw))
    return stock_of_file(*said, record, command, file, remarks);
  if (!command.stock.empty())
    throw model::InputError({file.string(), 0, 0}, "the raw stock of this result came from no file",
                            "the command without --stock");
  if (const auto* box = std::get_if<model::BoxStock>(&record.raw)) return *box;
  return std::get<model::CylinderStock>(record.raw);
}

struct StagesRead {
  std::vector<reports::probe::CutBy> stages;
  std::vector<model::Pass> passes;
};

StagesRead read_stages(const StockRecord& record, std::size_t count, ResultFolder& folder,
                       const model::RunControl& control) {
  StagesRead read;
  for (std::size_t i = 0; i < count; ++i) {
    control.check();
    const StageCut& stage = record.stages[i];
    read.passes.push_back(read_pass(stage, folder));
    read.stages.push_back({stage.name, to_text(stage.cutter), stage.moves, stage.chord_error_mm});
  }
  control.check();
  return read;
}

}  // namespace

ResultStock read_result_stock(const ProbeCommand& command, const model::RunControl& control) {
  const fs::path file = result_file(command.result);
  const std::string text = model::read_text_file(file);
  std::istringstream in(text);
  const StockRecord record = reports::record::read_stock_record(in, file.string());
  ResultFolder folder(file.parent_path());
  folder.file(file.filename(), "it is the result");
  const std::size_t count = stages_asked_for(record, command, file);
  require_in_order(record, count, file);
  std::vector<std::string> remarks;
  const model::Stock stock = raw_stock(record, command, file, remarks);
  StagesRead read = read_stages(record, count, folder, control);
  if (!folder.is_checked())
    remarks.push_back(std::string("there is no ") + kManifestFile +
                      " beside the result: nobody knows whether its files were changed");
  verifier::RemovedSpace removed(stock, read.passes);
  return {record.job,
          record.version,
          sha256_of(text),
          record.stages[count - 1].verdict,
          std::move(read.stages),
          std::move(read.passes),
          std::move(removed),
          std::move(remarks)};
}

}  // namespace limitgauge::app
