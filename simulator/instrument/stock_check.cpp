#include "simulator/instrument/stock_check.h"

#include <cmath>

#include "model/base/angle.h"
#include "simulator/grid/stock_grid.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Move;
using model::MoveKind;
using model::Vec3;

bool is_steep(const Vec3& from, const Vec3& to, double steepest_deg) {
  const double most = level_distance(from, to) * std::tan(model::radians(steepest_deg));
  return from.z - to.z > most + kDropRounding_mm;
}

// Of what fails nothing a search takes fewer looks.
constexpr std::size_t kMostSlightContactLooks = kMostContactLooks / 20;

/// Within `slack_mm`: a program whose tool leans rounds what is upright to it.
bool over_each_other(const Vec3& a, const Vec3& b, double slack_mm) {
  return level_distance(a, b) <= slack_mm;
}

/// Where the moves end whose flutes have been wherever a part above them gets to on move `i` before
/// it does. Level or down, the flutes are never again as high as such a part is, so that all they
/// sweep there they sweep first. On the way up they come to its places after it, and had not been
/// as high before.
std::size_t cut_before_shank(std::size_t i, const SweptMove& tip) {
  return tip.delta.z > 0 ? i : i + 1;
}

}  // namespace

StockCheck::StockCheck(const StockModel& before, const Pass& pass, const ToolBodies& bodies,
                       const StockLimits& limits)
    : before_(before.material()),
      pass_(pass),
      path_(*pass.path),
      bodies_(bodies),
      limits_(limits),
      map_(before.grid().column_tops()),
      lines_(straight_runs(path_)),
      idle_(path_),
      descents_(
          series_of(path_.moves.size(), [&](std::size_t i) { return descends_too_steeply(i); })),
      stairs_(stairs()) {}

void StockCheck::look_at(std::size_t move, std::vector<Finding>& findings) const {
  const SweptMove own = tip(move);
  look_at_cutter(move, own, findings);
  look_above_flutes(move, own, findings);
}

SweptMove StockCheck::tip(std::size_t i) const {
  return {move_from(path_, i), path_.moves[i].to, static_cast<std::uint32_t>(i)};
}

void StockCheck::look_at_cutter(std::size_t i, const SweptMove& tip,
                                std::vector<Finding>& findings) const {
  const Move& m = path_.moves[i];
  const bool rapid = m.kind == MoveKind::rapid, leaves = rapid && backs_out(i);
  const ToolBody& flutes = bodies_.flutes;
  if (rapid && !leaves)
    if (const auto beyond = beyond_way_back(i)) look_at_rapid(i, *beyond, findings);
  if (m.spindle_stopped && !leaves)
    look_for(FindingKind::spindle_stopped, flutes, i, tip, idle_.spindle_stopped.begin(i),
             findings);
  if (lacks_feed(m)) {
    const Contact c =
        contact_of_flutes(tip, idle_.without_feed.begin(i)).value_or(Contact{tip.start, 0});
    findings.push_back(
        finding(FindingKind::feed_missing, i, c.point, c.depth_mm, ToolPart::cutter));
  }
  if (descends_too_steeply(i)) look_at_descent(i, tip, findings);
}

// A step that is too slight alone counts with those before it: where their depths add up to more
// than the tolerance, and so does what stood before the first of the stairs.
void StockCheck::look_at_descent(std::size_t i, const SweptMove& tip,
                                 std::vector<Finding>& findings) const {
  constexpr int kMostSteps = 10;  // so many of the slightest make a tolerance
  const FindingKind kind = FindingKind::steep_descent;
  const std::size_t known = findings.size(), first = stairs_.begin(i);
  if (look_for(kind, bodies_.flutes, i, tip, descents_.begin(i), findings)) return;
  if (findings.size() == known) return;
  double sum_mm = findings.back().depth_mm;
  for (std::size_t k = i, steps = 1;
       sum_mm <= limits_.tolerance_mm && k > first && steps < kMostSteps; --k)
    if (descends_too_steeply(k - 1)) ++steps, sum_mm += slight_depth_mm(k - 1);
  if (sum_mm <= limits_.tolerance_mm) return;
  if (const auto c = contact_of_flutes(tip, first))
    findings.back() = finding(kind, i, c->point, c->depth_mm, ToolPart::cutter);
}

