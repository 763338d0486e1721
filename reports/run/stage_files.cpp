#include <functional>
#include <stdexcept>
#include <vector>

#include "model/base/chunks.h"
#include "model/base/memory.h"
#include "model/base/output_file.h"
#include "reports/picture/deviation_map.h"
#include "reports/picture/perspective_picture.h"
#include "reports/picture/png.h"
#include "reports/picture/stock_picture.h"
#include "reports/picture/tool_side.h"
#include "reports/run/report.h"
#include "reports/vtk/vtp.h"

namespace limitgauge::reports {
namespace {

constexpr int kStockPictureWidth = 1000;

/// Nothing where there is no picture.
void write_picture(const std::string& bytes, const std::filesystem::path& file) {
  if (!bytes.empty()) model::write_file(file, bytes);
}

/// A stage's name becomes a folder: it must not lead anywhere else.
std::filesystem::path plain_name(const std::string& name) {
  const std::filesystem::path path(name);
  if (name.empty() || name == "." || name == ".." || path.filename() != path)
    throw std::invalid_argument("stage name is no folder name: " + name);
  return path;
}

bool has_field(const StageResult& stage) {
  return stage.ran->deviation && !stage.ran->deviation->field.quads.empty();
}

std::string deviation_png(const StageResult& stage) {
  if (!has_field(stage)) return {};
  const ToolSide side(stage);
  return png_bytes(draw_deviation_picture(side.deviation(), stage.limits));
}

std::string perspective_png(const StageResult& stage) {
  if (!has_field(stage)) return {};
  return png_bytes(draw_perspective_picture(stage));
}

/// As it lies in the stage's setup.
std::string stock_png(const simulator::StockMesh& mesh, const StageResult& stage) {
  if (mesh.triangles.empty()) return {};
  const model::Pose &from_part = stage.setup.from_part, &to_part = stage.ran->stock_to_part;
  if (from_part.inverse() == to_part)
    return png_bytes(draw_stock_picture(mesh, kStockPictureWidth, from_part));
  return png_bytes(
      draw_stock_picture(turned(mesh, from_part * to_part), kStockPictureWidth, from_part));
}

}  // namespace

StagePictures draw_pictures(const StageResult& stage, const model::RunControl& control) {
  if (!stage.ran) return {};
  StagePictures pictures{deviation_png(stage), perspective_png(stage), {}};
  if (stage.ran->stock)
    pictures.stock_png = stock_png(stage.ran->stock->surface(control).mesh, stage);
  return pictures;
}

namespace {

using Job = std::function<void()>;

/// Side by side: most of a file's time is its compression, which has no threads of its own.
void carry_out(const std::vector<Job>& jobs, const model::RunControl& control) {
  model::parallel_for(jobs.size(), control.threads, [&](std::size_t k) {
    control.check();
    jobs[k]();
  });
}

/// The stock's surface as it lies in a setup, and how that lies in the part's frame, which the
/// files are in.
struct PlacedSurface {
  const simulator::StockMesh& mesh;
  model::Pose to_part;
};

void write_surface(const StageRun& ran, const PlacedSurface& surface,
                   const std::filesystem::path& file, const StageFileOptions& options,
                   std::span<const Fact> facts) {
  const auto write = [&](const simulator::StockMesh& mesh) {
    if (surface.to_part == model::Pose{}) return write_stock_vtp(mesh, file, facts);
    write_stock_vtp(turned(mesh, surface.to_part), file, facts);
  };
  if (options.stock == StockSurfaceFile::none) return;
  if (options.stock == StockSurfaceFile::whole) return write(surface.mesh);
  // Nothing was cut: a file without a triangle says so.
  write(ran.stock->cut_part_of(surface.mesh, options.control));
}

/// The path where the files and the page have it: in the part's frame.
std::shared_ptr<const model::Toolpath> path_of(const StageRun& ran, const model::Pose& to_part) {
  if (to_part == model::Pose{}) return ran.path;
  return std::make_shared<const model::Toolpath>(turned(*ran.path, to_part));
}

std::optional<model::ToolAxes> axes_of(const StageRun& ran, const model::Pose& to_part) {
  return ran.axes ? std::optional(turned(*ran.axes, to_part)) : std::nullopt;
}

page::StockView placed(page::StockView view, const model::Pose& to_part) {
  if (to_part != model::Pose{}) view.mesh = turned(std::move(view.mesh), to_part);
  return view;
}

}  // namespace

StageFiles write_stage_files(const StageResult& stage, const std::filesystem::path& folder,
                             const StageFileOptions& options) {
  if (!stage.ran) return {};
  const StageRun& ran = *stage.ran;
  const std::filesystem::path into = folder / plain_name(stage.name);
  model::make_folder(into);
  const std::vector<Fact> facts = stage_facts(stage);
  const model::Pose to_part = stage.setup.from_part.inverse();
  StageFiles files;
  StagePictures& pictures = files.pictures;
  simulator::StockSurface surface;
  if (ran.stock) {
    surface = ran.stock->surface(options.control);
    files.surface = {surface.mesh.vertices.size(), surface.mesh.triangles.size(), surface.voxel_mm,
                     surface.unmoved};
    // The mesh's cells, and below what a picture took, would lie beside the file of the mesh, with
    // which a run is at its peak.
    model::return_freed_memory();
  }
  std::vector<Job> jobs;
  // The one that takes most room, and the others after each other.
  if (options.pictures) {
    jobs.push_back([&] {
      pictures.perspective_png = perspective_png(stage);
      model::return_freed_memory();
    });
    jobs.push_back([&] {
      pictures.deviation_png = deviation_png(stage);
      if (ran.stock) pictures.stock_png = stock_png(surface.mesh, stage);
      model::return_freed_memory();
    });
  }
  if (ran.stock) {
    jobs.push_back([&] {
      write_surface(ran, {surface.mesh, ran.stock_to_part}, into / "stock.vtp", options, facts);
    });
    jobs.push_back([&] { ran.stock->write_vdb(into / "stock.vdb", ran.stock_to_part); });
  }
  // Beside a design the page shows the surface, and what stands on it.
  if (ran.stock && !ran.deviation && !options.design)
    jobs.push_back([&] {
      files.stock_view =
          placed(page::stock_view(*ran.stock, surface.mesh, options.passes,
                                  {options.control.threads, options.control.stop, {}}),
                 ran.stock_to_part);
    });
  if (ran.deviation)
    jobs.push_back(
        [&] { write_deviation_vtp(ran.deviation->field, into / "deviation.vtp", facts); });
  if (ran.path) {
    jobs.push_back([&] {
      const auto path = path_of(ran, to_part);
      const auto axes = axes_of(ran, to_part);
      write_toolpath_vtp(*path, into / "toolpath.vtp", ran.removal.moves, facts,
                         axes ? &*axes : nullptr);
      page::PathViewOptions view{options.rapid_mm_min, ran.machining_time_s};
      if (axes) view.axes = &*axes;
      files.path_view = page::path_view(*path, ran.removal.moves, view);
    });
  }
  carry_out(jobs, options.control);
  write_picture(pictures.deviation_png, into / "deviation.png");
  write_picture(pictures.perspective_png, into / "perspective.png");
  write_picture(pictures.stock_png, into / "stock.png");
  return files;
}

}  // namespace limitgauge::reports
