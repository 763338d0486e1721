#include "app/command_definition.h"

namespace limitgauge::app {

void CommandDefinition::add_compare() {
  CompareCommand& compare = parsed_.compare;
  CLI::App& sub = *app_.add_subcommand("compare", "Compare a result with an earlier one");
  file(sub.add_option("BASE", compare.base, "result.json to hold against, or its folder"), "json")
      ->required();
  file(sub.add_option("NEW", compare.now, "result.json to judge, or its folder"), "json")
      ->required();
  folder(sub.add_option("-o,--output", compare.output,
                        "Folder for compare.html, compare.md and compare.json (default: none)"));
  add_common(sub);
  hide_unused(sub);
}

}  // namespace limitgauge::app
