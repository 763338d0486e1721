#include "app/cli/command_definition.h"
#include "app/cli/option_checks.h"

namespace limitgauge::app {

void CommandDefinition::add_probe() {
  ProbeCommand& probe = parsed_.probe;
  CLI::App& sub = *app_.add_subcommand("probe", "Hold measured points against a result's stock");
  file(sub.add_option("RESULT", probe.result, "result.json in its folder, or that folder"), "json")
      ->required();
  file(sub.add_option("POINTS", probe.points,
                      "Measured points, mm: a table with columns x, y, z and, where it is known, "
                      "u_mm, the standard uncertainty of each"),
       "csv")
      ->required();
  folder(sub.add_option("-o,--output", probe.output,
                        "Folder for probe.html, probe.csv and probe.json (default: "
                        "limitgauge-out/NAME-probe of the points' file)"));
  hint(sub.add_option("--stage", probe.stage,
                      "Stage after which the part was measured (default: the last that ran)"),
       "NAME");
  file(sub.add_option("--stock", probe.stock,
                      "The raw stock's file, where the job took it from one"));
  hint(sub.add_option("--residual", probe.residual_mm,
                      "Largest residual as measured that passes, two standard uncertainties on the "
                      "safe side, mm (default: measured, not gated)"),
       "MM")
      ->check(length(false));
  add_common(sub);
  hide_unused(sub);
  offer_json(sub, "Print what probe.json holds instead of the table");
  for (const char* name : {"--threads", "--force"})
    sub.get_option(name)->group(sub.get_option("--quiet")->get_group());
}

}  // namespace limitgauge::app
