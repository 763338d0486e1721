#include "tests/simulator/setups/turned_bench.h"

#include "tests/support/effort.h"

namespace limitgauge::simulator::test {

using model::CutterType;
using model::Pose;
using model::Vec3;

namespace {

Pose shifted(Pose pose, const Vec3& shift) {
  pose.shift_mm = shift;
  return pose;
}

}  // namespace

std::vector<NamedPose> setup_poses() {
  return {{"turned over", shifted(model::turn_about({1, 0, 0}, 180), {3, -2, -8})},
          {"on its side", shifted(model::turn_about({0, 1, 0}, 90), {1, 2.5, -12})},
          {"leaning", shifted(model::turn_about({1, 2, 3}, 37), {-4, 0.3, 2})},
          {"shifted", shifted({}, {0.25, -7, 3})}};
}

model::BoxStock setup_block() {
  return {{-12, -9, -8}, {24, 18, 8}};
}

std::vector<model::Cutter> setup_cutters() {
  return {cutter(CutterType::flat, 4, 9), cutter(CutterType::ball, 5, 9),
          cutter(CutterType::bull, 5, 9, 1), cutter(CutterType::taper, 2, 9, 0.5, 12)};
}

std::vector<TurnedCase> turned_cases() {
  std::vector<TurnedCase> all;
  for (const NamedPose& to : setup_poses())
    for (const model::Cutter& c : setup_cutters())
      all.push_back({to, c, static_cast<unsigned>(all.size() + 1)});
  return all;
}

std::vector<TurnedCase> few_turned_cases() {
  const auto all = turned_cases();
  return {all[0], all[5], all[10], all[15]};
}

std::vector<TurnedCase> many_turned_cases() {
  std::vector<TurnedCase> all = turned_cases();
  PlaceDraw draw({{-1, -1, -1}, {1, 1, 1}}, 17);
  for (int i = 0; i < tests::by_effort(4, 24); ++i) {
    const Pose pose = shifted(model::turn_about(draw(), draw.between(-180, 180)), draw() * 20.0);
    all.push_back({{"drawn", pose}, setup_cutters()[i % 4], static_cast<unsigned>(100 + i)});
  }
  return all;
}

Pass moves_of_all_kinds(const model::Cutter& c, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<> x(-13, 13), y(-10, 10), z(-6, 2), step(-1, 1);
  PathBuilder b({0, 0, 12});
  Vec3 at{x(random), y(random), 12};
  b.rapid(at);
  for (int i = 0; i < 40; ++i) {
    if (i % 5 == 0) at = {x(random), y(random), z(random)};
    if (i % 5 == 1) at.z = z(random);
    if (i % 5 == 2) at.x = x(random), at.y = y(random);
    if (i % 5 > 2) at += {step(random), step(random), 0.3 * step(random)};
    if (i % 7 == 0)
      b.rapid(at);
    else
      b.feed(at);
    if (i % 20 == 0) b.feed(at);
  }
  return b.pass(c);
}

Pass placed(const Pass& pass, const Pose& pose) {
  return {pass.cutter, pass.path, pose};
}

Vec3 PlaceDraw::operator()() {
  Vec3 p;
  for (int a = 0; a < 3; ++a) p[a] = between(box_.low[a], box_.high[a]);
  return p;
}

double PlaceDraw::between(double low, double high) {
  return std::uniform_real_distribution<>(low, high)(random_);
}

}  // namespace limitgauge::simulator::test
