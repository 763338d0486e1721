#pragma once

namespace limitgauge::simulator {

/// Seen from above.
struct FlatPoint {
  double x = 0, y = 0;
};

/// On which side of the line from a to b the point p is: +1 left, −1 right, 0 on it. Exact for all
/// coordinates whose products neither overflow nor underflow: a filter first, then error-free
/// sums (J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997).
int side_of_line(const FlatPoint& a, const FlatPoint& b, const FlatPoint& p);

}  // namespace limitgauge::simulator
