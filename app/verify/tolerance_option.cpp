#include "app/verify/tolerance_option.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "app/cli/usage_error.h"
#include "app/job/machine_options.h"
#include "model/base/coordinate_limit.h"
#include "model/text/number_text.h"
#include "verifier/robust/certifiable.h"

namespace limitgauge::app {
namespace {

constexpr const char* kExpected =
    "; expected zero=X,Y,Z, N:radius=R,length=L, path=P, runout=R or positioning=X,Y,Z, half "
    "widths in mm (0.005 is ±0.005)";

[[noreturn]] void refuse(const std::string& option, const std::string& wrong) {
  throw UsageError("--tolerance " + option + ": " + wrong + kExpected);
}

/// What was stated before: a second value would leave one of both out.
using Stated = std::set<std::string>;

void note(const std::string& option, const std::string& figure, Stated& stated) {
  if (!stated.insert(figure).second) refuse(option, "\"" + figure + "\" a second time");
}

double half_width(const std::string& option, const std::string& text) {
  const std::optional<double> value = model::parse_number(text);
  if (!value || !(*value >= 0) || !model::is_near(*value))
    refuse(option, "\"" + text + "\" is no half width");
  return *value;
}

model::Vec3 half_widths(const std::string& option, const std::string& text) {
  const model::Vec3 half = point_of("--tolerance " + option.substr(0, option.find('=') + 1), text);
  for (int axis = 0; axis < 3; ++axis)
    if (!(half[axis] >= 0)) refuse(option, "a half width is not negative");
  return half;
}

const JobTool& tool_meant(const std::string& option, std::string& figures,
                          std::span<const JobTool> tools) {
  const std::size_t colon = figures.find(':');
  if (colon == std::string::npos) {
    if (tools.size() != 1) refuse(option, "there are several tools, and none is named");
    return tools.front();
  }
  const std::string number = figures.substr(0, colon);
  figures.erase(0, colon + 1);
  const auto found = std::find_if(tools.begin(), tools.end(), [&](const JobTool& tool) {
    return tool.number && std::to_string(*tool.number) == number;
  });
  if (found == tools.end()) refuse(option, "no --tool has the number \"" + number + "\"");
  return *found;
}

void read_figure(const std::string& option, const std::string& figure, model::ToolTolerance& tool,
                 const std::string& of_tool, Stated& stated) {
  const std::size_t equals = figure.find('=');
  if (equals == std::string::npos) refuse(option, "\"" + figure + "\" has no value");
  const std::string name = figure.substr(0, equals);
  note(option, of_tool + name, stated);
  const model::Interval range = model::about_zero(half_width(option, figure.substr(equals + 1)));
  if (name == "radius")
    tool.radius_mm = range;
  else if (name == "length")
    tool.length_mm = range;
  else if (name == "corner_radius")
    tool.corner_radius_mm = range;
  else if (name == "flat")
    tool.flat_mm = range;
  else
    refuse(option, "there is no figure \"" + name + "\"");
}

void read_tool(const std::string& option, std::span<const JobTool> tools, model::Tolerances& out,
               Stated& stated) {
  std::string figures = option;
  const JobTool& tool = tool_meant(option, figures, tools);
  model::ToolTolerance& tolerance = out.tools[tool.cutter.id];
  for (std::size_t at = 0; at <= figures.size();) {
    const std::size_t end = std::min(figures.find(',', at), figures.size());
    read_figure(option, figures.substr(at, end - at), tolerance, tool.cutter.id + ".", stated);
    at = end + 1;
  }
}

void read_option(const std::string& option, std::span<const JobTool> tools, model::Tolerances& out,
                 Stated& stated) {
  const std::size_t equals = option.find('=');
  const std::string name = option.substr(0, equals);
  if (equals == std::string::npos) refuse(option, "no value");
  const std::string value = option.substr(equals + 1);
  if (name == "path") {
    out.path_mm = half_width(option, value);
  } else if (name == "runout") {
    out.runout_mm = half_width(option, value);
  } else if (name == "positioning") {
    out.positioning_mm = half_widths(option, value);
  } else if (name == "zero") {
    const model::Vec3 half = half_widths(option, value);
    for (int axis = 0; axis < 3; ++axis) out.zero_mm[axis] = model::about_zero(half[axis]);
  } else {
    return read_tool(option, tools, out, stated);
  }
  note(option, name, stated);
}

}  // namespace

model::Tolerances tolerances_of(std::span<const std::string> options,
                                std::span<const JobTool> tools) {
  model::Tolerances out;
  Stated stated;
  for (const std::string& option : options) read_option(option, tools, out, stated);
  for (const JobTool& tool : tools) try {
      verifier::require_certifiable(out, tool.cutter);
    } catch (const std::invalid_argument& error) {
      throw UsageError(std::string("--tolerance: ") + error.what());
    }
  return out;
}

}  // namespace limitgauge::app
