#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "engine/model/gcode/lexer.h"
#include "engine/model/gcode/parameters.h"

namespace limitgauge::model::gcode {

/// Bounds on what a program may expand to; a program from a stranger must end.
struct FlowLimits {
  std::size_t most_blocks = 200'000'000;  ///< carried out, loops included
  std::size_t most_depth = 100;           ///< of calls and of blocks within blocks together
};

/// Which block of a program comes next: carries out O-words (sub, endsub, return, call, do, while,
/// endwhile, break, continue, if, elseif, else, endif, repeat, endrepeat) as LinuxCNC does, and
/// Fanuc's M98 P L, M99 and O-number subprograms behind the main program's end, in the same file.
/// Sets the parameters of a line after it has been read whole. A subroutine in another file is an
/// error that says so.
class Flow {
 public:
  Flow(Lexer& lexer, Parameters& parameters, FlowLimits limits = {});

  /// The next block to carry out; false at the end of the program. Throws InputError with the place
  /// for labels that do not match, calls without their subroutine, values that are missing, and
  /// limits that are exceeded.
  bool next(Block& block);
};

}  // namespace limitgauge::model::gcode
