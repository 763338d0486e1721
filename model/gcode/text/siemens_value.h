#pragma once

#include <vector>

#include "model/gcode/text/expression.h"

namespace limitgauge::model::gcode {

/// R0 to R999 are kept as parameters of these numbers.
inline constexpr int kFirstRParameter = 1000, kRParameters = 1000;

/// Reads a value of Siemens's language at the cursor and moves behind it: numbers, R parameters,
/// parentheses, `+ - * /`, DIV, MOD, SIN COS TAN ASIN ACOS SQRT ABS POT TRUNC ROUND; angles in
/// degrees (SINUMERIK, "Fundamentals", "Arithmetic operations and functions"). The R parameters
/// that it reads are added to `read`. What has no finite value goes to `fail`, which must throw.
double read_siemens_value(Cursor& cursor, const Parameters& parameters, const Fail& fail,
                          std::vector<int>& read);

/// The digits of an R parameter behind its letter; throws through `fail` for none and beyond R999.
int read_r_number(Cursor& cursor, const Fail& fail);

}  // namespace limitgauge::model::gcode
