#include "app/cli/command_definition.h"
#include "app/cli/option_checks.h"
#include "reports/compare/comparison.h"

namespace limitgauge::app {
namespace {

std::vector<std::string> judged_names() {
  std::vector<std::string> names;
  for (const std::string_view id : reports::compare::judged_ids()) names.emplace_back(id);
  return names;
}

}  // namespace

void CommandDefinition::add_compare() {
  CompareCommand& compare = parsed_.compare;
  CLI::App& sub = *app_.add_subcommand("compare", "Compare a result with an earlier one");
  file(sub.add_option("BASE", compare.base, "result.json to hold against, or its folder"), "json")
      ->required();
  file(sub.add_option("NEW", compare.now, "result.json to judge, or its folder"), "json")
      ->required();
  folder(sub.add_option("-o,--output", compare.output,
                        "Folder for compare.html, .md and .json and junit.xml (default: none)"));
  hint(sub.add_option("--time-limit", compare.time_limit_percent,
                      "Machining time that grows by more than this is a regression (default: it "
                      "is shown)"),
       "PERCENT")
      ->check(number_above_zero(true));
  const ValueHint of_metric{ValueHint::Kind::text, {}, judged_names()};
  hint(sub.add_option("--metric", compare.metrics,
                      "Judge this figure and no other, as result.json names it; repeatable"),
       "NAME", of_metric)
      ->allow_extra_args(false);
  hint(sub.add_option("--ignore", compare.ignored, "Do not judge this figure; repeatable"), "NAME",
       of_metric)
      ->allow_extra_args(false);
  add_common(sub);
  hide_unused(sub);
  sub.get_option("--verbose")->group("Options")->description("List every figure");
  offer_json(sub, "Print what compare.json holds instead of the table");
  sub.get_option("--force")->group("Options");
}

}  // namespace limitgauge::app
