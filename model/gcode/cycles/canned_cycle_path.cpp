#include "model/gcode/cycles/canned_cycle_path.h"

namespace limitgauge::model::gcode {
namespace {

/// Writes the motions of a block.
class Writer {
 public:
  explicit Writer(const CycleGeometry& geometry)
      : geometry_(geometry), axes_(axes_of(geometry.plane)) {}

  std::vector<CycleMove> run() {
    if (geometry_.lifts_first) lift();
    for (std::size_t hole = 0; hole < geometry_.holes_mm.size(); ++hole) {
      at_ = geometry_.holes_mm[hole];
      approach(hole == 0);
      machine();
    }
    return std::move(moves_);
  }

 private:
  enum class Spindle { turning, stopped };

  void add(MotionKind kind, Vec2 at, double level_mm, Spindle spindle = Spindle::turning) {
    const auto [first, second, along] = axes_;
    CycleMove move{kind, {}, spindle == Spindle::stopped, geometry_.stated};
    move.to_mm[first] = at[0];
    move.to_mm[second] = at[1];
    move.to_mm[along] = level_mm;
    moves_.push_back(move);
  }
  void rapid(double level_mm, Spindle spindle = Spindle::turning) {
    add(MotionKind::rapid, at_, level_mm, spindle);
  }
  void feed(double level_mm) { add(MotionKind::feed, at_, level_mm); }

  /// A rapid to a level that is not the program's but where the run of cycles began.
  void rapid_to_found_level(double level_mm, Spindle spindle = Spindle::turning) {
    rapid(level_mm, spindle);
    mark_found_level(level_mm);
  }
  void mark_found_level(double level_mm) {
    if (level_mm != geometry_.r_mm) moves_.back().stated[axes_[2]] = false;
  }

  void lift() {
    add(MotionKind::rapid, {geometry_.start_mm[axes_[0]], geometry_.start_mm[axes_[1]]},
        geometry_.r_mm);
    moves_.back().stated[axes_[0]] = moves_.back().stated[axes_[1]] = false;
  }

  /// From the second hole on the tool is taken to stand at the return level. So it is for the first
  /// one unless it stands above R, which makes a slant of a rapid after G99 gave way to G98.
  void approach(bool first_hole) {
    if (geometry_.goes_across_as_it_stands) {
      const double level_mm = first_hole ? geometry_.start_mm[axes_[2]] : geometry_.return_mm;
      rapid_to_found_level(level_mm);
      if (level_mm != geometry_.r_mm) rapid(geometry_.r_mm);
      return;
    }
    const double level_mm = geometry_.lifts_first ? geometry_.r_mm : geometry_.start_mm[axes_[2]];
    const bool from_found_level = first_hole && level_mm > geometry_.r_mm;
    const double across_mm = from_found_level ? level_mm : geometry_.return_mm;
    rapid_to_found_level(across_mm);
    if (across_mm > geometry_.r_mm) rapid(geometry_.r_mm);
  }

  void machine() {
    switch (geometry_.cycle) {
      case Cycle::back_boring:
        return back_bore();
      case Cycle::chip_breaking:
      case Cycle::pecking:
        peck();
        break;
      default:
        break;
    }
    feed(geometry_.bottom_mm);
    withdraw();
  }

  void peck() {
    for (const double level_mm : geometry_.pecks_mm) {
      feed(level_mm);
      if (geometry_.cycle == Cycle::pecking) rapid(geometry_.r_mm);
      rapid(level_mm + kPeckClearanceMm);
    }
  }

  void withdraw() {
    switch (geometry_.cycle) {
      case Cycle::boring_by_hand:
        return;
      case Cycle::left_tapping:
      case Cycle::tapping:
      case Cycle::boring_dwell:
        if (geometry_.feeds_to_r) {
          feed(geometry_.r_mm);
          break;
        }
        feed(geometry_.return_mm);
        return mark_found_level(geometry_.return_mm);
      case Cycle::boring:
        feed(geometry_.r_mm);
        break;
      default:
        break;
    }
    const bool stops = geometry_.cycle == Cycle::boring_stop;
    rapid_to_found_level(geometry_.return_mm, stops ? Spindle::stopped : Spindle::turning);
  }

  /// The bar goes down beside the axis with its edge turned away, bores upwards on the axis, and
  /// leaves as it came.
  void back_bore() {
    const Vec2 aside = {at_[0] + geometry_.aside_mm[0], at_[1] + geometry_.aside_mm[1]};
    add(MotionKind::rapid, aside, geometry_.r_mm);
    add(MotionKind::rapid, aside, geometry_.bottom_mm, Spindle::stopped);
    rapid(geometry_.bottom_mm, Spindle::stopped);
    feed(geometry_.middle_mm);
    feed(geometry_.bottom_mm);
    add(MotionKind::rapid, aside, geometry_.bottom_mm, Spindle::stopped);
    add(MotionKind::rapid, aside, geometry_.return_mm, Spindle::stopped);
    mark_found_level(geometry_.return_mm);
    rapid_to_found_level(geometry_.return_mm, Spindle::stopped);
  }

  const CycleGeometry& geometry_;
  Vec2 at_{};
  std::array<int, 3> axes_;
  std::vector<CycleMove> moves_;
};

}  // namespace

std::vector<CycleMove> cycle_moves(const CycleGeometry& geometry) {
  return Writer(geometry).run();
}

std::size_t most_moves_per_hole(const CycleGeometry& geometry) {
  constexpr std::size_t kApproachAndBackBore = 10;
  return kApproachAndBackBore + 3 * geometry.pecks_mm.size();
}

}  // namespace limitgauge::model::gcode
