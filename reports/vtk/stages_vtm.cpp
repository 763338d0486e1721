#include <vtkCompositeDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLMultiBlockDataWriter.h>

#include <algorithm>
#include <optional>
#include <system_error>

#include "reports/run/report.h"
#include "reports/vtk/vtk_support.h"

namespace limitgauge::reports {
namespace {

constexpr const char* kFileKey = "file";

/// VTK's writer of collections, for leaves that are files already: it names them in the collection
/// and writes none of them.
class CollectionWriter : public vtkXMLMultiBlockDataWriter {
 public:
  static CollectionWriter* New() { VTK_STANDARD_NEW_BODY(CollectionWriter); }

 protected:
  int WriteNonCompositeData(vtkDataObject* leaf, vtkXMLDataElement* entry, int& /*index*/,
                            const char* /*file of its own*/) override {
    auto* file = vtkStringArray::SafeDownCast(leaf->GetFieldData()->GetAbstractArray(kFileKey));
    if (!file) return 0;
    entry->SetAttribute("file", file->GetValue(0).c_str());
    return 1;
  }
};

void name_block(vtkMultiBlockDataSet& parent, unsigned index, const std::string& name) {
  parent.GetMetaData(index)->Set(vtkCompositeDataSet::NAME(), name.c_str());
}

/// Those of the stage's VTK files that are there; none where there is none.
vtkSmartPointer<vtkMultiBlockDataSet> stage_block(const std::string& stage,
                                                  const std::filesystem::path& folder) {
  vtkNew<vtkMultiBlockDataSet> block;
  unsigned count = 0;
  for (const char* name : {"deviation", "stock", "toolpath"}) {
    const std::filesystem::path file = std::filesystem::path(stage) / (std::string(name) + ".vtp");
    if (!std::filesystem::exists(folder / file)) continue;
    vtkNew<vtkPolyData> leaf;
    const Fact where{kFileKey, file.generic_string()};
    add_facts(*leaf->GetFieldData(), {&where, 1});
    block->SetBlock(count, leaf);
    name_block(*block, count++, name);
  }
  return count > 0 ? block.Get() : nullptr;
}

/// VTK makes a folder beside the collection for the leaves that it would have written.
class LeavesFolder {
 public:
  explicit LeavesFolder(std::filesystem::path file)
      : folder_(file.replace_extension()), was_there_(std::filesystem::exists(folder_)) {}
  ~LeavesFolder() {
    std::error_code ignored;
    if (!was_there_) std::filesystem::remove(folder_, ignored);
  }
  LeavesFolder(const LeavesFolder&) = delete;
  LeavesFolder& operator=(const LeavesFolder&) = delete;

 private:
  std::filesystem::path folder_;
  bool was_there_;
};

}  // namespace

void write_stages_vtm(const RunResult& result, const std::filesystem::path& folder) {
  vtkNew<vtkMultiBlockDataSet> stages;
  unsigned count = 0;
  for (const StageResult& stage : result.stages) {
    const auto block = stage_block(stage.name, folder);
    if (!block) continue;
    stages->SetBlock(count, block);
    name_block(*stages, count++, stage.name);
  }
  if (count == 0) return;
  const Fact facts[] = {{"job", result.job},
                        {"verdict", std::string(verifier::name(result.verdict))},
                        {"units", std::string("mm")}};
  add_facts(*stages->GetFieldData(), facts);
  const std::filesystem::path file = folder / "stages.vtm";
  const LeavesFolder leaves(file);
  vtkNew<CollectionWriter> writer;
  writer->SetInputData(stages);
  write_xml(*writer, file);
}

}  // namespace limitgauge::reports
