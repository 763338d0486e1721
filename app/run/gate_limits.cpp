#include "app/run/gate_limits.h"

#include "model/text/number_text.h"

namespace limitgauge::app {
namespace {

/// Without `unit` and the spaces before it; nothing where the text does not end in it.
std::optional<std::string_view> without_unit(std::string_view text, std::string_view unit) {
  if (!text.ends_with(unit)) return std::nullopt;
  text.remove_suffix(unit.size());
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

}  // namespace

bool set_unreachable(std::string_view text, verifier::GateLimits& limits) {
  std::optional<std::string_view> area = without_unit(text, "mm2");
  if (!area) area = without_unit(text, "mm²");
  const std::optional<double> value = model::parse_number(area.value_or(text));
  if (!value || !(*value >= 0) || (!area && *value > 1)) return false;
  limits.has_unreachable = true;
  limits.unreachable_is_share = !area;
  limits.unreachable = *value;
  return true;
}

std::string unreachable_text(const verifier::GateLimits& limits) {
  return model::shortest(limits.unreachable) + (limits.unreachable_is_share ? "" : " mm2");
}

}  // namespace limitgauge::app
