#pragma once

#include <cmath>
#include <cstdint>

namespace limitgauge::simulator {

/// A number of voxels as whole ones and shares of 2⁻³², so that the sum does not depend on the
/// order in which its parts are added. A share is off by 2⁻³³ at most; 2³¹ of them fit.
class VolumeSum {
 public:
  void add_whole(std::uint64_t voxels) { whole_ += voxels; }
  void add_share(double share) {
    shares_ += static_cast<std::uint64_t>(std::llround(share * kUnit));
  }
  VolumeSum& operator+=(const VolumeSum& b) {
    whole_ += b.whole_, shares_ += b.shares_;
    return *this;
  }
  double voxels() const {
    return static_cast<double>(whole_) + static_cast<double>(shares_) / kUnit;
  }

 private:
  static constexpr double kUnit = 4294967296.0;
  std::uint64_t whole_ = 0, shares_ = 0;
};

}  // namespace limitgauge::simulator
