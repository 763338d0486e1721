#include "verifier/robust/tolerance_box.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "verifier/robust/certifiable.h"

namespace limitgauge::verifier {
namespace {

using model::Interval;
using model::Vec3;
using Of = Tolerance::Of;

constexpr const char* kAxes[] = {".x", ".y", ".z"};

const char* word_of(Of of) {
  switch (of) {
    case Of::zero:
      return "zero";
    case Of::radius:
      return "radius";
    case Of::length:
      return "length";
    case Of::corner_radius:
      return "corner_radius";
    case Of::flat:
      return "flat";
    case Of::runout:
      return "runout";
    case Of::positioning:
      return "positioning";
    case Of::path:
      break;
  }
  return "path";
}

bool is_shift(const Tolerance& t) {
  return t.of == Of::zero || t.of == Of::positioning;
}

/// Whether more of it makes the cutter reach further: down, or to the side.
bool reaches_further(const Tolerance& t, bool flat_is_stated) {
  if (is_shift(t)) return false;
  return t.of != Of::corner_radius || flat_is_stated;
}

double top_radius_mm(const model::Cutter& cutter) {
  return CutterProfile(cutter).top_radius_mm();
}

/// With parts narrower than `top_mm` narrower by `aside_mm` about their axis, longer by as much as
/// the flutes are shorter: twice `up_mm`. None where nothing is left of one.
std::optional<model::Cutter> narrowed(model::Cutter cutter, double top_mm, double aside_mm,
                                      double up_mm) {
  bool is_necked = false;
  for (auto* list : {&cutter.shank, &cutter.holder})
    for (model::CylinderPart& part : *list) {
      if (part.diameter_mm / 2 >= top_mm) continue;
      is_necked = true;
      part.diameter_mm -= 2 * aside_mm;
      part.length_mm += 2 * up_mm;
      if (!(part.diameter_mm > 0)) return std::nullopt;
    }
  if (!is_necked) return cutter;
  cutter.flute_length_mm -= 2 * up_mm;
  const CutterProfile profile(cutter);
  if (!(profile.top_mm > profile.core_mm)) return std::nullopt;
  return cutter;
}

}  // namespace

std::string Tolerance::name() const {
  const std::string word = word_of(of);
  if (!tool.empty()) return "tool." + tool + "." + word;
  return of == Of::runout ? word : word + kAxes[axis];
}

ToleranceBox::ToleranceBox(const model::Tolerances& tolerances, std::span<const Pass> passes)
    : passes_(passes), path_mm_(tolerances.path_mm) {
  const auto add = [&](Of of, int axis, const Interval& range) {
    if (!model::is_none(range)) tolerances_.push_back({of, axis, {}, range});
  };
  for (int axis = 0; axis < 3; ++axis) add(Of::zero, axis, tolerances.zero_mm[axis]);
  for (const Pass& pass : passes) add_tool(tolerances, pass);
  add(Of::runout, 0, model::about_zero(tolerances.runout_mm));
  for (int axis = 0; axis < 3; ++axis)
    add(Of::positioning, axis, model::about_zero(tolerances.positioning_mm[axis]));
  for (int axis = 0; axis < 3; ++axis) add(Of::path, axis, model::about_zero(tolerances.path_mm));
  for (const Pass& pass : passes) require_certifiable(tolerances, pass.cutter);
}

void ToleranceBox::add_tool(const model::Tolerances& tolerances, const Pass& pass) {
  const auto stated = tolerances.tools.find(pass.cutter.id);
  const bool known = std::any_of(tolerances_.begin(), tolerances_.end(),
                                 [&](const Tolerance& t) { return t.tool == pass.cutter.id; });
  if (stated == tolerances.tools.end() || known) return;
  const model::ToolTolerance& tool = stated->second;
  const auto add = [&](Of of, const Interval& range) {
    if (!model::is_none(range)) tolerances_.push_back({of, 0, stated->first, range});
  };
  add(Of::radius, tool.radius_mm);
  add(Of::length, tool.length_mm);
  add(Of::corner_radius, tool.corner_radius_mm);
  if (tool.flat_mm) tolerances_.push_back({Of::flat, 0, stated->first, *tool.flat_mm});
}

Interval ToleranceBox::range_of(Of of, int axis, const std::string& tool) const {
  for (const Tolerance& t : tolerances_)
    if (t.of == of && t.axis == axis && t.tool == tool) return t.range_mm;
  return {};
}

double ToleranceBox::sum_of(const ToleranceValues& values, Of of, int axis) const {
  double sum = 0;
  for (std::size_t k = 0; k < tolerances_.size(); ++k)
    if (tolerances_[k].of == of && tolerances_[k].axis == axis) sum += values[k];
  return sum;
}

model::CutterOffset ToleranceBox::offset_of(const ToleranceValues& values,
                                            const std::string& tool) const {
  model::CutterOffset out;
  for (std::size_t k = 0; k < tolerances_.size(); ++k) {
    const Tolerance& t = tolerances_[k];
    if (t.of == Of::runout) out.radius_mm += values[k];
    if (t.tool != tool || tool.empty()) continue;
    if (t.of == Of::radius) out.radius_mm += values[k];
    if (t.of == Of::length) out.length_mm += values[k];
    if (t.of == Of::corner_radius) out.corner_radius_mm += values[k];
    if (t.of == Of::flat) out.flat_mm = values[k];
  }
  return out;
}

ToleranceValues ToleranceBox::extreme(Side side) const {
  const bool furthest = side != Side::uncut;
  ToleranceValues out;
  for (const Tolerance& t : tolerances_) {
    const Interval& r = t.range_mm;
    const bool flat_is_stated =
        std::any_of(tolerances_.begin(), tolerances_.end(), [&](const Tolerance& other) {
          return other.of == Of::flat && other.tool == t.tool && !t.tool.empty();
        });
    if (t.of == Of::path)
      out.push_back(0);
    else if (is_shift(t) && t.axis < 2)
      out.push_back((r.low + r.high) / 2);
    else
      out.push_back(reaches_further(t, flat_is_stated) == furthest ? r.high : r.low);
  }
  return out;
}

Vec3 ToleranceBox::shift_at(const ToleranceValues& values) const {
  Vec3 shift;
  for (int axis = 0; axis < 3; ++axis)
    for (const Of of : {Of::zero, Of::positioning, Of::path})
      shift[axis] += sum_of(values, of, axis);
  return shift;
}

std::vector<Pass> ToleranceBox::passes_at(const ToleranceValues& values) const {
  std::vector<Pass> out;
  for (const Pass& pass : passes_) {
    const model::CutterOffset by = offset_of(values, pass.cutter.id);
    const Vec3 shift = shift_at(values) - Vec3{0, 0, by.length_mm};
    model::Pose shifted;
    shifted.shift_mm = shift;
    out.push_back({model::varied(pass.cutter, by),
                   std::make_shared<const model::Toolpath>(turned(*pass.path, shifted))});
  }
  return out;
}

std::vector<Pass> ToleranceBox::cutters_at(const ToleranceValues& values) const {
  std::vector<Pass> out(passes_.begin(), passes_.end());
  for (Pass& pass : out)
    pass.cutter = model::varied(pass.cutter, offset_of(values, pass.cutter.id));
  return out;
}

bool ToleranceBox::changes_reach() const {
  return std::any_of(tolerances_.begin(), tolerances_.end(), [](const Tolerance& t) {
    return t.of == Of::radius || t.of == Of::corner_radius || t.of == Of::flat ||
           t.of == Of::runout;
  });
}

/// Least radius of the core's edge and least corner radius, whatever they have to do with each
/// other, and a neck that finds room whichever way the cutter is moved aside for that.
std::optional<model::Cutter> ToleranceBox::smallest(const model::Cutter& cutter) const {
  const auto of_tool = [&](Of of) {
    return cutter.id.empty() ? Interval{} : range_of(of, 0, cutter.id);
  };
  const Interval radius = of_tool(Of::radius), corner = of_tool(Of::corner_radius),
                 flat = of_tool(Of::flat), runout = range_of(Of::runout, 0);
  const bool flat_is_stated = flat.width() > 0 || flat.low != 0;
  const double core_low = radius.low + runout.low + flat.low - (flat_is_stated ? 0 : corner.high);
  try {
    const model::Cutter least =
        model::varied(cutter, {core_low + corner.low, 0, corner.low, std::nullopt});
    const double core_range =
        radius.width() + runout.width() + flat.width() + (flat_is_stated ? 0 : corner.width());
    const bool is_round = CutterProfile(cutter).flat_mm <= 0;
    return narrowed(least, top_radius_mm(cutter), core_range + corner.width(),
                    is_round ? core_range : corner.width());
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

std::optional<std::vector<Pass>> ToleranceBox::smallest_cutters() const {
  std::vector<Pass> out(passes_.begin(), passes_.end());
  for (Pass& pass : out) {
    const auto least = smallest(pass.cutter);
    if (!least) return std::nullopt;
    pass.cutter = *least;
  }
  return out;
}

double ToleranceBox::height_range_mm(const Pass& pass) const {
  double range = 0;
  if (!pass.cutter.id.empty()) range += range_of(Of::length, 0, pass.cutter.id).width();
  return range + range_of(Of::zero, 2).width() + range_of(Of::positioning, 2).width();
}

std::vector<AssemblySweep> ToleranceBox::parts(double highest_mm) const {
  double range = 0;
  for (const Pass& pass : passes_) range = std::max(range, height_range_mm(pass));
  return assembly_sweeps(passes_, highest_mm + range);
}

std::vector<Sweep> ToleranceBox::sweeps(const ToleranceValues& values, Side side, double highest_mm,
                                        double grown) const {
  std::vector<Sweep> out;
  for (const Pass& pass : passes_) {
    const model::CutterOffset by = offset_of(values, pass.cutter.id);
    Sweep sweep{CutterProfile(model::varied(pass.cutter, by)), -by.length_mm, pass.path};
    sweep.profile.top_mm += grown * height_range_mm(pass);
    out.push_back(std::move(sweep));
  }
  if (side == Side::uncut) return out;
  for (const AssemblySweep& part : parts(highest_mm)) {
    const Pass& pass = passes_[part.stage];
    out.push_back(part.sweep);
    out.back().lift_mm -= offset_of(values, pass.cutter.id).length_mm;
    out.back().profile.top_mm += grown * height_range_mm(pass);
  }
  return out;
}

std::vector<Sweep> ToleranceBox::sweeps_at(const ToleranceValues& values, Side side,
                                           double highest_mm) const {
  return sweeps(values, side, highest_mm, 0);
}

std::vector<Sweep> ToleranceBox::hull_sweeps(Side side, double highest_mm) const {
  return sweeps(extreme(side), side, highest_mm, side == Side::uncut ? -1 : 1);
}

Vec3 ToleranceBox::sway(Side side) const {
  Vec3 half;
  for (int axis = 0; axis < 2; ++axis) {
    half[axis] = range_of(Of::zero, axis).width() / 2;
    if (side != Side::uncut) half[axis] += range_of(Of::positioning, axis).high;
  }
  return half;
}

double ToleranceBox::error_mm(Side side) const {
  if (side != Side::uncut) return path_mm_;
  return path_mm_ +
         std::hypot(range_of(Of::positioning, 0).high, range_of(Of::positioning, 1).high);
}

double ToleranceBox::gap_mm(Side side) const {
  // Passes that part at a cusp with flanks of up to 25° add a tenth of what they part by.
  constexpr double kParting = 1.1;
  return side == Side::uncut ? kParting * error_mm(side) - path_mm_ : 0;
}

ToleranceValues ToleranceBox::shifted(Side side, double x, double y) const {
  ToleranceValues out = extreme(side);
  for (std::size_t k = 0; k < tolerances_.size(); ++k)
    if (const Tolerance& t = tolerances_[k]; is_shift(t) && t.axis < 2)
      out[k] += (t.axis == 0 ? x : y) * t.range_mm.width() / 2;
  return out;
}

ToleranceValues ToleranceBox::off_path(ToleranceValues values, const Vec3& by) const {
  for (std::size_t k = 0; k < tolerances_.size(); ++k)
    if (tolerances_[k].of == Of::path) values[k] = by[tolerances_[k].axis];
  return values;
}

ToleratedSpaces::ToleratedSpaces(const ToleranceBox& box, const RemovedSpace& raw, Side side,
                                 double highest_mm)
    : whole((side == Side::uncut ? raw.with_stock_grown() : raw)
                .with(box.hull_sweeps(side, highest_mm))
                .shifted(box.shift_at(box.extreme(side)))
                .swaying(box.sway(side), box.error_mm(side))),
      drawn(raw.with(box.sweeps_at(box.extreme(side), side, highest_mm))),
      draws{drawn,
            box.shift_at(box.extreme(side)),
            box.shift_half(),
            box.path_mm(),
            box.gap_mm(side),
            side == Side::uncut ? raw.stock_blunt_mm() : 0} {}

}  // namespace limitgauge::verifier
