#pragma once

#include <string>
#include <vector>

#include "model/part/cage.h"
#include "verifier/gate/verify.h"

namespace limitgauge::tests::defects {

enum class SceneKind {
  ridge,
  rim,
  fin,
  hole,
  cusp,
  thin_block,
  flipped_sheet,
  undercut,
  several_tools,
  first_motions,
  sliced_shank
};
inline constexpr SceneKind kSceneKinds[] = {
    SceneKind::ridge,         SceneKind::rim,         SceneKind::fin,
    SceneKind::hole,          SceneKind::cusp,        SceneKind::thin_block,
    SceneKind::flipped_sheet, SceneKind::undercut,    SceneKind::several_tools,
    SceneKind::first_motions, SceneKind::sliced_shank};
const char* name(SceneKind kind);

/// A part, a block and programs with one defect whose depth and place follow from its making, or
/// the like of them without it.
struct Scene {
  enum class Side { gouge, uncut, reach };
  SceneKind kind{};
  std::string label;
  bool harmed = true;
  Side side = Side::uncut;
  model::Cage cage;
  model::BoxStock stock;
  std::vector<verifier::Pass> passes;
  verifier::GateLimits limits;
  /// What the certified interval must hold: a run of `depth_mm`, or as long as `most_mm` where the
  /// tolerance of contact decides. Of a twin nothing deeper than the gate.
  double depth_mm = 0, most_mm = 0;
  /// Where it is: the deepest finding lies within a distance of it in plan.
  bool has_place = false;
  model::Vec3 place;
  double within_mm = 0;
};

/// All scenes, in an order in which any first part has some of every kind.
std::vector<Scene> suite_scenes();

struct SceneResult {
  SceneKind kind{};
  std::string label, broken;
  bool harmed = true, located = true, contained = true;
  verifier::Verdict verdict = verifier::Verdict::not_run;
  verifier::Interval certified;
  double depth_mm = 0, seconds = 0;
  bool missed() const { return harmed && verdict != verifier::Verdict::fail; }
  bool false_alarm() const { return !harmed && verdict == verifier::Verdict::fail; }
  bool good() const {
    return broken.empty() && !missed() && !false_alarm() && located && contained;
  }
};
SceneResult run_scene(const Scene& scene);

}  // namespace limitgauge::tests::defects
