#include "simulator/collision.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "engine/model/chunks.h"
#include "simulator/clearance_map.h"
#include "simulator/contact_search.h"
#include "simulator/material.h"
#include "simulator/stock_grid.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

constexpr std::size_t kChunk = 64;

enum Part { kCutter, kShank, kHolder, kParts };
constexpr const char* kPartNames[kParts] = {"cutter", "shank", "holder"};

// A convex body of the tool assembly, `base_mm` above the tip.
struct Body {
  Part part;
  CutterProfile profile;
  double base_mm;
};

std::vector<Body> bodies_above_flutes(const model::Cutter& cutter) {
  std::vector<Body> bodies;
  double base = cutter.flute_length_mm;
  const auto stack = [&](const std::vector<model::CylinderPart>& parts, Part part) {
    for (const model::CylinderPart& c : parts) {
      bodies.push_back({part, CutterProfile(c.diameter_mm / 2, c.length_mm), base});
      base += c.length_mm;
    }
  };
  stack(cutter.shank, kShank);
  stack(cutter.holder, kHolder);
  return bodies;
}

class CollisionFinder {
 public:
  CollisionFinder(const StockModel& before, const Pass& pass, double tolerance)
      : before_(before.material()),
        path_(*pass.path),
        sweep_(pass),
        map_(before.column_tops()),
        cutter_{kCutter, CutterProfile(pass.cutter), 0},
        above_(bodies_above_flutes(pass.cutter)),
        tolerance_(tolerance) {}

  using Found = std::array<std::optional<Contact>, kParts>;

  Found look_at(std::size_t i) const {
    Found found;
    const auto index = static_cast<std::uint32_t>(i);
    // What the move's own flutes sweep is gone before its shank gets there.
    for (const Body& body : above_) deepen(found, contact(body, i, index + 1));
    if (path_.moves[i].kind == model::MoveKind::rapid && !backs_out(i))
      deepen(found, contact(cutter_, i, index));
    return found;
  }

 private:
  struct PartContact {
    Part part;
    std::optional<Contact> contact;
  };

  PartContact contact(const Body& body, std::size_t i, std::uint32_t end) const {
    const Vec3 up{0, 0, body.base_mm};
    const SweptMove move(move_from(path_, i) + up, path_.moves[i].to + up, end);
    if (map_.clears(body.profile, move)) return {body.part, std::nullopt};
    return {body.part, deepest_contact({&before_, &sweep_, end}, body.profile, move, tolerance_)};
  }

  static void deepen(Found& found, const PartContact& c) {
    std::optional<Contact>& known = found[c.part];
    if (c.contact && (!known || c.contact->depth_mm > known->depth_mm)) known = c.contact;
  }

  // Straight up from where the move before ended: the flutes stood there, and all that they sweep
  // anew is above their top.
  bool backs_out(std::size_t i) const {
    if (i == 0) return false;
    const Vec3 from = move_from(path_, i), way = path_.moves[i].to - from;
    return way.x == 0 && way.y == 0 && way.z >= 0 &&
           from.z + cutter_.profile.length() >= map_.highest();
  }

  const Material& before_;
  const model::Toolpath& path_;
  SweepIndex sweep_;
  ClearanceMap map_;
  Body cutter_;
  std::vector<Body> above_;
  double tolerance_;
};

Collision as_collision(const Pass& pass, std::size_t move, Part part, const Contact& contact) {
  return {move, pass.path->moves[move].line, contact.point, contact.depth_mm, kPartNames[part]};
}

}  // namespace

CollisionReport find_collisions(const StockModel& before, const Pass& pass, double tolerance_mm,
                                const model::RunControl& control) {
  if (!(tolerance_mm > 0) || !std::isfinite(tolerance_mm))
    throw std::invalid_argument("the collision tolerance must be a positive number");
  if (!pass.path) throw std::invalid_argument("a pass without a path");
  const CollisionFinder finder(before, pass, tolerance_mm);
  const std::size_t moves = pass.path->moves.size(), chunks = model::chunk_count(moves, kChunk);
  std::vector<CollisionFinder::Found> found(moves);
  std::atomic<std::size_t> done = 0;
  model::parallel_chunks(moves, kChunk, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) found[i] = finder.look_at(i);
    control.report(static_cast<double>(++done) / static_cast<double>(chunks));
  });
  CollisionReport report;
  for (std::size_t i = 0; i < moves; ++i)
    for (const Part part : {kCutter, kShank, kHolder})
      if (found[i][part])
        (part == kCutter ? report.rapid : report.holder)
            .push_back(as_collision(pass, i, part, *found[i][part]));
  return report;
}

}  // namespace limitgauge::simulator
