#pragma once

#include <span>

#include "tests/defects/orientations/job_run.h"
#include "tests/defects/orientations/lying_result.h"
#include "tests/defects/orientations/turned_oracle.h"

namespace limitgauge::tests::defects {

/// A way to lie with a program, and what that truly does.
struct LyingCase {
  Lying lying;
  NcText program;
  Posted posted;
};

/// What the cases of a plan share, in the nominal frame.
struct LyingGround {
  const LyingPlan& plan;
  Target part;
  model::BoxStock stock;

  explicit LyingGround(const LyingPlan& made);
  double safe_z_mm() const { return stock.corner_mm.z + stock.size_mm.z + 1; }
  /// Of the first `stretches` of a case's program.
  TurnedOracle oracle(const LyingCase& lying_case, std::size_t stretches) const;
};

/// What the gate allows; what is deeper by more than the width asked for must be found.
struct LyingGate {
  double gouge_mm = 0, uncut_mm = 0;
};
/// Widest certified interval asked for.
inline constexpr double kLyingResolution_mm = 0.003;

/// Holds what a job said against the oracle.
class LyingJudge {
 public:
  /// `twin_oracle` is that of `twin`, the unharmed case. All must outlive it.
  LyingJudge(const LyingGround& ground, const LyingCase& twin, const TurnedOracle& twin_oracle,
             const LyingGate& gate)
      : ground_(ground), twin_(twin), twin_oracle_(twin_oracle), gate_(gate) {}

  /// Puts figures, what was due and what was found into `result`.
  void judge(const LyingCase& judged, const StageSaid& stage, LyingResult& result) const;

 private:
  /// The two ends of a move in the nominal frame.
  using Ends = std::array<double, 6>;
  struct Judged {
    const LyingCase& lying_case;
    const TurnedOracle& truth;
    const StageSaid& stage;
    std::vector<Ends> touched;  ///< moves that the mishap made or took; none: it changed them all
  };
  static Ends ends(const NcText& program, std::size_t block);
  static std::vector<Ends> changed(const NcText& a, const NcText& b);
  void judge_gouge(const Judged& j, SideResult& side) const;
  void judge_uncut(const Judged& j, SideResult& side) const;
  void find_gouge(const Judged& j, LyingResult& result) const;
  void find_uncut(const Judged& j, SideResult& side) const;
  std::string contradiction(const Judged& j, const NamedPlace& f) const;
  bool beside(const model::Vec3& p, const std::vector<Ends>& touched) const;
  bool cuts_there(const Judged& j, const NamedPlace& f) const;
  bool swept(const Stretch& stretch, std::size_t move, const model::Vec3& p) const;

  const LyingGround& ground_;
  const LyingCase& twin_;
  const TurnedOracle& twin_oracle_;
  const LyingGate& gate_;
};

}  // namespace limitgauge::tests::defects