double StockCheck::slight_depth_mm(std::size_t i) const {
  const auto c = deepest_contact(material_at(descents_.begin(i)), bodies_.flutes.profile, tip(i),
                                 limits_.slightest_mm(), kMostSlightContactLooks)
                     .contact;
  return c ? c->depth_mm : 0;
}

void StockCheck::look_at_rapid(std::size_t i, const SweptMove& tip,
                               std::vector<Finding>& findings) const {
  const std::size_t known = findings.size();
  if (!look_for(FindingKind::rapid_through_stock, bodies_.flutes, i, tip, idle_.rapids.begin(i),
                findings))
    return look_at_rapids_gap(i, tip, findings);
  if (!goes_deeper(i, findings.back().depth_mm)) findings.resize(known);
}

// Whether a rapid that meets what stood before its series is more than a way through what the
// series has taken: it takes something itself, or is deeper than the move before it, by more than
// depths are known. The first move of a series that meets anything is one or the other.
bool StockCheck::goes_deeper(std::size_t i, double depth_mm) const {
  const std::size_t series = idle_.rapids.begin(i), line = lines_.begin(i);
  if (line <= series) return true;
  const CutterProfile& flutes = bodies_.flutes.profile;
  const auto own = deepest_contact(material_at(line), flutes, tip(i), limits_.slightest_mm(),
                                   kMostSlightContactLooks / 10);
  if (own.contact) return true;
  const auto known = contact_of_flutes(tip(i - 1), series);
  return !known || known->depth_mm + limits_.tolerance_mm < depth_mm;
}

// Straight down, a part no wider than all below it meets nothing but what it already stood in where
// the move before ended: below that the top has been wherever it comes to. Straight up again
// it goes back, and above where it came from nothing stands as high as it is.
bool StockCheck::follows_flutes(const ToolBody& body, std::size_t i, const SweptMove& tip) const {
  if (i == 0 || !tip.vertical() || !bodies_.trails(body)) return false;
  if (tip.delta.z <= 0) return true;
  const Vec3 &from = move_from(path_, i - 1), &down = path_.moves[i - 1].to;
  const bool goes_back =
      path_.moves[i].to.z <= from.z || from.z + bodies_.flutes.profile.length() >= map_.highest();
  return goes_back && over_each_other(from, down, 0) && from.z >= down.z;
}

bool StockCheck::look_for(FindingKind kind, const ToolBody& body, std::size_t i,
                          const SweptMove& tip, std::size_t end,
                          std::vector<Finding>& findings) const {
  const SweptMove own = body.of_tip(tip);
  if (map_.clears(body.profile, own)) return false;
  const MaterialAtMove material = material_at(end);
  const ContactAnswer sure = deepest_contact(material, body.profile, own, limits_.tolerance_mm);
  if (sure.contact || !sure.proven) {
    const Contact c = sure.contact.value_or(Contact{tip.start, 0});
    findings.push_back(finding(kind, i, c.point, c.depth_mm, body.part));
    return true;
  }
  // The first look is only sure of what is half as deep again as the tolerance.
  const auto c =
      deepest_contact(material, body.profile, own, limits_.slightest_mm(), kMostSlightContactLooks)
          .contact;
  if (!c) return false;
  const bool counts = c->depth_mm > limits_.tolerance_mm;
  findings.push_back(
      finding(counts ? kind : FindingKind::slight_contact, i, c->point, c->depth_mm, body.part));
  return counts;
}

void StockCheck::look_above_flutes(std::size_t i, const SweptMove& tip,
                                   std::vector<Finding>& findings) const {
  // All that is above the flutes' top at once.
  const double lowest = std::min(tip.start.z, tip.start.z + tip.delta.z);
  if (lowest + bodies_.flutes.profile.length() - limits_.near_miss_mm >= map_.highest()) return;
  look_over_flutes(i, tip, findings);
  for (const ToolBody& body : bodies_.above)
    if (bodies_.is_wide(body) && !follows_flutes(body, i, tip))
      look_at_wide_part(body, i, tip, findings);
}

