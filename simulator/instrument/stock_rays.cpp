#include "simulator/instrument/stock_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "simulator/grid/stock_grid.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

/// Steps on the exact material before a ray is given up that follows a surface.
constexpr int kMostSteps = 4000;
/// Steps that are all short mean a surface alongside: then the moves about are looked at one by
/// one.
constexpr int kShortSteps = 12;
constexpr double kShort_mm = 0.01;
/// How far the moves about are gathered for.
constexpr double kAhead_mm = 0.1;

/// A distance at one place of the ray, and how it changes along it.
struct Along {
  double value = 0, slope = 0;
};

class Walk {
 public:
  Walk(const StockModel& stock, const Vec3& from, const Vec3& along, double limit_mm, bool in_raw)
      : material_(stock.material()),
        grid_(stock.grid()),
        from_(from),
        along_(along),
        limit_mm_(limit_mm),
        in_raw_(in_raw) {}

  StockRays::Run go();

 private:
  Vec3 at(double t) const { return from_ + along_ * t; }
  StockRays::Run open_end() const { return {*inside_, std::min(t_, limit_mm_), false, 0}; }
  bool lead_by_grid();
  MaterialSample sample(const Vec3& p) const;
  double proven_step(const MaterialSample& s);
  double way_out(SurfaceMaker body) const;
  double first_entry() const;
  double clear_ahead(const SweepIndex& pass, std::uint32_t slot, const Vec3& p,
                     const SweptSample& d, double end_mm) const;
  double raw_left() const;

  const Material& material_;
  const StockGrid& grid_;
  Vec3 from_, along_;
  double limit_mm_;
  bool in_raw_;                 ///< all of the way is: only what was cut counts
  double t_ = 0;                ///< all before it is proven
  std::optional<bool> inside_;  ///< in the material
  SurfaceMaker hint_;
  int short_steps_ = 0;
};

/// Goes as far as the level set proves; true at the limit.
bool Walk::lead_by_grid() {
  const GridRun run = grid_.proven_run(at(t_), along_, limit_mm_ - t_);
  if (run.length_mm <= 0) return false;
  // After a surface was crossed within the last step, the exact material has to find it.
  if (inside_ && *inside_ != run.material) return false;
  inside_ = run.material;
  t_ += run.length_mm;
  return t_ >= limit_mm_;
}

/// As Material::sample, the last pass first, which is most often the nearest.
MaterialSample Walk::sample(const Vec3& p) const {
  MaterialSample best = in_raw_ ? MaterialSample{-limit_mm_, {}, {}} : material_.sample_of({}, p);
  if (hint_.pass > 0) {
    const MaterialSample guessed = material_.sample_of(hint_, p);
    if (guessed.value > best.value) best = guessed;
  }
  const auto& passes = material_.passes();
  for (std::size_t k = passes.size(); k-- > 0;)
    if (const auto found = passes[k]->nearest(p, -best.value))
      best = {-found->at.distance,
              -found->at.gradient,
              {static_cast<std::uint32_t>(k + 1), found->slot}};
  return best;
}

/// From t_, inside a convex body, to where the ray leaves it: no further than that, and short of it
/// by no more than a fraction of kLeastFeature_mm. The body's distance is convex along the ray, so
/// that a chord lies above it and a tangent below.
double Walk::way_out(SurfaceMaker body) const {
  // Of a move that turns its tool, the tool as it stands where it holds the start.
  const SweepIndex* pass = body.pass > 0 ? material_.passes()[body.pass - 1].get() : nullptr;
  const bool turns = pass && pass->own().turns();
  const SweptSample start = turns ? pass->distance(body.slot, at(t_)) : SweptSample{};
  const auto distance = [&](double t) {
    if (pass) {
      const SweptSample s = pass->convex_part(body.slot, start, at(t));
      return Along{s.distance, dot(s.gradient, along_)};
    }
    const MaterialSample s = material_.sample_of(body, at(t));
    return Along{s.value, dot(s.gradient, along_)};
  };
  double a = t_, b = limit_mm_;
  Along low = distance(a), high = distance(b);
  if (high.value <= 0) return b;
  constexpr int kMost = 60;
  for (int k = 0; k < kMost && b - a > 0.1 * kLeastFeature_mm; ++k) {
    const double chord = a + (b - a) * low.value / (low.value - high.value);
    const double tangent = high.slope > 0 ? b - high.value / high.slope : b;
    const double next = k % 2 == 0 ? tangent : chord;
    const double middle = next > a && next < b ? next : (a + b) / 2;
    const Along s = distance(middle);
    if (s.value <= 0)
      a = middle, low = s;
    else
      b = middle, high = s;
  }
  return a;
}

