#include "reports/page/path_data.h"

#include <cmath>

#include "reports/page/findings_data.h"
#include "reports/page/surface_data.h"

namespace limitgauge::reports::page {
namespace {

constexpr int kRateBits = 13;

/// Times as multiples of a step of which 2^24 make the whole: finer than single precision has them.
Json times_block(const PathView& view, Blob& blob) {
  const double total_s = view.segments.empty() ? 0 : view.segments.back().end_s;
  const double step_s = total_s > 0 ? std::ldexp(1.0, std::ilogb(total_s) + 1 - 24) : 1;
  std::vector<std::uint32_t> multiples;
  for (const PathView::Segment& s : view.segments)
    multiples.push_back(static_cast<std::uint32_t>(std::llround(s.end_s / step_s)));
  return {{"block", blob.add(multiples)}, {"step_s", step_s}};
}

Json rates_block(const PathView& view, Blob& blob) {
  if (!view.has_rates) return nullptr;
  std::vector<float> rates;
  for (const PathView::Segment& s : view.segments)
    rates.push_back(with_bits(s.rate_mm3_min, kRateBits));
  return blob.add(rates);
}

}  // namespace

Json path_data(const PathView& view, Blob& blob) {
  std::vector<model::Vec3> tips;
  std::vector<std::uint8_t> kind;
  std::vector<float> feed;
  std::vector<std::uint32_t> line, move;
  for (const PathView::Segment& s : view.segments) {
    tips.push_back(s.to);
    kind.push_back(s.kind == model::MoveKind::feed ? 1 : 0);
    feed.push_back(s.feed_mm_min);
    line.push_back(s.line), move.push_back(s.move);
  }
  return {{"moves", view.moves},
          {"within_mm", view.within_mm},
          {"start_mm", point_json(view.start)},
          {"position", points_block(on_grid(tips), blob)},
          {"kind", blob.add(kind)},
          {"feed_mm_min", blob.add(feed)},
          {"rate_mm3_min", rates_block(view, blob)},
          {"line", blob.add(line)},
          {"move", blob.add(move)},
          {"end_s", times_block(view, blob)}};
}

}  // namespace limitgauge::reports::page
