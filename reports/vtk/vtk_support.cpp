#include "reports/vtk/vtk_support.h"

#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkXMLWriter.h>

#include <system_error>

#include "model/base/error.h"
#include "reports/vtk/zlib_blocks.h"

namespace limitgauge::reports {
namespace {

void add_fact(vtkFieldData& data, const std::string& name, double value) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(value);
  data.AddArray(array);
}

void add_fact(vtkFieldData& data, const std::string& name, const std::string& value) {
  vtkNew<vtkStringArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(value);
  data.AddArray(array);
}

}  // namespace

void add_facts(vtkFieldData& data, std::span<const Fact> facts) {
  for (const Fact& fact : facts)
    std::visit([&](const auto& value) { add_fact(data, fact.name, value); }, fact.value);
}

void write_xml(vtkXMLWriter& writer, const std::filesystem::path& file) {
  const QuietVtk quiet;
  writer.SetFileName(file.c_str());
  writer.SetByteOrderToLittleEndian();
  writer.SetHeaderTypeToUInt64();
  // Blocks of 256 KiB: eight times VTK's own, fewer calls and a little smaller.
  const vtkNew<ZlibBlocks> blocks;
  writer.SetCompressor(blocks);
  writer.SetBlockSize(std::size_t{1} << 18);
  const bool is_written = writer.Write() != 0;
  if (is_written && writer.GetErrorCode() == vtkErrorCode::NoError) return;
  const unsigned long code = writer.GetErrorCode();
  const std::string reason = code == vtkErrorCode::NoError
                                 ? ""
                                 : std::string(": ") + vtkErrorCode::GetStringFromErrorCode(code);
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  throw model::ResourceError(file.string() + ": error: cannot write the file" + reason);
}

}  // namespace limitgauge::reports
