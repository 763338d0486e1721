#include "tests/defects/planting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limitgauge::tests::defects {
namespace {

using model::Vec3;
using Random = std::mt19937;

std::size_t below(Random& random, std::size_t count) {
  return random() % count;  // std distributions differ between libraries
}
double share(Random& random) {
  return static_cast<double>(random()) / 4294967296.0;
}
double sign(Random& random) {
  return random() % 2 == 0 ? 1 : -1;
}

int row_count(const NcText& program) {
  return program.blocks.back().row + 1;
}
/// A row over the middle of the part: the outermost ones only roll over its rim.
int inner_row(const NcText& program, Random& random) {
  const int rows = row_count(program), margin = rows / 5;
  return margin + static_cast<int>(below(random, std::max(1, rows - 2 * margin)));
}

void sink_row(NcText& program, double by_mm, Random& random) {
  const int row = inner_row(program, random);
  for (Block& b : program.blocks)
    if (b.row == row && !b.rapid) b.to.z -= by_mm;
}

void shift_row(NcText& program, double by_mm, int across, Random& random) {
  const int row = inner_row(program, random);
  for (Block& b : program.blocks)
    if (b.row == row) b.to[across] += by_mm;
}

void drop_rows(NcText& program, int count, Random& random) {
  const int first = inner_row(program, random);
  std::erase_if(program.blocks,
                [&](const Block& b) { return b.row >= first && b.row < first + count; });
}

/// A few lines, or all the rest of the program, are read in inches.
void swap_units(NcText& program, Random& random) {
  std::vector<std::size_t> feeds;
  for (std::size_t k = 0; k < program.blocks.size(); ++k)
    if (!program.blocks[k].rapid) feeds.push_back(k);
  // The nearer to the origin, the less far the tool flies: half of the cases are of that kind.
  if (random() % 2 == 0) {
    std::stable_sort(feeds.begin(), feeds.end(), [&](std::size_t a, std::size_t b) {
      return length(program.blocks[a].to) < length(program.blocks[b].to);
    });
    feeds.resize(std::max<std::size_t>(1, feeds.size() / 20));
  }
  const std::size_t at = feeds[below(random, feeds.size())];
  program.insertions.push_back({at, "G20"});
  const std::size_t lines[] = {1, 1, 1, 2, 5, program.blocks.size()};
  program.insertions.push_back({at + lines[below(random, std::size(lines))], "G21"});
}

/// Lines lost in transfer: one as a rule, a few where a larger error is wanted; any kind of line
/// where a very large one is, also a retract.
void skip_lines(NcText& program, double size_mm, Random& random) {
  constexpr double kAnyLine_mm = 0.3;
  const auto count =
      static_cast<std::size_t>(1 + std::clamp(std::log10(size_mm / 2e-3), 0.0, 3.0) * 6);
  for (int tries = 0; tries < 200; ++tries) {
    const std::size_t first = below(random, program.blocks.size() - count - 1);
    const bool retract = size_mm > kAnyLine_mm && tries < 100;
    bool fits = true;
    for (std::size_t k = first; k <= first + count; ++k)
      fits = fits && (program.blocks[k].rapid == false || retract);
    if (retract && !program.blocks[first].rapid) continue;
    if (!fits) continue;
    for (std::size_t k = first; k < first + (retract ? 1 : count); ++k)
      program.dropped.push_back(k);
    return;
  }
  program.dropped.push_back(program.blocks.size() / 2);
}

void rotate_all(NcText& program, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Block& b : program.blocks) b.to = {c * b.to.x - s * b.to.y, s * b.to.x + c * b.to.y, b.to.z};
}

