#include "app/job/job_reader.h"

#include <algorithm>

#include "app/job/job_parts.h"
#include "app/job/oriented_job.h"
#include "app/job/turning_stage.h"
#include "app/toml/toml_table.h"
#include "app/toml/toml_text.h"
#include "model/base/text_file.h"
#include "model/text/number_text.h"

namespace limitgauge::app {
namespace {

PartLength part_length(const TomlTable& table, std::string_view key, double mm) {
  return {"\"" + std::string(key) + "\" in " + table.where(), mm, table.place(key)};
}

JobDesign read_surface(const toml::table& table, JobContext& context) {
  const TomlTable surface(table, "[surface]", {"cage", "mesh", "precision", "transform"});
  const bool is_mesh = surface.has("mesh");
  if (is_mesh && surface.has("cage"))
    throw model::InputError(surface.place("mesh"), "[surface] has both cage and mesh",
                            "one of the two");
  const char* key = is_mesh ? "mesh" : "cage";
  JobDesign design;
  design.kind = is_mesh ? DesignKind::mesh : DesignKind::cage;
  design.as_stated = surface.text(key);
  design.file = context.folder / design.as_stated;
  if (!model::is_file(design.file)) {
    throw model::InputError(surface.place(key), "no file \"" + design.as_stated + "\"",
                            is_mesh ? "a mesh as STL, PLY or OBJ" : "a cage as OBJ");
  }
  if (is_mesh) {
    if (surface.has("precision"))
      throw model::InputError(surface.place("precision"),
                              "\"precision\" beside \"mesh\" would change nothing: it is of the "
                              "surface that paths are planned on",
                              "it only beside \"cage\"");
  } else if (surface.has("precision")) {
    design.precision_mm = part_length_mm(surface, "precision", context.part_lengths);
  } else {
    context.defaulted.push_back("surface precision " + model::shortest(design.precision_mm) +
                                " mm (default)");
  }
  read_placement(surface, design);
  return design;
}

void read_voxel(const TomlTable& simulation, Job& job) {
  job.voxel_mm = simulation.length_or_auto_mm("voxel");
  job.stated_voxel.reset();
  if (job.voxel_mm) job.stated_voxel = part_length(simulation, "voxel", *job.voxel_mm);
}

reports::StockSurfaceFile stock_surface_of(const TomlTable& report) {
  using enum reports::StockSurfaceFile;
  const std::string word = report.one_of("stock", {"cut", "whole", "none"});
  return word == "cut" ? cut : word == "whole" ? whole : none;
}

/// Paths are planned on limit surfaces of cages.
void refuse_planning(const Job& job, const TomlTable& root) {
  if (!job.design || job.design->kind != DesignKind::mesh) return;
  const std::vector<const toml::table*> stages = root.tables("stage");
  for (std::size_t i = 0; i < job.stages.size(); ++i)
    if (job.stages[i].plan)
      throw model::InputError(
          place_of(stages[i]->get("strategy")->source()),
          "stage \"" + job.stages[i].name + "\" is to be planned, but the design is a mesh",
          "\"program\" in its place, or a Catmull-Clark cage as design");
}

Job read_root(const toml::table& table, JobContext& context) {
  const TomlTable root(table, "the job", {}, kJobKeys);
  Job job;
  job.name = read_job_name(root);
  context.has_design = root.has("surface");
  if (!context.has_design) refuse_design_keys(root);
  if (root.has("surface")) job.design = read_surface(root.table("surface"), context);
  job.stock = read_stock(root.table("stock"), context);
  read_machine(root, job, context);
  read_setups(root, job);
  read_fixtures(root, job, context);
  const std::vector<JobTool> tools = read_tools(root.tables("tool"), context);
  job.machine.tools = tool_table(tools);
  job.stages = read_stages(root.tables("stage"), tools, job.setups, context);
  require_tool_lengths(root, job);
  refuse_planning(job, root);
  read_post(root, job, context);
  read_settings(root, job);
  std::vector<model::Cutter> cutters;
  for (const JobTool& tool : tools) cutters.push_back(tool.cutter);
  read_tolerances(root, cutters, job);
  require_leaning_stages(job);
  if (root.has("published")) job.published = read_published(root);
  job.defaulted = std::move(context.defaulted);
  job.sources = std::move(context.sources);
  job.part_lengths.insert(job.part_lengths.end(), context.part_lengths.begin(),
                          context.part_lengths.end());
  return job;
}

}  // namespace

double part_length_mm(const TomlTable& table, std::string_view key,
                      std::vector<PartLength>& lengths) {
  lengths.push_back(part_length(table, key, table.length_mm(key)));
  return lengths.back().mm;
}

double part_length_or_zero_mm(const TomlTable& table, std::string_view key,
                              std::vector<PartLength>& lengths) {
  lengths.push_back(part_length(table, key, table.length_or_zero_mm(key)));
  return lengths.back().mm;
}

std::string read_job_name(const TomlTable& root) {
  const std::string name = root.text("name");
  if (!is_plain_name(name)) {
    throw model::InputError(root.place("name"), "\"" + name + "\" cannot name a folder",
                            "letters, digits, '.', '_', '-'");
  }
  return name;
}

void read_placement(const TomlTable& surface, JobDesign& design) {
  if (!surface.has("transform")) return;
  const TomlTable transform(surface.table("transform"), "\"transform\" of [surface]",
                            {"scale", "rotate_z", "translate"});
  if (transform.has("scale")) design.placement.scale = transform.scale("scale");
  if (transform.has("rotate_z")) design.placement.rotate_z_deg = transform.angle_deg("rotate_z");
  if (transform.has("translate")) design.placement.translate_mm = transform.shift_mm("translate");
}

void read_settings(const TomlTable& root, Job& job) {
  if (root.has("simulation")) {
    const TomlTable simulation(root.table("simulation"), "[simulation]",
                               {"voxel", "near_miss", "contact_tolerance"});
    if (simulation.has("voxel")) read_voxel(simulation, job);
    if (simulation.has("near_miss")) job.near_miss_mm = simulation.length_mm("near_miss");
    if (simulation.has("contact_tolerance"))
      job.contact_tolerance_mm = part_length_mm(simulation, "contact_tolerance", job.part_lengths);
  }
  if (root.has("verification")) {
    const TomlTable verification(root.table("verification"), "[verification]", {"resolution"});
    if (verification.has("resolution")) {
      job.resolution_mm = verification.length_or_auto_mm("resolution");
      if (job.resolution_mm) part_length_mm(verification, "resolution", job.part_lengths);
    }
  }
  if (root.has("report")) {
    const TomlTable report(root.table("report"), "[report]", {"pictures", "stock"});
    if (report.has("pictures")) job.pictures = report.boolean("pictures");
    if (report.has("stock")) job.stock_surface = stock_surface_of(report);
  }
}

bool is_plain_name(std::string_view name) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '_' || c == '-';
  };
  return !name.empty() && name.size() <= 100 && name.front() != '.' && name.front() != '-' &&
         std::all_of(name.begin(), name.end(), plain);
}

toml::table merged_job(const std::string& text, const std::string& name_in_errors,
                       std::span<const std::string> overrides) {
  toml::table table = parse_toml(text, name_in_errors);
  apply_overrides(table, overrides);
  return table;
}

Job read_merged_job(const toml::table& table, JobContext context) {
  return read_root(table, context);
}

Job read_job_text(const std::string& text, const std::string& name_in_errors,
                  const std::filesystem::path& folder, std::span<const std::string> overrides) {
  return read_merged_job(merged_job(text, name_in_errors, overrides), {folder, {}, {}, {}, {}});
}

Job read_job(const std::filesystem::path& file, std::span<const std::string> overrides) {
  Job job =
      read_job_text(model::read_text_file(file), file.string(), file.parent_path(), overrides);
  job.sources.push_back({JobFile::Role::job, file, file.string()});
  job.overrides.assign(overrides.begin(), overrides.end());
  return oriented(std::move(job));
}

}  // namespace limitgauge::app
