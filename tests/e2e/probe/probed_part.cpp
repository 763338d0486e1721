#include "tests/e2e/probe/probed_part.h"

#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace {

using model::Vec3;

constexpr const char* kProgram = R"(G21 G90 G17
T1 M6
S8000 M3
G0 Z10
G0 X10 Y10
G1 Z-3 F600
G1 X40
G1 Y30
G1 X10
G1 Y10
G1 Y20
G1 X40
G0 Z10
M5
T2 M6
S8000 M3
G0 X-6 Y20
G1 Z-5 F600
G1 X56
G0 Z10
M5
M30
)";

/// Evenly distributed, the same with every library.
class Dice {
 public:
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) + 0.5) / 4294967296.0;
  }
  double normal() {
    return std::sqrt(-2 * std::log(between(0, 1))) * std::cos(2 * std::numbers::pi * between(0, 1));
  }

 private:
  std::mt19937 engine_{20261126};
};

SurfacePoint on_floor(Dice& dice) {
  return {{dice.between(8, 42), dice.between(6, 15), -3}, {0, 0, 1}};
}

SurfacePoint on_wall(Dice& dice, std::size_t which) {
  const double z = dice.between(-2.9, -0.2), x = dice.between(11, 39), y = dice.between(11, 15);
  switch (which % 4) {
    case 0:
      return {{4, y, z}, {1, 0, 0}};
    case 1:
      return {{46, y, z}, {-1, 0, 0}};
    case 2:
      return {{x, 4, z}, {0, 1, 0}};
    default:
      return {{x, 36, z}, {0, -1, 0}};
  }
}

SurfacePoint in_groove(Dice& dice) {
  const double turn = dice.between(-1.1, 1.1);
  const Vec3 normal{0, -std::sin(turn), std::cos(turn)};
  return {Vec3{dice.between(8, 42), 20, -2} - 3 * normal, normal};
}

}  // namespace

void cut_part(const Scratch& scratch, const std::string& output) {
  write_text(scratch / "part.ngc", kProgram);
  const Outcome outcome =
      limitgauge(scratch, {"cut", "--stock", "box:50,40,20@0,0,-20", "--tool", "1=flat:D=12,L=20",
                           "--tool", "2=ball:D=6,L=20", "--program", "part.ngc", "--voxel", "0.5",
                           "--no-pictures", "--quiet", "-o", output});
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
}

std::vector<SurfacePoint> floor_points(std::size_t count) {
  Dice dice;
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(on_floor(dice));
  return points;
}

std::vector<SurfacePoint> part_points(std::size_t count) {
  Dice dice;
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(i % 4 == 0   ? on_floor(dice)
                     : i % 4 == 1 ? in_groove(dice)
                                  : on_wall(dice, i / 4 * 2 + i % 4));
  return points;
}

std::string measured_table(const std::vector<SurfacePoint>& points, const Vec3& shift_mm,
                           double u_mm, bool with_u) {
  Dice dice;
  std::ostringstream out;
  out.precision(12);
  out << (with_u ? "x,y,z,u_mm\n" : "x,y,z\n");
  for (const SurfacePoint& point : points) {
    const Vec3 at = point.at + shift_mm + u_mm * dice.normal() * point.normal;
    out << at.x << ',' << at.y << ',' << at.z;
    if (with_u) out << ',' << u_mm;
    out << '\n';
  }
  return out.str();
}

Outcome probe(const Scratch& scratch, const std::string& result, const std::string& output,
              const std::vector<std::string>& more) {
  std::vector<std::string> words = {"probe", result, "points.csv", "-o", output};
  words.insert(words.end(), more.begin(), more.end());
  return limitgauge(scratch, words);
}

nlohmann::json probe_json(const Scratch& scratch, const std::string& output) {
  return nlohmann::json::parse(read_text(scratch / (output + "/probe.json")));
}

}  // namespace limitgauge::e2e
