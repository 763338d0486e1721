#include "reports/picture/perspective_picture.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "reports/picture/colour_bar.h"
#include "reports/picture/deviation_map.h"
#include "reports/picture/lettering.h"
#include "reports/picture/marker.h"
#include "reports/picture/perspective_map.h"
#include "reports/picture/tool_side.h"
#include "reports/run/gate_figures.h"
#include "reports/text/text.h"

namespace limitgauge::reports {
namespace {

constexpr Rgba kInk{28, 32, 38}, kWhite{255, 255, 255};
constexpr int kMapWidth = 1240, kMapHeight = 860, kLeastHeight = 520;
constexpr int kMargin = 36, kHeader = 96, kFooter = 96, kLegendWidth = 360;
constexpr TextStyle kText{20, kInk};

/// The worst of a kind, with the name that the page gives it.
struct Mark {
  std::string id, words;
  const verifier::Finding& finding;
};

std::vector<Mark> marks_of(const verifier::StageDeviation& d) {
  std::vector<Mark> marks;
  if (!d.gouges.empty()) marks.push_back({"G1", "worst gouge", d.gouges.front()});
  if (!d.uncuts.empty()) marks.push_back({"U1", "worst leftover", d.uncuts.front()});
  return marks;
}

/// From the front right first, then from the other corners; the first from which most marks are in
/// sight.
PerspectiveView best_view(const verifier::DeviationField& field, const std::vector<Mark>& marks) {
  constexpr double kQuick = 0.3;
  std::optional<PerspectiveView> best;
  std::ptrdiff_t most = -1;
  for (const model::Vec3& towards :
       {model::Vec3{0.52, -0.95, 0.80}, model::Vec3{-0.52, -0.95, 0.80},
        model::Vec3{0.52, 0.95, 0.80}, model::Vec3{-0.52, 0.95, 0.80}}) {
    const PerspectiveView view(field, towards, kMapWidth, kMapHeight);
    const PerspectiveView quick = view.scaled(kQuick);
    const DepthBuffer depth = perspective_depth(field, quick);
    const auto seen = std::count_if(marks.begin(), marks.end(), [&](const Mark& m) {
      return is_in_sight(quick.project(m.finding.place.point), depth);
    });
    if (seen > most) best = view, most = seen;
    if (std::size_t(most) == marks.size()) break;
  }
  return *best;
}

/// `style`, or as much smaller as `text` must be to fit `width` pixels, as long as it is legible.
TextStyle fitted(TextStyle style, const std::string& text, double width) {
  constexpr double kLegible = 8, kStep = 0.5;
  while (style.height > kLegible && text_width(text, style) > width) style.height -= kStep;
  return style;
}

void draw_header(Image& image, const StageResult& stage) {
  draw_text(image, shortened(stage.name, 40) + ": " + verdict_text(stage.verdict()),
            {kMargin + 4.0, 58}, {30, kInk, true});
  std::string figures;
  for (const GateFigure& figure : gate_figures(stage)) {
    const bool is_depth = figure.name == "gouge" || figure.name == "uncut";
    if (!is_depth && figure.standing != Standing::beyond) continue;
    figures += (figures.empty() ? "" : ",   ") + figure.name + " " + figure.measured;
    if (!figure.limit.empty()) figures += " (limit " + figure.limit + ")";
  }
  draw_text(image, figures, {kMargin + 4.0, 94},
            fitted(kText, figures, image.width() - 2 * kMargin));
}

void draw_marks(Image& image, const std::vector<Mark>& marks, const PerspectiveView& view,
                const PerspectiveMap& map, double foot) {
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const verifier::Finding& f = marks[i].finding;
    const ScreenPoint p = view.project(f.place.point);
    const std::string depth = measured_length(f.depth_mm);
    draw_marker(image, {p.x + kMargin, p.y + kMargin + kHeader}, marks[i].id + " " + depth,
                kMapWidth + kMargin);
    std::string note = marks[i].id + ": " + marks[i].words + " " + depth + ", patch " +
                       std::to_string(f.place.patch);
    // An earlier stage's move may have done it; stages are counted as the report lists them.
    note += f.line > 0
                ? ", stage " + std::to_string(f.stage + 1) + " line " + std::to_string(f.line)
                : std::string(", raw stock");
    if (!map.in_sight[i]) note += " (behind)";
    draw_text(image, note, {kMargin + 4.0, foot + 36.0 * double(i)}, kText);
  }
}

void draw_legend(Image& image, const DeviationScale& scale, int body, bool hatched) {
  const int left = kMapWidth + 2 * kMargin, top = kMargin + kHeader;
  draw_text(image, "uncut: left standing", {double(left), top + 20.0}, kText);
  draw_colour_bar(image, scale, {left, top + 46, body - 92}, true);
  draw_text(image, "gouge: cut too deep", {double(left), top + body + 2.0}, kText);
  if (!hatched) return;
  draw_hatch(image, left, top + body + 28, 28);
  draw_text(image, "not reachable", {left + 40.0, top + body + 52.0}, kText);
}

}  // namespace

Image draw_perspective_picture(const StageResult& stage) {
  const ToolSide side(stage);
  const verifier::StageDeviation& d = side.deviation();
  const DeviationScale scale = DeviationScale::for_gate(d, stage.limits);
  const std::vector<Mark> marks = marks_of(d);
  const PerspectiveView view = best_view(d.field, marks);
  std::vector<model::Vec3> places;
  for (const Mark& mark : marks) places.push_back(mark.finding.place.point);
  const PerspectiveMap map = draw_perspective_map(d.field, scale, view, places);
  const int body = std::max(view.height(), kLeastHeight);
  Image image(kMapWidth + 2 * kMargin + kLegendWidth, body + 2 * kMargin + kHeader + kFooter,
              kWhite);
  image.draw(map.image, kMargin, kMargin + kHeader);
  draw_header(image, stage);
  const double foot = kMargin + kHeader + body + 44.0;
  const model::Pose& pose = stage.setup.from_part;
  draw_axes(image, pose.direction_back(view.right()), pose.direction_back(view.up()),
            {kMargin + 60.0, kHeader + kMargin + body - 40.0});
  draw_marks(image, marks, view, map, foot);
  draw_legend(image, scale, body, d.unreachable_area_mm2 > 0);
  return image;
}

}  // namespace limitgauge::reports
