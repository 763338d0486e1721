#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reports/run/run_result.h"

namespace limitgauge::reports {

/// What a finding means for the verdict of its stage.
enum class Significance {
  fails,      ///< proven beyond a limit, or a fault in the process
  undecided,  ///< may be beyond the limit: the certified interval holds it
  informs,    ///< nothing limits it, or a near miss
  within,     ///< the worst place of a figure that is proven inside its limit
};

/// One finding of a stage, of whatever instrument: a gouge, a leftover, or a run of moves with the
/// same process finding.
struct ListedFinding {
  /// As the page numbers it: "G1", "U3", "M1", "P2"; "GT", "UT" the worst over tolerances.
  std::string id;
  std::string
      kind;  ///< "gouge", "uncut", "missing_stock", or a process finding's name in result.json
  Significance significance = Significance::informs;
  std::size_t stage = 0;          ///< that it was found in
  std::size_t program_stage = 0;  ///< whose program `line` and `move` are of
  std::uint32_t line = 0;         ///< 0: no move made it, raw stock stands
  std::size_t move = 0;
  double depth_mm = 0;  ///< of a near miss minus the distance that is left
  model::Vec3 point;
  std::optional<verifier::SurfacePlace> place;  ///< of gouges and leftovers
  std::optional<double> area_mm2;               ///< of these, too
  std::string body;                             ///< "cutter", "shank", "holder", ...
  std::string words;                            ///< what it is, for people
  std::vector<verifier::NearPass> passes;       ///< around a leftover
  std::optional<simulator::FindingGroup> process;
  /// Where it is as a whole, less given to jump than its deepest place: the middle of its box, or
  /// the end of its first move.
  model::Vec3 about;
};

/// Those of a figure over tolerances that are not as stated: "zero.z -0.005 mm, tool.ball3.radius
/// +0.01 mm".
std::string values_text(const std::vector<verifier::NamedLength>& values);

/// All findings of stage `index`: gouges, leftovers, missing stock, process findings, each as the
/// page numbers them. Empty where the stage was not run.
std::vector<ListedFinding> list_findings(const RunResult& result, std::size_t index);

/// The program of a stage: the file as the job states it, or where its own toolpath lies in the
/// output folder.
std::string program_file(const StageResult& stage);

}  // namespace limitgauge::reports
