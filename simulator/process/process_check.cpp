#include "simulator/process/process_check.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <tuple>

#include "model/base/chunks.h"
#include "simulator/instrument/stock_check.h"
#include "simulator/process/axes_check.h"
#include "simulator/process/carried_check.h"
#include "simulator/process/clearance_map.h"
#include "simulator/process/fixture_check.h"
#include "simulator/process/gap_search.h"
#include "simulator/process/tool_bodies.h"
#include "simulator/stock/material.h"
#include "simulator/sweep/sweep_index.h"

namespace limitgauge::simulator {
namespace {

using model::Box3;
using model::Toolpath;
using model::Vec3;

constexpr std::size_t kChunk = 64;

void require_limits(const ProcessLimits& limits) {
  require_contact_limits(limits);
  for (int a = 0; limits.travel_mm && a < 3; ++a)
    if (!(limits.travel_mm->low[a] <= limits.travel_mm->high[a]))
      throw std::invalid_argument("the travel of an axis ends below where it begins");
}

// How far above the tip material may stand on some move of the path.
double height_of_material(const StockModel& before, const Toolpath& path) {
  double lowest = path.start.z;
  for (const model::Move& m : path.moves) lowest = std::min(lowest, m.to.z);
  return bounding_box(before.material().raw()).high.z - lowest;
}

void look_at_travel(const Box3& travel, const Toolpath& path, std::size_t i,
                    std::vector<Finding>& findings) {
  const Vec3& to = path.moves[i].to;
  if (travel.contains(to)) return;
  Finding f{FindingKind::beyond_travel, i, path.moves[i].line, to, 0, name(ToolPart::cutter), ""};
  for (int a = 0; a < 3; ++a) {
    if (travel.low[a] - to[a] > f.depth_mm)
      f.depth_mm = travel.low[a] - to[a], f.against = travel_limit_name(a, false);
    if (to[a] - travel.high[a] > f.depth_mm)
      f.depth_mm = to[a] - travel.high[a], f.against = travel_limit_name(a, true);
  }
  findings.push_back(f);
}

bool is_contact(FindingKind kind) {
  return kind == FindingKind::rapid_through_stock || kind == FindingKind::shank_in_stock ||
         kind == FindingKind::holder_in_stock || kind == FindingKind::below_flutes ||
         kind == FindingKind::fixture_touched;
}

int rank(const std::string& part) {
  return part == name(ToolPart::cutter) ? 0 : part == name(ToolPart::shank) ? 1 : 2;
}

// Of one move: near misses and slight contacts of what is touched are left out, and of each kind,
// part and body that is met the worst is kept, of equal ones the first.
void tidy(std::vector<Finding>& findings) {
  if (findings.size() < 2) return;
  const auto leave_out = [&](FindingKind kind, const auto& counts) {
    std::vector<std::string> touched;
    for (const Finding& f : findings)
      if (counts(f.kind)) touched.push_back(f.against);
    std::erase_if(findings, [&](const Finding& f) {
      return f.kind == kind &&
             std::find(touched.begin(), touched.end(), f.against) != touched.end();
    });
  };
  leave_out(FindingKind::near_miss, [](FindingKind kind) {
    return is_contact(kind) || kind == FindingKind::slight_contact;
  });
  leave_out(FindingKind::slight_contact, is_contact);
  std::ranges::stable_sort(
      findings, {}, [](const Finding& f) { return std::tuple(f.kind, rank(f.part), -f.depth_mm); });
  std::vector<Finding> worst;
  for (Finding& f : findings)
    if (std::ranges::none_of(worst, [&](const Finding& w) {
          return std::tie(w.kind, w.part, w.against) == std::tie(f.kind, f.part, f.against);
        }))
      worst.push_back(std::move(f));
  findings = std::move(worst);
}

std::vector<Finding> joined(std::vector<std::vector<Finding>> chunks) {
  std::vector<Finding> all;
  for (std::vector<Finding>& chunk : chunks)
    all.insert(all.end(), std::make_move_iterator(chunk.begin()),
               std::make_move_iterator(chunk.end()));
  return all;
}

/// Both are in the order of moves; the tool's own findings of a move come first.
std::vector<Finding> with_carried(std::vector<Finding> findings, std::vector<Finding> carried) {
  if (carried.empty()) return findings;
  std::vector<Finding> all;
  std::ranges::merge(std::move(findings), std::move(carried), std::back_inserter(all), {},
                     &Finding::move, &Finding::move);
  return all;
}

}  // namespace

namespace {

/// All moves, each by `look(i, findings)`.
template <class Look>
std::vector<Finding> each_move(const Toolpath& path, const ProcessLimits& limits, const Look& look,
                               const model::RunControl& control) {
  const std::size_t moves = path.moves.size(), chunks = model::chunk_count(moves, kChunk);
  std::vector<std::vector<Finding>> found(chunks);
  std::atomic<std::size_t> done = 0;
  model::parallel_chunks(moves, kChunk, control, [&](std::size_t begin, std::size_t end) {
    std::vector<Finding>& all = found[begin / kChunk];
    std::vector<Finding> of_move;
    for (std::size_t i = begin; i < end; ++i) {
      of_move.clear();
      look(i, of_move);
      if (limits.travel_mm) look_at_travel(*limits.travel_mm, path, i, of_move);
      tidy(of_move);
      std::move(of_move.begin(), of_move.end(), std::back_inserter(all));
    }
    control.report(static_cast<double>(++done) / static_cast<double>(chunks));
  });
  return joined(std::move(found));
}

}  // namespace

std::vector<Finding> check_process(const StockModel& before, const Pass& pass,
                                   const ProcessLimits& limits, const model::RunControl& control) {
  require_limits(limits);
  require_path(pass);
  if (pass.pose != model::Pose{})
    throw std::invalid_argument("a process is checked in its own setup, where cutters are upright");
  const Toolpath& path = *pass.path;
  if (pass.axes && !limits.carried.empty())
    throw std::invalid_argument("carried bodies are not looked at while a tool turns as it goes");
  if (pass.axes) {
    const AxesCheck axes(before, pass, limits, control);
    const auto look = [&](std::size_t i, std::vector<Finding>& findings) {
      axes.look_at(i, control, findings);
    };
    return each_move(path, limits, look, control);
  }
  const ToolBodies bodies(pass.cutter, height_of_material(before, path));
  const StockLimits depths{limits.tolerance_mm, limits.near_miss_mm};
  const StockCheck stock(before, pass, bodies, depths);
  const FixtureCheck fixtures(limits.fixtures, pass, bodies, depths);
  const auto look = [&](std::size_t i, std::vector<Finding>& findings) {
    stock.look_at(i, findings);
    fixtures.look_at(i, findings);
  };
  return with_carried(each_move(path, limits, look, control),
                      CarriedCheck(before, pass, limits).findings(control));
}

bool keeps_clear(const StockModel& stock, const Pass& pass, double clearance_mm,
                 const model::RunControl& control) {
  if (pass.axes) return false;
  const Toolpath& path = *pass.path;
  const CutterProfile flutes(pass.cutter);
  const ClearanceMap map(stock.grid().column_tops());
  const MaterialAtMove material{&stock.material()};
  std::atomic<bool> clear{true};
  model::parallel_chunks(
      path.moves.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && clear; ++i) {
          const SweptMove move(move_from(path, i), path.moves[i].to, static_cast<std::uint32_t>(i));
          if (map.clears(flutes, move, clearance_mm)) continue;
          if (least_gap(material, flutes, move, 2 * clearance_mm, clearance_mm, {})) clear = false;
        }
      });
  return clear;
}

}  // namespace limitgauge::simulator
