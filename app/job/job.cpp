#include "app/job/job.h"

#include "engine/strategy/axes/leaning_axis.h"

namespace limitgauge::app {

std::vector<double> tilt_grid() {
  constexpr double kStep_deg = 5;
  std::vector<double> tilts = {0};
  for (double tilt = kStep_deg; tilt <= engine::strategy::kMostLean_deg; tilt += kStep_deg) {
    tilts.push_back(tilt);
    tilts.push_back(-tilt);
  }
  return tilts;
}

const char* strategy_name(engine::strategy::Strategy strategy) {
  switch (strategy) {
    case engine::strategy::Strategy::contour:
      return "contour";
    case engine::strategy::Strategy::zigzag:
      return "zigzag";
    case engine::strategy::Strategy::steep_shallow:
      return "steep_shallow";
    case engine::strategy::Strategy::rest:
      break;
  }
  return "rest";
}

std::string to_text(const ProgramPart& part) {
  if (part.tool) return "T" + std::to_string(*part.tool);
  if (part.section) return "section " + std::to_string(*part.section);
  return part.comment.empty() ? std::string() : "from (" + part.comment + ")";
}

std::string to_text(const StagePiece& piece) {
  return "stretch " + std::to_string(piece.number) + " of " + std::to_string(piece.count) + ", " +
         piece.angles;
}

bool only_positions(const JobStage& stage) {
  return stage.piece && !stage.piece->cuts && stage.piece->stage_cuts;
}

}  // namespace limitgauge::app
