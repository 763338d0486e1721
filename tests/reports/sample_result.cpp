#include "tests/reports/sample_result.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limitgauge::reports {
namespace {

using model::Vec3;

constexpr int kPatchesX = 6, kPatchesY = 5;
constexpr double kLengthX = 80, kLengthY = 65;

double height(double x, double y) {
  return 9 * std::cos(x / 26) * std::cos(y / 21) + 0.6 * std::sin(x / 5) * std::cos(y / 6);
}

/// What one sample's deviation is made of, mm.
struct Shape {
  double scallop_mm = 0, step_mm = 0;
  Vec3 gouge_at;
  double gouge_mm = 0, gouge_radius_mm = 1;
};

double deviation_at(const Vec3& p, const Shape& shape) {
  const double cusp = std::sin(std::numbers::pi * p.y / shape.step_mm);
  const double slope = 1 + 0.5 * std::sin(p.x / 9) * std::cos(p.y / 11);
  const double r = std::hypot(p.x - shape.gouge_at.x, p.y - shape.gouge_at.y);
  const double bump = std::exp(-r * r / (shape.gouge_radius_mm * shape.gouge_radius_mm));
  return shape.scallop_mm * cusp * cusp * slope - shape.gouge_mm * bump;
}

verifier::DeviationField::Sample sample_at(int patch, double u, double v, double area,
                                           const Shape& shape) {
  verifier::DeviationField::Sample s;
  const double x = ((patch % kPatchesX + u) / kPatchesX - 0.5) * kLengthX;
  const double y = ((patch / kPatchesX + v) / kPatchesY - 0.5) * kLengthY;
  s.place = {patch, u, v, {x, y, height(x, y)}};
  const double h = 1e-4;
  s.normal = model::normalized(Vec3{(height(x - h, y) - height(x + h, y)) / (2 * h),
                                    (height(x, y - h) - height(x, y + h)) / (2 * h), 1});
  s.deviation_mm = static_cast<float>(deviation_at(s.place.point, shape));
  s.reachable = std::hypot(x - 28, y + 22) > 5;
  s.area_mm2 = static_cast<float>(area);
  s.line = 100 + static_cast<std::uint32_t>(patch);
  s.move = s.line - 10;
  return s;
}

verifier::DeviationField make_field(const Shape& shape, int n) {
  verifier::DeviationField field;
  const double cell = kLengthX * kLengthY / (kPatchesX * kPatchesY) / ((n - 1) * (n - 1));
  const auto share = [&](int i) { return i == 0 || i == n - 1 ? 0.5 : 1.0; };
  for (int patch = 0; patch < kPatchesX * kPatchesY; ++patch) {
    const auto base = static_cast<std::uint32_t>(field.samples.size());
    field.grids.push_back({patch, std::uint32_t(n), std::uint32_t(n), base});
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        field.samples.push_back(sample_at(patch, double(i) / (n - 1), double(j) / (n - 1),
                                          cell * share(i) * share(j), shape));
    const auto at = [&](int i, int j) { return base + static_cast<std::uint32_t>(j * n + i); };
    for (int j = 0; j + 1 < n; ++j)
      for (int i = 0; i + 1 < n; ++i)
        field.quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  return field;
}

verifier::Finding finding_at(const verifier::DeviationField::Sample& s, double depth, double area,
                             std::size_t stage) {
  verifier::Finding f;
  f.place = s.place, f.depth_mm = depth, f.area_mm2 = area;
  f.extent_mm.add(s.place.point - Vec3{1, 1, 0.1}),
      f.extent_mm.add(s.place.point + Vec3{1, 1, 0.1});
  f.stage = stage, f.move = s.move, f.line = s.line;
  return f;
}

void fill_histogram(verifier::StageDeviation& d, double low, double high) {
  constexpr int kBins = 48;
  for (int i = 0; i <= kBins; ++i) d.histogram.edges_mm.push_back(low + (high - low) * i / kBins);
  d.histogram.area_mm2.assign(kBins, 0);
  for (const auto& s : d.field.samples) {
    if (!s.reachable) continue;
    const int bin = static_cast<int>((s.deviation_mm - low) / (high - low) * kBins);
    d.histogram.area_mm2[std::clamp(bin, 0, kBins - 1)] += s.area_mm2;
  }
}

void fill_statistics(verifier::StageDeviation& d, const verifier::GateLimits& limits) {
  double inside = 0, sum = 0, squares = 0;
  std::vector<float> values;
  for (const auto& s : d.field.samples) {
    d.surface_area_mm2 += s.area_mm2;
    (s.reachable ? d.reachable_area_mm2 : d.unreachable_area_mm2) += s.area_mm2;
    if (!s.reachable) continue;
    values.push_back(s.deviation_mm);
    sum += s.area_mm2 * s.deviation_mm;
    squares += s.area_mm2 * s.deviation_mm * s.deviation_mm;
    if (s.deviation_mm >= -limits.gouge_mm && s.deviation_mm <= limits.uncut_mm)
      inside += s.area_mm2;
  }
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  d.p01_mm = at(0.01), d.p50_mm = at(0.5), d.p99_mm = at(0.99);
  d.mean_mm = sum / d.reachable_area_mm2;
  d.rms_mm = std::sqrt(squares / d.reachable_area_mm2);
  d.coverage = inside / d.reachable_area_mm2;
  d.unavoidable_uncut_mm = {0.31, 0.315};
}

void fill_budget(verifier::StageDeviation& d) {
  d.budget = {
      {"reference surface evaluation", 8.1e-11, true}, {"arc chords", 0, true},
      {"rounding in distances", 3.2e-12, true},        {"programmed coordinates", 5e-5, true},
      {"single precision in grids", 7.6e-6, false},    {"projection residual", 2.4e-5, false},
      {"voxel interpolation", 1.9e-3, false},          {"another evaluator", 2.1e-14, false, true}};
}

verifier::StageDeviation measured(const Shape& shape, const verifier::GateLimits& limits,
                                  double interval_mm, std::size_t stage, int n) {
  verifier::StageDeviation d;
  d.field = make_field(shape, n);
  const auto less = [](const auto& a, const auto& b) { return a.deviation_mm < b.deviation_mm; };
  std::vector<verifier::DeviationField::Sample> seen;
  for (const auto& s : d.field.samples)
    if (s.reachable) seen.push_back(s);
  const auto [lowest, highest] = std::minmax_element(seen.begin(), seen.end(), less);
  const double gouge = std::max(0.0, -double(lowest->deviation_mm));
  const double uncut = std::max(0.0, double(highest->deviation_mm));
  d.gouge_mm = {gouge, gouge + interval_mm};
  d.uncut_mm = {uncut, uncut + interval_mm};
  if (gouge > 0) d.gouges.push_back(finding_at(*lowest, gouge, 3.2, stage));
  d.bodies = {{0, "cutter", d.gouge_mm}, {stage, "holder", {0, 0}}};
  if (uncut > 0) d.uncuts.push_back(finding_at(*highest, uncut, 0.4, stage));
  for (std::size_t i = 1; i < 4; ++i)
    d.uncuts.push_back(
        finding_at(seen[i * seen.size() / 5], uncut * (0.9 - 0.1 * double(i)), 0.2, stage));
  d.voxel_gouge_mm = gouge * 1.02, d.voxel_uncut_mm = uncut * 0.98;
  fill_statistics(d, limits);
  fill_histogram(d, lowest->deviation_mm * 1.1, highest->deviation_mm * 1.1);
  fill_budget(d);
  d.cells = 1'204'377, d.resolution_mm = limits.gouge_mm / 10, d.seconds = 11.4;
  d.reached_resolution = interval_mm <= d.resolution_mm;
  return d;
}

/// A zigzag over the shell, one plane every `step`.
std::shared_ptr<const model::Toolpath> zigzag(double step) {
  auto path = std::make_shared<model::Toolpath>();
  path->start = {-42, -34, 15};
  std::uint32_t line = 10;
  for (int k = 0; k * step <= kLengthY; ++k) {
    const double y = -kLengthY / 2 + k * step;
    const double from = k % 2 == 0 ? -40 : 40;
    if (k == 0) path->moves.push_back({{from, y, 15}, 0, line++, model::MoveKind::rapid});
    for (int i = 0; i <= 40; ++i) {
      const double x = from * (1 - i / 20.0);
      path->moves.push_back({{x, y, height(x, y)}, 1200, line++, model::MoveKind::feed});
    }
  }
  return path;
}

/// Something that stands on the lines that the moves name.
std::string program_text(const model::Toolpath& path) {
  std::string text(9, '\n');
  for (const model::Move& move : path.moves)
    text += "G1 X" + std::to_string(move.to.x) + " Y" + std::to_string(move.to.y) + "\n";
  return text;
}

struct StageForm {
  const char* name;
  const char* tool;
  model::CutterType type;
  double diameter_mm, allowance_mm, step_mm;
  const char* strategy;
  verifier::GateLimits limits;
  Shape shape;
  double interval_mm;
};

StageResult make_stage(const StageForm& form, std::size_t index, int n) {
  StageResult stage;
  stage.name = form.name, stage.tool = form.tool, stage.strategy = form.strategy;
  stage.cutter.id = form.tool, stage.cutter.type = form.type;
  stage.cutter.diameter_mm = form.diameter_mm, stage.cutter.flute_length_mm = 25;
  if (form.type == model::CutterType::ball) stage.cutter.corner_radius_mm = form.diameter_mm / 2;
  stage.allowance_mm = form.allowance_mm, stage.step_mm = form.step_mm, stage.tolerance_mm = 0.01;
  stage.limits = form.limits;
  StageRun ran;
  ran.path = zigzag(form.step_mm * 8);
  ran.planes = static_cast<int>(87.2 / form.step_mm);
  ran.sampling_interval_min = 1, ran.sampling_interval_max = 4;
  const model::ToolpathLengths lengths = model::lengths(*ran.path, 5000);
  ran.cut_length_mm = lengths.cut_mm, ran.rapid_length_mm = lengths.rapid_mm;
  ran.machining_time_s = lengths.time_s;
  ran.plan_seconds = 2.31, ran.path_memory_bytes = ran.path->moves.size() * sizeof(model::Move);
  ran.voxel_mm = 0.1, ran.removed_volume_mm3 = 104'511.25, ran.simulation_seconds = 6.2;
  ran.peak_memory_bytes = 812'000'000;
  ran.removal.totals = {104'498.5, 15'360, 17, 2.5, 6.25, 812.5, 40.6, 0.1};
  ran.program_text = std::make_shared<const std::string>(program_text(*ran.path));
  ran.deviation = measured(form.shape, form.limits, form.interval_mm, index, n);
  stage.ran = std::move(ran);
  stage.decision = {verifier::Verdict::pass,
                    {"gouge, uncut and coverage are proven inside their limits"}};
  stage.seconds = 19.9;
  return stage;
}

verifier::GateLimits limits(double gouge_mm, double uncut_mm, double coverage) {
  return {true, true, true, gouge_mm, uncut_mm, coverage};
}

void make_fail(StageResult& stage) {
  stage.decision = {
      verifier::Verdict::fail,
      {"gouge: at least 61.1 µm is cut below the allowance surface, the limit is 50 µm",
       "2 rapids go through standing material"}};
  using simulator::FindingKind;
  stage.ran->process = {
      {FindingKind::rapid_through_stock, 412, 423, {11.5, -20.25, 4.125}, 0.84, "cutter", "stock"},
      {FindingKind::rapid_through_stock, 977, 988, {-31, 8, 3.5}, 0.12, "cutter", "stock"},
      {FindingKind::holder_in_stock, 1502, 1513, {2.5, 30, -1.25}, 1.375, "holder", "stock"},
      {FindingKind::spindle_stopped, 1600, 1611, {2, 3, 1}, 0.25, "cutter", "stock"},
      {FindingKind::spindle_stopped, 1601, 1612, {2, 5, 1}, 0.5, "cutter", "stock"},
      {FindingKind::near_miss, 1700, 1711, {9, 30, 4}, -0.75, "holder", "clamp"}};
}

StageResult not_run(const StageResult& stage, const char* failed) {
  StageResult out = stage;
  out.ran.reset();
  out.seconds = 0;
  out.decision = {verifier::Verdict::not_run,
                  {std::string("not run: stage ") + failed + " failed"}};
  return out;
}

void set_surface(SurfaceResult& s) {
  s.cage = "aircraft.obj";
  s.summary.vertices = 42, s.summary.faces = 30, s.summary.patches = 30;
  s.summary.boundary_edges = 22, s.summary.extraordinary_vertices = 6;
  s.bbox_mm = {{-40.6, -32.75, 0}, {40.6, 32.75, 11.6}};
  s.area_mm2 = 4012.5, s.depth_min = 4, s.depth_max = 7;
  s.sampling_interval_min = 4, s.sampling_interval_max = 16;
  s.seconds = 0.42, s.memory_bytes = 21'400'000;
  s.witness = {.evaluator = "OpenSubdiv 3.5.0",
               .levels = 4,
               .points = 8'670,
               .by_refinement = 12,
               .points_left_out = 0,
               .worst_mm = 2.1e-14,
               .bound_mm = 1.9e-10,
               .worst_at = witness::Agreement::Place{7, 0.25, 1, {11.5, -20.25, 4.125}},
               .normals = 8'100,
               .normals_left_out = 570,
               .worst_normal_rad = 3.4e-14,
               .normal_bound_rad = 7.7e-9,
               .contradiction = std::nullopt,
               .seconds = 0.02};
}

}  // namespace

RunResult sample_result(Outcome outcome, int samples_per_edge) {
  const bool failed = outcome == Outcome::failed, open = outcome == Outcome::indeterminate;
  RunResult r;
  r.job = "aircraft", r.created = "2026-11-21T08:15:00Z", r.version = "0.1.0", r.threads = 2;
  r.raw_stock = model::BoxStock{{-45, -40, -20}, {90, 80, 30}};
  r.assumptions = {"rapid moves are straight lines at 5000 mm/min",
                   "machining time takes no acceleration into account"};
  r.inputs = {{"job", "aircraft.toml", 2'518, std::string(64, '3')},
              {"cage", "aircraft.obj", 1'204, std::string(64, 'c')}};
  set_surface(r.surface.emplace());
  r.program_frame = {90, {1, 2, 3}};
  r.machine.home_mm = {0, 0, 150};
  r.machine.work_offsets[6] = model::WorkOffset{{4, 5, 6}, 30};
  r.machine.tools = {{3, 80.5, 6.0}, {4, {}, {}}};
  using enum model::CutterType;
  const Shape dent{0.011, 0.25, {-12, 9, 0}, failed ? 0.0631 : 0.004, 2.5};
  r.stages = {make_stage({"rough",
                          "flat8",
                          flat,
                          8,
                          0.2,
                          0.2,
                          "contour",
                          limits(0.05, 1, 0.99),
                          {0.19, 9, {5, 5, 0}, 0.013, 4},
                          0.002},
                         0, samples_per_edge),
              make_stage({"semi-finish", "ball3", ball, 6, 0.2, 0.25, "zigzag",
                          limits(0.05, 0.1, 0.99), dent, 0.0004},
                         1, samples_per_edge),
              make_stage({"finish",
                          "ball3",
                          ball,
                          6,
                          0,
                          0.1,
                          "zigzag",
                          limits(0.01, 0.01, 0.995),
                          {open ? 0.0063 : 0.00042, 2.3, {20, -3, 0}, 0.0006, 3},
                          open ? 0.0031 : 6e-5},
                         2, samples_per_edge)};
  if (failed) {
    make_fail(r.stages[1]);
    r.stages[2] = not_run(r.stages[2], "semi-finish");
  }
  if (open)
    r.stages[2].decision = {
        verifier::Verdict::indeterminate,
        {"uncut: proven between 9.4 µm and 12.6 µm, the limit 10 µm lies between"}};
  r.verdict = failed ? verifier::Verdict::fail
              : open ? verifier::Verdict::indeterminate
                     : verifier::Verdict::pass;
  return r;
}

RunResult foreign_result(int samples_per_edge) {
  RunResult r = sample_result(Outcome::failed, samples_per_edge);
  r.job = "=HYPERLINK(\"x\")<b>&";
  r.stages[0].name = "=1+1", r.stages[1].name = "@semi \"{0}\", [a](b)";
  r.stages[2].name = "</script><b>";
  r.stages[0].program = r.stages[1].program = "nc/part 1 (T1-T2) é#?.ngc";
  r.stages[0].program_part = "T1", r.stages[1].program_part = "T2";
  r.stages[2].program = "/nc/finish.ngc";
  for (StageResult& stage : r.stages) stage.strategy.clear();
  // The rough stage's move made the worst gouge, its passes lie around the worst leftover, and a
  // second one stands where no pass came.
  verifier::StageDeviation& d = *r.stages[1].ran->deviation;
  d.gouges.front().stage = 0;
  d.uncuts.front().passes = {{1, 90, 100, 0.25}, {0, 95, 105, 0.5}};
  d.uncuts[1].raw_stock = true, d.uncuts[1].line = 0, d.uncuts[1].move = 0;
  r.stages[1].limits.has_uncut = false;
  return r;
}

RunResult turning_result(int samples_per_edge) {
  RunResult r = sample_result(Outcome::passed, samples_per_edge);
  StageResult& stage = r.stages[1];
  stage.cutter.shank = {{10, 20}}, stage.cutter.holder = {{30, 25}, {44, 15}};
  model::ToolAxes axes;
  const auto radians = [](double degrees) { return degrees * std::numbers::pi / 180; };
  const double lean = radians(20);
  for (std::size_t i = 0; i < stage.ran->path->moves.size(); ++i) {
    const double about = radians(static_cast<double>(i));
    axes.to.push_back(
        {std::sin(lean) * std::cos(about), std::sin(lean) * std::sin(about), std::cos(lean)});
  }
  stage.ran->axes = std::make_shared<const model::ToolAxes>(std::move(axes));
  return r;
}

RunResult cut_result() {
  RunResult r = foreign_result(3);
  r.surface.reset();
  for (StageResult& stage : r.stages) {
    stage.allowance_mm.reset();
    stage.limits = {};
    stage.step_mm = stage.tolerance_mm = 0;
    if (stage.program.empty()) stage.program = "rest.ngc";
    stage.strategy.clear();
    if (stage.ran) stage.ran->deviation.reset();
  }
  r.stages[0].decision.reasons = {"no fault in the process"};
  r.stages[1].decision.reasons = {"rapid through standing material: 1 move"};
  return r;
}

}  // namespace limitgauge::reports
