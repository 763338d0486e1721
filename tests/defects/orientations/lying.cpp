#include "tests/defects/orientations/lying.h"

#include <cmath>

namespace limitgauge::tests::defects {
namespace {

using model::Pose;
using model::Vec3;
using Random = std::mt19937;

std::size_t choice(Random& random, std::size_t count) {
  return random() % count;
}
double either_sign(Random& random) {
  return random() % 2 == 0 ? 1 : -1;
}
/// Angles of a program: three decimals.
double some_angle(Random& random, double a, double b) {
  return std::round(between(random, a, b) * 1000) / 1000;
}
Vec3 somewhere(Random& random, double half) {
  return {between(random, -half, half), between(random, -half, half), between(random, -half, half)};
}
Vec3 any_direction(Random& random) {
  Vec3 v;
  do v = somewhere(random, 1);
  while (length(v) > 1 || length(v) < 0.1);
  return normalized(v);
}
Vec3 level_direction(Random& random) {
  const double a = between(random, 0, 6.28318);
  return {std::cos(a), std::sin(a), 0};
}

/// A turn the wrong way round shall still leave the part before the tool.
constexpr double kLeastTilt_deg = 3, kMostTilt_deg = 24;
double tilt(Random& random) {
  return either_sign(random) * some_angle(random, kLeastTilt_deg, kMostTilt_deg);
}

StatedSetup random_setup(Random& random) {
  StatedSetup setup;
  setup.style = static_cast<StatedSetup::Style>(choice(random, 3));
  setup.flip = random() % 2 == 0 ? 'x' : 'y';
  setup.turns = {{any_direction(random), some_angle(random, -180, 180)},
                 {level_direction(random), tilt(random)}};
  setup.origin_mm = somewhere(random, 8);
  return setup;
}

Rotary rotary(char word, Random& random, const Vec3& point) {
  const Vec3 along = word == 'A' ? Vec3{1, 0, 0} : word == 'B' ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  return {word, along * either_sign(random), point};
}

/// A tilting axis and a round one, as common machines have them.
Machine random_machine(Holding holding, Random& random) {
  Machine m;
  m.chain = holding == Holding::table_table  ? Chain::table_table
            : holding == Holding::head_table ? Chain::head_table
                                             : Chain::head_head;
  const char tilting = random() % 2 == 0 ? 'A' : 'B';
  const Vec3 in_table = somewhere(random, 40) - Vec3{0, 0, 50};
  const Vec3 in_head = somewhere(random, 2) + Vec3{0, 0, between(random, 120, 200)};
  const Rotary tilt = rotary(tilting, random, holding == Holding::table_table ? in_table : in_head);
  const Rotary round =
      rotary('C', random, holding == Holding::head_head ? Vec3{0, 0, 220} : somewhere(random, 40));
  m.axes = {tilt, round};
  if (holding == Holding::head_head) m.axes = {round, tilt};
  m.zero_mm = somewhere(random, 60);
  m.length_mm = std::round(between(random, 60, 110));
  return m;
}

/// Meanings of places, and a control that has them.
struct Manner {
  Places places;
  const char* control;
};
Manner random_manner(Holding holding, Random& random) {
  constexpr Manner kTables[] = {{Places::joints, "haas"},  {Places::offset, "haas"},
                                {Places::tip, "fanuc"},    {Places::plane, "fanuc"},
                                {Places::tip, "linuxcnc"}, {Places::joints, "fanuc"}};
  constexpr Manner kHeads[] = {{Places::joints, "fanuc"},
                               {Places::tip, "linuxcnc"},
                               {Places::tip, "fanuc"},
                               {Places::plane, "fanuc"},
                               {Places::joints, "linuxcnc"}};
  if (holding == Holding::table_table) return kTables[choice(random, std::size(kTables))];
  return kHeads[choice(random, std::size(kHeads))];
}

/// One way to stand, or also the other one that puts the tool along the same axis: tilted the other
/// way and half a turn further. A plane's control chooses by itself.
std::vector<Angles> random_ways(std::size_t tilting, Places places, Random& random) {
  Angles first, second;
  first[tilting] = tilt(random), first[1 - tilting] = some_angle(random, -170, 170);
  second[tilting] = -first[tilting], second[1 - tilting] = first[1 - tilting] + 180;
  if (places == Places::plane || random() % 3 != 0) return {first};
  return {first, second};
}

void put_on_machine(Lying& lying, Random& random) {
  lying.machine = random_machine(lying.holding, random);
  lying.tilting = lying.holding == Holding::head_head ? 1 : 0;
  const Manner manner = random_manner(lying.holding, random);
  Posting& p = lying.posting;
  p.machine = lying.machine, p.places = manner.places, p.control = manner.control;
  p.ways = random_ways(lying.tilting, p.places, random);
  p.lying = p.machine.upright(p.ways.front()).inverse() * p.lying;
  p.lying.shift_mm = somewhere(random, 8);
  if (p.places == Places::plane) lying.tilting = 1;  // J
}

void harm_angle(Lying& lying, double by_deg, Random& random) {
  const double signed_deg = either_sign(random) * by_deg;
  const std::size_t words = lying.posting.places == Places::plane ? 3 : 2;
  if (lying.holding != Holding::still)
    lying.posting.slip = {WordSlip::Kind::added, choice(random, words), signed_deg};
  else if (lying.setup.style == StatedSetup::Style::flip)
    lying.posting.lying = lying.posting.lying * turned_about(level_direction(random), signed_deg);
  else
    lying.setup.turns.back().second += signed_deg;
}

/// An axis that the post-processor has elsewhere matters where the program says what the joints do.
void harm_place(Lying& lying, double by_mm, Random& random) {
  const Vec3 by = any_direction(random) * by_mm;
  if (lying.holding == Holding::still)
    lying.setup.origin_mm += by;
  else if (lying.posting.places == Places::joints && random() % 3 != 0)
    lying.posting.machine.axes[choice(random, 2)].point_mm += by;
  else
    lying.posting.lying.shift_mm += by;
}

void harm_sign(Lying& lying) {
  if (lying.holding != Holding::still)
    lying.posting.slip = {WordSlip::Kind::negated, lying.tilting, 0};
  else if (lying.setup.style == StatedSetup::Style::flip)
    lying.setup.flip = lying.setup.flip == 'x' ? 'y' : 'x';
  else
    lying.setup.turns.back().second *= -1;
}

}  // namespace

double between(std::mt19937& random, double a, double b) {
  return a + (b - a) * static_cast<double>(random()) / 4294967296.0;
}

const char* name(LyingKind kind) {
  constexpr const char* kNames[] = {"sunk pass",     "missing pass", "rapid through the part",
                                    "wrong angle",   "wrong place",  "turned the other way",
                                    "lost axis word"};
  return kNames[static_cast<std::size_t>(kind)];
}

bool is_local(LyingKind kind) {
  return kind == LyingKind::sunk_pass || kind == LyingKind::missing_pass ||
         kind == LyingKind::rapid_through;
}

const char* name(Holding holding) {
  constexpr const char* kNames[] = {"setups", "table-table", "head-table", "head-head"};
  return kNames[static_cast<std::size_t>(holding)];
}

Posted Lying::posted(const NcText& program) const {
  if (holding == Holding::still) return post_still(program, posting.lying, truly());
  return post(program, posting, machine, truly());
}

std::string Lying::label() const {
  constexpr const char* kStyles[] = {"flip", "rotate", "matrix"};
  const std::string how = kStyles[static_cast<std::size_t>(setup.style)];
  if (holding == Holding::still) return how;
  return std::string(name(holding)) + " by " + name(posting.places) + " (" + posting.control +
         (posting.ways.size() > 1 ? ", two ways)" : ")");
}

Lying random_lying(Holding holding, std::mt19937& random) {
  Lying lying;
  lying.holding = holding;
  lying.setup = random_setup(random);
  lying.posting.lying = turned_about({0, 0, 1}, between(random, -180, 180));
  lying.posting.lying.shift_mm = somewhere(random, 8);
  if (holding != Holding::still) put_on_machine(lying, random);
  lying.file = lying.setup.pose().inverse() * lying.posting.lying;
  return lying;
}

void harm(Lying& lying, LyingKind kind, double size, std::mt19937& random) {
  if (kind == LyingKind::wrong_angle) harm_angle(lying, size, random);
  if (kind == LyingKind::wrong_place) harm_place(lying, size, random);
  if (kind == LyingKind::wrong_sign) harm_sign(lying);
  if (kind == LyingKind::lost_word)
    lying.posting.slip = {WordSlip::Kind::lost, choice(random, 2), 0};
}

}  // namespace limitgauge::tests::defects
