#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/defects/nc_text.h"
#include "tests/defects/orientations/machine.h"

namespace limitgauge::tests::defects {

/// What the places of a program mean (docs/rotary.md): joints; the tip's in the workpiece (G43.4,
/// M428); those of a tilted plane (G68.2); the tip's along the machine's axes (G254).
enum class Places { joints, tip, plane, offset };
const char* name(Places places);

/// A slip of the post-processor in one word that says how the tool stands: of an axis, or one of
/// the angles I J K of a tilted plane. It befalls the last way to stand.
struct WordSlip {
  enum class Kind { added, negated, lost } kind = Kind::added;
  std::size_t word = 0;
  double by_deg = 0;  ///< of `added`
};

/// What a post-processor takes the machine, the part in it and the ways to stand to be.
struct Posting {
  Machine machine;
  Places places = Places::joints;
  std::string control;       ///< as in a job
  std::vector<Angles> ways;  ///< one or two; both put the tool along the same axis of the part
  model::Pose lying;         ///< the part to the work's frame, axes at 0
  std::optional<WordSlip> slip;
};

/// A move as the machine makes it.
struct PostedMove {
  bool rapid = false;
  model::Vec3 to;         ///< the tip in the frame of its stretch
  std::size_t line = 0;   ///< of the text, from 1
  std::size_t block = 0;  ///< what it was made of
};

/// Moves while the tool stands one way, in a frame in which that is upright.
struct Stretch {
  model::Pose lying;  ///< the part to that frame, as it truly lies
  model::Vec3 start;
  std::vector<PostedMove> moves;
};

struct Posted {
  std::string text;
  std::vector<Stretch> stretches;
};

/// The program for a machine, as `believed` has everything, and what it does on `real`, in which
/// the part lies as `truly` says. Six decimals; what the moves are is what the text says.
Posted post(const NcText& program, const Posting& believed, const Machine& real,
            const model::Pose& truly);
/// The program of a part that lies still: places in its setup's frame.
Posted post_still(const NcText& program, const model::Pose& believed, const model::Pose& truly);

}  // namespace limitgauge::tests::defects
