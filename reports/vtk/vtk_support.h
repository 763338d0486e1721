#pragma once

// What the files that include VTK share. VTK's headers are seen nowhere else.

#include <vtkObject.h>

#include <filesystem>
#include <span>

#include "reports/vtk/stage_facts.h"

class vtkFieldData;
class vtkXMLWriter;

namespace limitgauge::reports {

/// VTK prints its warnings to standard error; for as long as this lives, it keeps them to itself.
class QuietVtk {
 public:
  QuietVtk() : before_(vtkObject::GetGlobalWarningDisplay()) {
    vtkObject::SetGlobalWarningDisplay(0);
  }
  ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(before_); }
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

 private:
  int before_;
};

/// Point data of a toolpath.vtp whose tool turns: the unit vector from the tip to the spindle.
inline constexpr const char* kAxisColumns[] = {"axis_x", "axis_y", "axis_z"};

void add_facts(vtkFieldData& data, std::span<const Fact> facts);

/// Writes `file` with `writer`, whose input is set: little-endian, compressed. Throws
/// model::ResourceError when that fails; nothing of the file is left then.
void write_xml(vtkXMLWriter& writer, const std::filesystem::path& file);

}  // namespace limitgauge::reports