/// How far along the ray the move is proven not to be, `end_mm` at most: by a plane under its
/// distance, and where the tool turns by the distance itself, which changes by no more than the
/// way.
double Walk::clear_ahead(const SweepIndex& pass, std::uint32_t slot, const Vec3& p,
                         const SweptSample& d, double end_mm) const {
  constexpr double kOn = std::numeric_limits<double>::infinity();
  const double slope = dot(d.gradient, along_);
  if (!pass.own().turns()) return slope >= 0 ? kOn : -d.distance / slope;
  const double above = d.distance - pass.sag(slot, p, d, end_mm);
  if (above < 0) return d.distance;
  return slope >= 0 ? kOn : std::max(d.distance, -above / slope);
}

/// From t_, in the material: a way ahead without any move, and shorter than kAhead_mm only where
/// one is entered.
double Walk::first_entry() const {
  const double end = std::min(t_ + kAhead_mm, limit_mm_);
  double first = end;
  std::vector<std::uint32_t> slots;
  for (const auto& pass : material_.passes()) {
    slots.clear();
    pass->gather(at(t_), end - t_, slots);
    for (const std::uint32_t slot : slots) {
      double t = t_;
      for (int k = 0; k < 60 && t < first; ++k) {
        const SweptSample d = pass->distance(slot, at(t));
        if (d.distance <= 0.1 * kLeastFeature_mm) break;
        t = std::min(end, t + clear_ahead(*pass, slot, at(t), d, end - t));
      }
      first = std::min(first, t);
    }
  }
  return first;
}

/// How far from t_ the exact material proves that all is like here.
double Walk::proven_step(const MaterialSample& s) {
  if (!*inside_) return s.maker.pass > 0 ? std::max(s.value, way_out(s.maker) - t_) : s.value;
  const double step = -s.value;
  short_steps_ = step < kShort_mm ? short_steps_ + 1 : 0;
  if (short_steps_ <= kShortSteps) return step;
  return std::max(step, std::min(raw_left(), first_entry() - t_));
}

/// From t_, in the material: a way on which the raw stock does not end.
double Walk::raw_left() const {
  if (in_raw_) return limit_mm_ - t_;
  return material_.raw().convex() ? way_out({}) - t_ : -material_.sample_of({}, at(t_)).value;
}

StockRays::Run Walk::go() {
  for (int step = 0; step < kMostSteps; ++step) {
    if (lead_by_grid()) return open_end();
    const MaterialSample s = sample(at(t_));
    hint_ = s.maker;
    const bool inside = s.value < 0;
    if (inside_ && inside != *inside_)
      return {*inside_, std::min(t_, limit_mm_), true, kLeastFeature_mm};
    inside_ = inside;
    t_ += std::max(proven_step(s), 0.0) + kLeastFeature_mm;
    if (t_ >= limit_mm_) return open_end();
  }
  return open_end();
}

}  // namespace

StockRays::Run StockRays::run(const Vec3& from, const Vec3& along, double limit_mm) const {
  if (!(limit_mm > 0)) return {stock_.exact_value(from) < 0, 0, false, 0};
  return Walk(stock_, from, along, limit_mm, false).go();
}

StockRays::Run StockRays::run_in_raw(const Vec3& from, const Vec3& along, double limit_mm) const {
  if (!(limit_mm > 0)) return {stock_.exact_value(from) < 0, 0, false, 0};
  return Walk(stock_, from, along, limit_mm, true).go();
}

}  // namespace limitgauge::simulator
