#pragma once

#include "engine/strategy/linking/approach.h"

namespace limitgauge::engine::strategy {

enum class LinkKind { straight, over, retract };

/// How the cutter gets from the end of one pass to the start of the next: straight on, raised by as
/// much as the surface between asks for; across at one height; or at the clear height.
struct Link {
  LinkKind kind = LinkKind::retract;
  double seconds = 0;  ///< without the ways in and out
  double raised_mm = 0;
  double over_z_mm = 0;
};

/// Weighs and proves links.
class LinkChooser {
 public:
  LinkChooser(const ApproachRule& rule, double clear_z_mm) : rule_(rule), clear_z_mm_(clear_z_mm) {}

  /// The least time that any link from `from` to `to` takes; asks nothing of the surface.
  double least_seconds(const model::Vec3& from, const model::Vec3& to) const;
  /// The quickest proven link. `stands_to_mm`: as of the pass that begins at `to`.
  Link choose(const model::Vec3& from, const model::Vec3& to,
              std::optional<double> stands_to_mm) const;
  /// The quicker one of those that come down from above.
  Link choose_from_above(const model::Vec3& from, const model::Vec3& to,
                         std::optional<double> stands_to_mm) const;

  /// Whence a cutter that comes down to `to` in the air goes on at the plunge feed.
  double plunge_from_mm(const model::Vec3& to, std::optional<double> stands_to_mm) const;
  /// Down to where a rapid may go: above the stock.
  double rapid_to_mm(double tip_z_mm) const;

 private:
  double link_seconds(double length_mm) const;
  double down_seconds(double from_z_mm, const model::Vec3& to,
                      std::optional<double> stands_to_mm) const;
  double retract_seconds(const model::Vec3& from, const model::Vec3& to,
                         std::optional<double> stands_to_mm) const;
  /// By how much a straight link must be raised; nothing where that is too much.
  std::optional<double> raise(const model::Vec3& from, const model::Vec3& to) const;
  std::optional<double> height_over(const model::Vec3& from, const model::Vec3& to,
                                    std::optional<double> stands_to_mm) const;

  const ApproachRule& rule_;
  double clear_z_mm_;
};

}  // namespace limitgauge::engine::strategy
