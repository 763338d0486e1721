#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/run/run_result.h"

namespace limitgauge::reports {

/// One line of a program as people see it: cleaned, cut to 160 characters.
struct ProgramLine {
  std::uint32_t line = 0;
  std::string text;
};

/// The lines `wanted` (in any order, 0 is none) of `program` and the `around` lines on either side
/// of each, in their order, each once.
std::vector<ProgramLine> program_lines(std::string_view program,
                                       std::span<const std::uint32_t> wanted, std::uint32_t around);

/// A place in the program of a stage that something was found at.
struct NamedLine {
  std::string name;  ///< "G1", "U3", "P2", "GT": gouge, leftover, process finding, over tolerances
  std::size_t stage = 0;
  std::uint32_t line = 0;
};

/// The lines that the findings of stage `index` name, those of its worst `most` of each kind, as
/// the tables of the page number them.
std::vector<NamedLine> named_lines(const RunResult& result, std::size_t index, std::size_t most);

/// The process findings of a stage as the page lists them: faults first, each by depth.
std::vector<simulator::FindingGroup> worst_first(std::span<const simulator::Finding> findings);

}  // namespace limitgauge::reports
