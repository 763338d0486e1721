#pragma once

#include <optional>

#include "reports/run/run_result.h"

namespace limitgauge::reports {

/// What was measured of a stage as it lies in the stage's setup: maps of it are seen from the side
/// that the tool came from. The stage, which must have a deviation, must outlive this.
class ToolSide {
 public:
  explicit ToolSide(const StageResult& stage) : stage_(stage) {
    if (stage.setup.from_part == model::Pose{}) return;
    turned_ = *stage.ran->deviation;
    verifier::turn(*turned_, stage.setup.from_part);
  }
  const verifier::StageDeviation& deviation() const {
    return turned_ ? *turned_ : *stage_.ran->deviation;
  }

 private:
  const StageResult& stage_;
  std::optional<verifier::StageDeviation> turned_;
};

/// "+Z", "−X" or "(0.5, 0, 0.866)": from where the tool's side is seen, in the part's frame.
std::string tool_side_words(const model::Setup& setup);

}  // namespace limitgauge::reports
