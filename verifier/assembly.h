#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "verifier/certificate.h"
#include "verifier/verify.h"

namespace limitgauge::verifier {

/// A convex body of a cutter's assembly above its flutes, `lift_mm` over the tip. Named "shank" or
/// "holder", with a number from the tip up where there are several.
struct AssemblyBody {
  std::string name;
  CutterProfile profile;
  double lift_mm = 0;
};
std::vector<AssemblyBody> bodies_above_flutes(const model::Cutter& cutter);

/// One body of one pass against the allowance surface: how deep it goes, certified as the flutes'
/// gouge is, and the space that it sweeps (absent where it stays above all of S).
struct BodySweep {
  std::size_t stage = 0;
  std::string body;
  Certificate certificate;
  std::optional<RemovedSpace> space;
};

/// All bodies above the flutes of all passes against S. A body never takes away what is uncut: only
/// its gouge counts.
std::vector<BodySweep> certify_assemblies(const SurfaceCells& cells, std::span<const Pass> passes,
                                          const CertificateRequest& request,
                                          const model::RunControl& control);

}  // namespace limitgauge::verifier