void StockCheck::look_over_flutes(std::size_t i, const SweptMove& tip,
                                  std::vector<Finding>& findings) const {
  for (const ToolBody& body : bodies_.over_flutes)
    if (!follows_flutes(body, i, tip))
      look_for(FindingKind::below_flutes, body, i, tip, cut_before_shank(i, tip), findings);
}

void StockCheck::look_at_wide_part(const ToolBody& body, std::size_t i, const SweptMove& tip,
                                   std::vector<Finding>& findings) const {
  const std::size_t end = cut_before_shank(i, tip);
  const bool wider = body.profile.largest_radius() > bodies_.top_radius_mm + limits_.tolerance_mm;
  if (wider && limits_.near_miss_mm > 0) {
    const SweptMove own = body.of_tip(tip);
    if (map_.clears(body.profile, own, limits_.near_miss_mm)) return;
    const auto gap = least_gap(material_at(end), body.profile, own, limits_.near_miss_mm,
                               limits_.tolerance_mm, {});
    if (!gap) return;
    findings.push_back(
        finding(FindingKind::near_miss, i, gap->point, -gap->distance_mm, body.part));
  }
  look_for(
      body.part == ToolPart::shank ? FindingKind::shank_in_stock : FindingKind::holder_in_stock,
      body, i, tip, end, findings);
}

void StockCheck::look_at_rapids_gap(std::size_t i, const SweptMove& tip,
                                    std::vector<Finding>& findings) const {
  const CutterProfile& flutes = bodies_.flutes.profile;
  if (!(limits_.near_miss_mm > 0) || map_.clears(flutes, tip, limits_.near_miss_mm) ||
      keeps_to_its_hole(i))
    return;
  const std::vector<SweptMove> feeds = feeds_beside(i);
  const auto gap = least_gap(material_at(lines_.begin(i)), flutes, tip, limits_.near_miss_mm,
                             limits_.tolerance_mm, {&flutes, feeds});
  if (gap && gap->distance_mm > limits_.tolerance_mm)
    findings.push_back(
        finding(FindingKind::near_miss, i, gap->point, -gap->distance_mm, ToolPart::cutter));
}

std::optional<Contact> StockCheck::contact(const ToolBody& body, const SweptMove& tip,
                                           std::size_t end) const {
  const SweptMove own = body.of_tip(tip);
  if (map_.clears(body.profile, own)) return std::nullopt;
  return deepest_contact(material_at(end), body.profile, own, limits_.tolerance_mm).contact;
}

std::optional<Contact> StockCheck::contact_of_flutes(const SweptMove& tip, std::size_t end) const {
  return contact(bodies_.flutes, tip, end);
}

bool StockCheck::descends_too_steeply(std::size_t i) const {
  const double steepest = pass_.cutter.steepest_descent_deg;
  if (steepest >= 90 || path_.moves[i].kind != MoveKind::feed) return false;
  // Of the whole straight line: rounding would hide the slope of its pieces.
  return is_steep(move_from(path_, lines_.begin(i)), path_.moves[lines_.end(i) - 1].to, steepest);
}

// Descents that are no more than the cutter's width of level way apart, as long as the way from
// where the first began is too steep as well.
MoveRuns StockCheck::stairs() const {
  const double width_mm = 2 * bodies_.flutes.profile.largest_radius();
  bool within = false;
  Vec3 from;
  double level_mm = 0;  // since the last of them
  return MoveRuns(path_.moves.size(), [&](std::size_t i) {
    const Vec3 &start = move_from(path_, i), &to = path_.moves[i].to;
    const bool steep = descends_too_steeply(i);
    level_mm = steep ? 0 : level_mm + level_distance(start, to);
    within = within && path_.moves[i].kind == MoveKind::feed && level_mm <= width_mm &&
             is_steep(from, to, pass_.cutter.steepest_descent_deg);
    if (within || !steep) return false;
    within = true, from = start;
    return true;
  });
}