/// A link between two rows that stays too low: straight across the part, `depth_mm` under the
/// highest tip that would have cleared it.
void add_low_rapid(const Sound& sound, NcText& program, double depth_mm, Random& random) {
  const model::Box3& box = sound.surface.surface().bounding_box();
  const auto somewhere = [&] {
    return Vec3{box.low.x + share(random) * (box.high.x - box.low.x),
                box.low.y + share(random) * (box.high.y - box.low.y), 0};
  };
  const Vec3 from = somewhere();
  Vec3 to = somewhere();
  while (distance(from, to) < 2) to = somewhere();
  const Nose nose(sound.cutter, sound.allowance_mm);
  double clear = -std::numeric_limits<double>::infinity();
  constexpr int kProbes = 100;
  for (int k = 0; k <= kProbes; ++k) {
    const Vec3 p = lerp(from, to, static_cast<double>(k) / kProbes);
    const auto tip = sound.surface.drop(nose, p.x, p.y);
    if (tip) clear = std::max(clear, tip->tip_z);
  }
  std::vector<std::size_t> row_ends;
  for (std::size_t k = 1; k < program.blocks.size(); ++k)
    if (program.blocks[k].rapid && !program.blocks[k - 1].rapid) row_ends.push_back(k + 1);
  const auto at = program.blocks.begin() +
                  static_cast<std::ptrdiff_t>(row_ends[below(random, row_ends.size())]);
  const double low = clear - depth_mm, safe = sound.safe_z_mm;
  const Block link[] = {{true, {from.x, from.y, safe}, -1},
                        {true, {from.x, from.y, low}, -1},
                        {true, {to.x, to.y, low}, -1},
                        {true, {to.x, to.y, safe}, -1}};
  program.blocks.insert(at, std::begin(link), std::end(link));
}

/// The cutter in the spindle is not the one that the program was made for.
void change_radius(model::Cutter& cutter, double by_mm) {
  cutter.diameter_mm += 2 * by_mm;
  if (cutter.type == model::CutterType::ball) cutter.corner_radius_mm = cutter.diameter_mm / 2;
}

/// How much further a mishap sideways must go than upwards to do the same damage: slopes of these
/// parts are a quarter or so.
constexpr double kSideways = 4;
constexpr double kLargestShift_mm = 3;

}  // namespace

const char* name(Kind kind) {
  switch (kind) {
    case Kind::sunk_pass:
      return "sunk pass";
    case Kind::raised_pass:
      return "raised pass";
    case Kind::shifted_pass:
      return "shifted pass";
    case Kind::missing_pass:
      return "missing pass";
    case Kind::wrong_radius:
      return "wrong radius";
    case Kind::wrong_length:
      return "wrong tool length";
    case Kind::wrong_allowance:
      return "wrong allowance";
    case Kind::swapped_units:
      return "swapped units";
    case Kind::skipped_line:
      return "skipped line";
    case Kind::rotated_offset:
      return "rotated work offset";
    case Kind::rapid_through:
      return "rapid through the part";
  }
  return "";
}

Planted plant(const Sound& sound, const Mishap& mishap) {
  Random random(mishap.seed);
  NcText program = sound.program;
  Planted out{{}, {}, sound.cutter, sound.allowance_mm};
  const double size = mishap.size_mm;
  const double sideways = std::min(kSideways * size, kLargestShift_mm);
  switch (mishap.kind) {
    case Kind::sunk_pass:
      sink_row(program, size, random);
      break;
    case Kind::raised_pass:
      sink_row(program, -size, random);
      break;
    case Kind::shifted_pass:
      shift_row(program, sign(random) * sideways, sound.across, random);
      break;
    case Kind::missing_pass:
      drop_rows(program, 1 + static_cast<int>(below(random, 3)), random);
      break;
    case Kind::wrong_radius:
      // No cutter shrinks below half of itself.
      change_radius(out.cutter, std::clamp(sign(random) * 2 * kSideways * size,
                                           -sound.cutter.diameter_mm / 8, kLargestShift_mm));
      break;
    case Kind::wrong_length: {
      const double by = sign(random) * size;
      for (Block& b : program.blocks) b.to.z -= by;
      break;
    }
    case Kind::wrong_allowance:
      out.allowance_mm =
          sound.allowance_mm + (sign(random) < 0 && size < sound.allowance_mm ? -size : size);
      break;
    case Kind::swapped_units:
      swap_units(program, random);
      break;
    case Kind::skipped_line:
      skip_lines(program, size, random);
      break;
    case Kind::rotated_offset:
      rotate_all(program, sign(random) * sideways / 6);
      break;
    case Kind::rapid_through:
      add_low_rapid(sound, program, size, random);
      break;
  }
  out.text = program.text();
  out.program = std::move(program);
  return out;
}

}  // namespace limitgauge::tests::defects
