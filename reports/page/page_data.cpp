#include "reports/page/page_data.h"

#include <cmath>
#include <ostream>

#include "reports/page/blocks.h"
#include "reports/page/field_data.h"
#include "reports/page/findings_data.h"
#include "reports/page/fixture_data.h"
#include "reports/page/path_view.h"
#include "reports/page/stock_data.h"
#include "reports/page/surface_data.h"
#include "reports/text/embedded.h"
#include "reports/text/text.h"

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

/// Unit vectors of which a page shows four digits.
Json axes_block(const PathView& view, Blob& blob) {
  constexpr int kBits = 16;
  Json out = {{"start", point_json(view.start_axis)}, {"within_deg", view.axis_within_deg}};
  for (int k = 0; k < 3; ++k) {
    std::vector<float> part;
    for (const model::Vec3& axis : view.axes)
      part.push_back(with_bits(static_cast<float>(axis[k]), kBits));
    out[std::string(1, "xyz"[k])] = blob.add(part);
  }
  return out;
}

/// "path" of a stage.
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
  Json out = {{"moves", view.moves},
              {"within_mm", view.within_mm},
              {"start_mm", point_json(view.start)},
              {"position", points_block(on_grid(tips), blob)},
              {"kind", blob.add(kind)},
              {"feed_mm_min", blob.add(feed)},
              {"rate_mm3_min", rates_block(view, blob)},
              {"line", blob.add(line)},
              {"move", blob.add(move)},
              {"end_s", times_block(view, blob)}};
  if (!view.axes.empty()) out["axis"] = axes_block(view, blob);
  return out;
}

Json interval_json(const verifier::Interval& interval) {
  return {{"low", interval.low}, {"high", interval.high}};
}

Json limits_json(const verifier::GateLimits& limits) {
  Json out = Json::object();
  if (limits.has_gouge) out["gouge_mm"] = limits.gouge_mm;
  if (limits.has_uncut) out["uncut_mm"] = limits.uncut_mm;
  if (limits.has_coverage) out["coverage"] = limits.coverage;
  return out;
}

Json parts_json(const std::vector<model::CylinderPart>& parts) {
  Json out = Json::array();
  for (const model::CylinderPart& part : parts)
    out.push_back({{"diameter_mm", part.diameter_mm}, {"length_mm", part.length_mm}});
  return out;
}

Json cutter_json(const model::Cutter& cutter) {
  return {{"type", model::name(cutter.type)},
          {"diameter_mm", cutter.diameter_mm},
          {"corner_radius_mm", cutter.corner_radius_mm},
          {"taper_angle_deg", cutter.taper_angle_deg},
          {"tip_angle_deg", cutter.tip_angle_deg},
          {"flute_length_mm", cutter.flute_length_mm},
          {"shank", parts_json(cutter.shank)},
          {"holder", parts_json(cutter.holder)}};
}

std::string source_text(const StageResult& stage) {
  if (stage.program.empty()) return clean_text(stage.strategy);
  return "program " + clean_text(stage.program) + (stage.program_part.empty() ? "" : ", ") +
         clean_text(stage.program_part);
}

Json stage_json(const StageResult& stage, std::size_t index) {
  Json out = {{"name", clean_text(stage.name)},
              {"index", index},
              {"tool", clean_text(stage.tool)},
              {"cutter", cutter_json(stage.cutter)},
              {"path_source", source_text(stage)},
              {"verdict", verifier::name(stage.verdict())},
              {"ran", stage.ran.has_value()},
              {"limits", limits_json(stage.limits)},
              {"gouges", Json::array()},
              {"gouges_total", 0},
              {"uncuts", Json::array()},
              {"uncuts_total", 0},
              {"process", Json::array()},
              {"process_total", 0},
              {"fixtures", Json::array()},
              {"moving_fixtures", Json::array()},
              {"field", nullptr},
              {"path", nullptr}};
  if (stage.allowance_mm) out["allowance_mm"] = *stage.allowance_mm;
  // How the tool stands: rows of the rotation from the part's frame to the one it is upright in.
  if (!stage.setup.name.empty()) {
    Json rows = Json::array();
    for (const model::Vec3& row : stage.setup.from_part.rows) rows.push_back(point_json(row));
    out["setup"] = {{"name", clean_text(stage.setup.name)}, {"rotation", std::move(rows)}};
  }
  return out;
}