// Straight up from where the move before the line ended: the flutes stood there, and all that they
// sweep anew is above their top, but for as much as they drift aside, which is no contact.
bool StockCheck::backs_out(std::size_t i) const {
  const std::size_t begin = lines_.begin(i);
  if (begin == 0) return false;
  const Vec3 &from = move_from(path_, begin), &to = path_.moves[i].to;
  const double slack_mm = limits_.slightest_mm();
  return over_each_other(from, move_from(path_, i), slack_mm) &&
         over_each_other(from, to, slack_mm) && to.z >= move_from(path_, i).z &&
         bodies_.widest_at_top() && from.z + bodies_.flutes.profile.length() >= map_.highest();
}

// What a rapid sweeps that the straight line of feed moves before it has not: nothing of it where
// it goes back along that line, and from its beginning on where it goes on. As much as it goes
// aside is no contact.
std::optional<SweptMove> StockCheck::beyond_way_back(std::size_t i) const {
  const SweptMove own = tip(i);
  const std::size_t begin = lines_.begin(i);
  if (begin != i || begin == 0 || path_.moves[begin - 1].kind != MoveKind::feed) return own;
  const SweptMove feed = run_of(begin - 1);
  const double way_mm = length(feed.delta);
  if (!(way_mm > 0)) return own;
  const Vec3 back = feed.delta * (-1 / way_mm);
  const double along_mm = dot(own.delta, back);
  const auto aside_mm = [&](const Vec3& way) { return length(way - back * dot(way, back)); };
  if (along_mm < 0 || aside_mm(own.delta) > limits_.slightest_mm()) return own;
  // A line in pieces may bend.
  for (std::size_t k = lines_.begin(begin - 1); k < begin; ++k)
    if (aside_mm(move_from(path_, k) - own.start) > limits_.slightest_mm()) return own;
  if (along_mm <= way_mm) return std::nullopt;
  const Vec3 from = own.start + own.delta * (way_mm / along_mm);
  return SweptMove(from, path_.moves[i].to, own.index);
}

// Up from where a feed move ended or down to where one begins, with flutes that are widest at their
// top and end above all material: no place of it is nearer than the feed move comes.
bool StockCheck::keeps_to_its_hole(std::size_t i) const {
  const std::size_t begin = lines_.begin(i), end = lines_.end(i);
  const Vec3 &from = move_from(path_, begin), &to = path_.moves[end - 1].to;
  if (!over_each_other(from, to, limits_.slightest_mm()) || !bodies_.widest_at_top()) return false;
  const bool up = to.z >= from.z;
  const bool beside_feed = up ? begin > 0 && path_.moves[begin - 1].kind == MoveKind::feed
                              : end < path_.moves.size() && path_.moves[end].kind == MoveKind::feed;
  return beside_feed && std::min(from.z, to.z) + bodies_.flutes.profile.length() >= map_.highest();
}

std::vector<SweptMove> StockCheck::feeds_beside(std::size_t i) const {
  const std::size_t begin = lines_.begin(i), end = lines_.end(i);
  std::vector<SweptMove> feeds;
  if (begin > 0 && path_.moves[begin - 1].kind == MoveKind::feed)
    feeds.push_back(run_of(begin - 1));
  if (end < path_.moves.size() && path_.moves[end].kind == MoveKind::feed)
    feeds.push_back(run_of(end));
  return feeds;
}

SweptMove StockCheck::run_of(std::size_t i) const {
  const std::size_t begin = lines_.begin(i);
  return {move_from(path_, begin), path_.moves[lines_.end(i) - 1].to,
          static_cast<std::uint32_t>(begin)};
}

MaterialAtMove StockCheck::material_at(std::size_t end) const {
  std::call_once(indexed_, [&] { sweep_ = std::make_unique<const SweepIndex>(pass_); });
  return {&before_, sweep_.get(), static_cast<std::uint32_t>(end)};
}

Finding StockCheck::finding(FindingKind kind, std::size_t i, const Vec3& point, double depth,
                            ToolPart part) const {
  return {kind, i, path_.moves[i].line, point, depth, name(part), "stock"};
}

}  // namespace limitgauge::simulator
