// Times a synthetic finish stage: ball R3 rows 0.1 mm apart over a paraboloid dome of 80×65 mm,
// 260,000 moves of 0.25 mm. Prints lines NAME VALUE.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>

#include "simulator/collision.h"
#include "simulator/stock_model.h"

namespace {

using namespace limitgauge;
using model::Vec3;

// Prints the wall clock and processor time of one piece of work: on a busy machine only the second
// says much.
class Stopwatch {
 public:
  void print(const char* name) {
    const auto wall = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();
    std::printf("%s_s %.3f\n%s_cpu_s %.3f\n", name,
                std::chrono::duration<double>(wall - wall_).count(), name,
                static_cast<double>(cpu - cpu_) / CLOCKS_PER_SEC);
    wall_ = wall, cpu_ = cpu;
  }

 private:
  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
  std::clock_t cpu_ = std::clock();
};

// Tip positions that touch z = −0.005 (x² + y²) from above with a ball of radius `r`.
Vec3 tip(double x, double y, double r) {
  constexpr double kBend = 0.005;
  const Vec3 normal = model::normalized({2 * kBend * x, 2 * kBend * y, 1});
  return Vec3{x, y, -kBend * (x * x + y * y)} + normal * r - Vec3{0, 0, r};
}

model::Toolpath dome_raster(double r, double row, double step, double above) {
  model::Toolpath path;
  path.start = {-40, -32.5, 20};
  bool forward = true;
  const auto go = [&](const Vec3& to, model::MoveKind kind) {
    path.moves.push_back({to + Vec3{0, 0, above}, 1000, 1, kind});
  };
  for (double y = -32.5; y <= 32.5; y += row, forward = !forward) {
    const double side = forward ? -1 : 1;
    go(tip(side * 40, y, r) + Vec3{0, 0, 20}, model::MoveKind::rapid);
    for (double x = -40; x <= 40; x += step) go(tip(-side * x, y, r), model::MoveKind::feed);
    go(tip(-side * 40, y, r) + Vec3{0, 0, 20}, model::MoveKind::rapid);
  }
  return path;
}

double peak_mib() {
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line))
    if (line.rfind("VmHWM:", 0) == 0) return std::atof(line.c_str() + 6) / 1024;
  return 0;
}

model::Cutter ball(double radius) {
  model::Cutter c;
  c.id = "ball", c.type = model::CutterType::ball, c.diameter_mm = 2 * radius;
  c.corner_radius_mm = radius, c.flute_length_mm = 24;
  c.holder = {{40, 30}};
  return c;
}

}  // namespace

int main(int argc, char** argv) {
  const double voxel = argc > 1 ? std::atof(argv[1]) : 0.1;
  const model::RunControl control{argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 2};
  const simulator::Pass semi{
      ball(3), std::make_shared<const model::Toolpath>(dome_raster(3, 0.25, 0.25, 0.2))};
  const simulator::Pass finish{
      ball(3), std::make_shared<const model::Toolpath>(dome_raster(3, 0.1, 0.2, 0))};
  std::printf("semi_moves %zu\nfinish_moves %zu\n", semi.path->moves.size(),
              finish.path->moves.size());
  Stopwatch watch;
  simulator::StockModel stock(model::BoxStock{{-45, -40, -20}, {90, 80, 30}}, voxel, 4ull << 30);
  watch.print("raw");
  stock = stock.cut(semi, control);
  watch.print("semi_cut");
  const simulator::StockModel done = stock.cut(finish, control);
  watch.print("finish_cut");
  const auto report = simulator::find_collisions(stock, finish, 0.01, control);
  watch.print("collisions");
  std::printf("collisions %zu\n", report.rapid.size() + report.holder.size());
  std::printf("volume_mm3 %.6f\n", done.volume_mm3());
  watch.print("volume");
  const auto points = done.surface_points(control);
  watch.print("points");
  double worst = 0;
  for (const auto& p : points) worst = std::max(worst, p.residual_mm);
  std::printf("points %zu\nworst_residual_mm %.3g\n", points.size(), worst);
  std::printf("triangles %zu\n", done.surface_mesh().triangles.size());
  watch.print("mesh");
  std::printf("model_mib %.1f\npeak_mib %.1f\n", static_cast<double>(done.memory_bytes()) / 1048576,
              peak_mib());
}