Json figures_json(const verifier::StageDeviation& d) {
  return {{"gouge_mm", interval_json(d.gouge_mm)},
          {"uncut_mm", interval_json(d.uncut_mm)},
          {"percentiles", {{"p01_mm", d.p01_mm}, {"p50_mm", d.p50_mm}, {"p99_mm", d.p99_mm}}},
          {"histogram", {{"edges_mm", d.histogram.edges_mm}, {"area_mm2", d.histogram.area_mm2}}}};
}

/// The page's data in the making.
class Writer {
 public:
  explicit Writer(const RunResult& result) : result_(result) {}

  PageData data() {
    Json stages = Json::array();
    for (std::size_t i = 0; i < result_.stages.size(); ++i) stages.push_back(stage(i));
    const model::Box3 box =
        result_.surface ? result_.surface->bbox_mm : bounding_box(result_.raw_stock);
    Json json = {{"format", "limitgauge.page/1"},
                 {"job", clean_text(result_.job)},
                 {"created", clean_text(result_.created)},
                 {"version", clean_text(result_.version)},
                 {"verdict", verifier::name(result_.verdict)},
                 {"bounds_mm", {point_json(box.low), point_json(box.high)}},
                 {"surfaces", surfaces_.json()},
                 {"fixtures", fixtures_.json()},
                 {"stages", std::move(stages)},
                 {"blob_bytes", 0}};
    if (const MeshDesign* mesh = result_.mesh_design()) json["triangles"] = triangles(*mesh);
    json["blob_bytes"] = blob_.bytes().size();
    return {safe_text(json), packed(blob_.bytes())};
  }

 private:
  /// Of each three patches the triangle of the file that they make up, as people count.
  Json triangles(const MeshDesign& mesh) {
    std::vector<std::uint32_t> numbers;
    for (const std::size_t number : mesh.numbers)
      numbers.push_back(static_cast<std::uint32_t>(number + 1));
    return blob_.add(numbers);
  }

  Json stage(std::size_t index) {
    const StageResult& asked = result_.stages[index];
    Json out = stage_json(asked, index);
    out["text"] = text_data(result_, index, blob_);
    if (!asked.ran) return out;
    out.update(findings_data(*asked.ran, result_.mesh_design()));
    add_fixtures(asked, out);
    if (asked.ran->deviation) add_deviation(*asked.ran->deviation, out);
    if (asked.ran->stock_view) out["stock"] = stock_data(*asked.ran->stock_view, blob_);
    if (asked.ran->path_view) out["path"] = path_data(*asked.ran->path_view, blob_);
    return out;
  }

  void add_fixtures(const StageResult& stage, Json& out) {
    for (const model::Fixture& fixture : stage.ran->fixtures)
      out["fixtures"].push_back(fixtures_.add(fixture, stage.setup.from_part.inverse(), blob_));
    for (const std::string& name : stage.ran->moving_fixtures)
      out["moving_fixtures"].push_back(clean_text(name));
  }

  void add_deviation(const verifier::StageDeviation& d, Json& out) {
    out.update(figures_json(d));
    if (d.field.grids.empty()) return;
    const PageGrid grid = page_grid(d.field);
    out["field"] = field_data(d, grid, surfaces_.add(d.field, grid, blob_), blob_);
  }

  /// Inside a script element nothing but "<" can end or nest it.
  static std::string safe_text(const Json& json) {
    std::string out;
    for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
      if (c == '<') {
        out += "\\u003c";
      } else {
        out += c;
      }
    }
    return out;
  }

  const RunResult& result_;
  Blob blob_;
  Surfaces surfaces_;
  Fixtures fixtures_;
};

}  // namespace

PageData page_data(const RunResult& result) {
  return Writer(result).data();
}

void write_page_script(const RunResult& result, std::ostream& out) {
  const PageData data = page_data(result);
  out << "<script type=\"application/json\" id=\"limitgauge-report\">" << data.json << "</script>\n"
      << "<script type=\"application/octet-stream\" id=\"limitgauge-blob\">" << data.blob
      << "</script>\n<script>" << embedded::report_js() << "</script>\n";
}

}  // namespace limitgauge::reports::page
