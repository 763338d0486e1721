#include "app/run/stage_prefix.h"

#include "app/run/packed_path.h"
#include "reports/run/report.h"

namespace limitgauge::app {

std::size_t StagePrefix::memory_bytes() const {
  std::size_t sum = model ? model->figures().memory_bytes : 0;
  if (stock) sum += stock->stock.memory_bytes() + stock->lines.memory_bytes();
  for (const RecordedStage& stage : stages)
    sum += stage.json->size() + stage.program_text->size() +
           stage.path->moves.size() * sizeof(model::Move) +
           (stage.axes ? stage.axes->to.size() * sizeof(model::Vec3) : 0);
  return sum;
}

namespace {

constexpr std::string_view kBegin = "limitgauge stages 2\n", kEnd = "end\n";

using Writer = model::Packer;
using Reader = model::Unpacker;

void write_stage(Writer& out, const RecordedStage& stage) {
  out.text(*stage.json);
  out.text(*stage.program_text);
  pack_path(out, *stage.path);
  pack_axes(out, stage.axes.get());
  out.number(std::int32_t{stage.sampling_interval_min});
  out.number(std::int32_t{stage.sampling_interval_max});
  out.number(static_cast<std::int32_t>(stage.verdict));
}

RecordedStage read_stage(Reader& in) {
  RecordedStage stage;
  stage.json = std::make_shared<const std::string>(in.text());
  stage.program_text = std::make_shared<const std::string>(in.text());
  stage.path = std::make_shared<const model::Toolpath>(unpack_path(in));
  stage.axes = unpack_axes(in, *stage.path);
  stage.sampling_interval_min = in.number<std::int32_t>();
  stage.sampling_interval_max = in.number<std::int32_t>();
  stage.verdict = static_cast<verifier::Verdict>(in.number<std::int32_t>());
  return stage;
}

void write_figures(Writer& out, const engine::surface::ModelFigures& figures) {
  for (const int value : {figures.patches, figures.depth_min, figures.depth_max})
    out.number(std::int32_t{value});
  out.number(std::uint64_t{figures.depths.size()});
  for (const int depth : figures.depths) out.number(std::int32_t{depth});
  out.number(figures.seconds);
  for (const std::size_t bytes :
       {figures.memory_bytes, figures.cell_bytes_counted, figures.cell_bytes_allocated})
    out.number(std::uint64_t{bytes});
}

engine::surface::ModelFigures read_figures(Reader& in) {
  engine::surface::ModelFigures figures;
  for (int* value : {&figures.patches, &figures.depth_min, &figures.depth_max})
    *value = in.number<std::int32_t>();
  figures.depths.resize(in.count(sizeof(std::int32_t)));
  for (int& depth : figures.depths) depth = in.number<std::int32_t>();
  figures.seconds = in.number<double>();
  for (std::size_t* bytes :
       {&figures.memory_bytes, &figures.cell_bytes_counted, &figures.cell_bytes_allocated})
    *bytes = in.number<std::uint64_t>();
  return figures;
}

/// A stage that was run came to one of three verdicts, and none comes after one that did not pass.
bool in_order(const StagePrefix& prefix) {
  using verifier::Verdict;
  if (prefix.stages.empty()) return false;
  for (std::size_t i = 0; i < prefix.stages.size(); ++i) {
    const RecordedStage& stage = prefix.stages[i];
    const bool last = i + 1 == prefix.stages.size();
    const bool ended = stage.verdict == Verdict::fail || stage.verdict == Verdict::indeterminate;
    if (stage.verdict != Verdict::pass && !(last && ended)) return false;
    if (!reports::is_recorded_stage(*stage.json)) return false;
  }
  return true;
}

}  // namespace

std::string to_text(const StagePrefix& prefix) {
  Writer out;
  out.mark(kBegin);
  out.number(std::uint64_t{prefix.stages.size()});
  for (const RecordedStage& stage : prefix.stages) write_stage(out, stage);
  out.number(std::int32_t{prefix.figures.has_value()});
  if (prefix.figures) write_figures(out, *prefix.figures);
  out.mark(kEnd);
  return out.take();
}

std::optional<StagePrefix> read_stage_prefix(std::string_view text) {
  Reader in(text);
  in.mark(kBegin);
  StagePrefix prefix;
  const std::size_t stages = in.count(1);
  for (std::size_t i = 0; i < stages && in.good(); ++i) prefix.stages.push_back(read_stage(in));
  if (in.number<std::int32_t>() != 0) prefix.figures = read_figures(in);
  in.mark(kEnd);
  if (!in.done() || !in_order(prefix)) return std::nullopt;
  return prefix;
}

}  // namespace limitgauge::app
