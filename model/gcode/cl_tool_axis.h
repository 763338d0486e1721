#pragma once

#include <cstdint>
#include <vector>

#include "model/gcode/cl_lexer.h"
#include "model/geometry/vec3.h"

namespace limitgauge::model {

/// How the tool of CL data stands: along what the last three of six figures say, which holds until
/// others come. It stands along 0,0,1 before the first of them.
class ClToolAxis {
 public:
  /// MULTAX, MULTAX/ON or MULTAX/OFF: behind OFF no figures may turn the tool.
  void set_mode(const ClStatement& statement, const ClLexer& lexer);
  /// Takes what FROM says. Throws InputError as go_to does, but it may turn the tool by any angle.
  Vec3 start_at(const ClStatement& statement, const std::vector<double>& figures,
                const ClLexer& lexer);
  /// Takes what GOTO says: `figures` are all of its figures as numbers, 3 or 6. Throws InputError
  /// for a zero axis, one whose length is not 1 within 1e-3 (post-processors round theirs), a turn
  /// by more than 90 degrees, which leaves open which way, and for a turn behind MULTAX/OFF.
  Vec3 go_to(const ClStatement& statement, const std::vector<double>& figures,
             const ClLexer& lexer);
  /// The first statement of three figures that kept a tool tilted; 0: none.
  std::uint32_t kept_line() const { return kept_line_; }

 private:
  Vec3 stated(const ClStatement& statement, const std::vector<double>& figures,
              const ClLexer& lexer);

  Vec3 axis_{0, 0, 1};
  bool placed_ = false;  ///< by FROM or a GOTO
  bool fixed_ = false;   ///< by MULTAX/OFF
  std::uint32_t kept_line_ = 0;
};

}  // namespace limitgauge::model
