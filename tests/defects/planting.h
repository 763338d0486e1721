#pragma once

#include <random>
#include <string>
#include <vector>

#include "tests/defects/nc_text.h"

namespace limitgauge::tests::defects {

enum class Kind {
  sunk_pass,
  raised_pass,
  shifted_pass,
  missing_pass,
  wrong_radius,
  wrong_length,
  wrong_allowance,
  swapped_units,
  skipped_line,
  rotated_offset,
  rapid_through
};
inline constexpr Kind kKinds[] = {Kind::sunk_pass,       Kind::raised_pass,   Kind::shifted_pass,
                                  Kind::missing_pass,    Kind::wrong_radius,  Kind::wrong_length,
                                  Kind::wrong_allowance, Kind::swapped_units, Kind::skipped_line,
                                  Kind::rotated_offset,  Kind::rapid_through};
const char* name(Kind kind);

/// A mishap to be planted: `size_mm` is about how deep it should go.
struct Mishap {
  Kind kind{};
  double size_mm = 0;
  unsigned seed = 0;
};

/// What is run after the mishap: another program, another cutter in the spindle, another allowance
/// in the job than the one the program was made for.
struct Planted {
  NcText program;
  std::string text;  ///< of that
  model::Cutter cutter;
  double allowance_mm = 0;
};

/// What a mishap happens to.
struct Sound {
  const SampledSurface& surface;
  NcText program;
  model::Cutter cutter;
  double allowance_mm = 0;
  double step_mm = 0;
  int across = 0;  ///< axis from row to row
  double safe_z_mm = 0;
};

Planted plant(const Sound& sound, const Mishap& mishap);

}  // namespace limitgauge::tests::defects
