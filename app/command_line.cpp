#include "app/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include "app/nearest_key.h"

namespace limitgauge::app {
namespace {

constexpr const char* kExitCodes =
    "Exit codes: 0 every gate passes, 1 a gate fails, 2 a gate is indeterminate, 3 bad input or "
    "usage,\n4 out of resources, interrupted or internal error.";
constexpr std::array<std::string_view, 4> kCommands = {"run", "plan", "verify", "inspect"};
constexpr std::array<std::string_view, 4> kLaterCommands = {"compare", "study", "history", "view"};

/// What CLI11 fills in; turned into a CommandLine when all is well.
struct Parsed {
  CommonOptions common;
  int threads = 0;
  RunCommand run;
  PlanCommand plan;
  VerifyCommand verify;
  InspectCommand inspect;
  CLI::App* run_app = nullptr;
  CLI::App* plan_app = nullptr;
  CLI::App* verify_app = nullptr;
  CLI::App* inspect_app = nullptr;
};

void add_common(CLI::App& app, Parsed& parsed) {
  CommonOptions& common = parsed.common;
  app.add_option("--threads", parsed.threads, "Threads to use (default: all)")
      ->check(CLI::Range(1, 4096));
  app.add_flag("--quiet", common.quiet, "No table, no progress: errors only");
  app.add_flag("--verbose", common.verbose, "Say how long each stage took");
  app.add_flag("--no-pictures", common.no_pictures, "Write no pictures");
  app.add_flag("--force", common.force, "Overwrite a finished output folder");
  app.add_option("--set", common.overrides,
                 "Override a key of the job: stage.finish.step=0.2 (repeatable)")
      ->allow_extra_args(false);
}

void add_run(CLI::App& app, Parsed& parsed) {
  parsed.run_app = app.add_subcommand("run", "Plan, cut, verify, gate and report a job");
  parsed.run_app->add_option("JOB", parsed.run.job, "Job file (TOML)")->required();
  parsed.run_app->add_option("-o,--output", parsed.run.output,
                             "Output folder (default: limitgauge-out/NAME)");
  add_common(*parsed.run_app, parsed);
}

void add_plan(CLI::App& app, Parsed& parsed) {
  parsed.plan_app = app.add_subcommand("plan", "Toolpaths of a job only: G-code and .vtp");
  parsed.plan_app->add_option("JOB", parsed.plan.job, "Job file (TOML)")->required();
  parsed.plan_app->add_option("-o,--output", parsed.plan.output,
                              "Output folder (default: limitgauge-out/NAME-plan)");
  add_common(*parsed.plan_app, parsed);
}

CLI::Validator number_above_zero(bool or_zero) {
  return CLI::Validator(
      [or_zero](const std::string& text) {
        const double value = std::strtod(text.c_str(), nullptr);
        if (std::isfinite(value) && (value > 0 || (or_zero && value == 0))) return "";
        return or_zero ? "is no number from zero up" : "is no number above zero";
      },
      or_zero ? "NUMBER>=0" : "NUMBER>0");
}

CLI::Validator finite_number() {
  return CLI::Validator(
      [](const std::string& text) {
        return std::isfinite(std::strtod(text.c_str(), nullptr)) ? "" : "is no number";
      },
      "NUMBER");
}

void add_limit(CLI::App& app, const std::string& option, double& value, bool& stated,
               const std::string& help) {
  app.add_option_function<double>(
         option,
         [&value, &stated](const double& limit) {
           value = limit;
           stated = true;
         },
         help)
      ->check(number_above_zero(false));
}

void add_machine(CLI::App& app, MachineOptions& machine) {
  app.add_option("--work-offset", machine.work_offsets,
                 "G54=X,Y,Z or G54=X,Y,Z,TURN: origin of a work offset on the machine, mm and "
                 "degrees (repeatable)")
      ->allow_extra_args(false);
  app.add_option("--home", machine.home, "X,Y,Z: the machine's reference point, where G28 goes");
  app.add_option("--second-home", machine.second_home, "X,Y,Z: where G30 goes");
  app.add_option("--tool-table", machine.tool_table,
                 "Lengths and diameters of the tools: LinuxCNC's tool table, mm");
}

void add_verify(CLI::App& app, Parsed& parsed) {
  VerifyCommand& verify = parsed.verify;
  parsed.verify_app = app.add_subcommand("verify", "Verify a G-code program without a job file");
  CLI::App& sub = *parsed.verify_app;
  sub.add_option("--cage", verify.cage, "Cage of the design (OBJ)")->required();
  sub.add_option(
         "--stock", verify.stock,
         "box:LX,LY,LZ@X,Y,Z (size @ lower corner), mm; mesh:FILE (STL, OBJ, PLY); vdb:FILE "
         "(stock of an earlier run)")
      ->required();
  sub.add_option("--tool", verify.tools,
                 "ball:D=6 | flat:D=8 | bull:D=8,r=1 | taper:D=1,r=0.5,angle=5 | "
                 "drill:D=6,angle=118 | apt:D=10,r=1,a=5,b=-10; with L= flute length, ramp= "
                 "steepest descent, shank=D:L, holder=D:L from the tip up; "
                 "N=... for each T number of a program with several (repeatable)")
      ->required()
      ->allow_extra_args(false);
  sub.add_option("--program", verify.program, "Program (G-code)")->required();
  sub.add_option("--allowance", verify.allowance_mm, "Material to be left (default: 0 mm)")
      ->check(number_above_zero(true));
  sub.add_option("--fixture", verify.fixtures,
                 "Mesh that nothing of the tool may touch: STL, OBJ, PLY (repeatable)")
      ->allow_extra_args(false);
  sub.add_option("--near-miss", verify.near_miss_mm,
                 "List what passes stock or fixtures within this, mm (default: not looked for)")
      ->check(number_above_zero(false));
  add_machine(sub, verify.machine);
  sub.add_option("--program-offset", verify.program_offset,
                 "X,Y,Z: the program's zero in the cage's frame, mm (default: 0,0,0)");
  sub.add_option("--program-rotation", verify.program_rotation_deg,
                 "Turn of the program's frame about Z against the cage's, degrees (default: 0)")
      ->check(finite_number());
  add_limit(sub, "--gouge", verify.limits.gouge_mm, verify.limits.has_gouge,
            "Largest gouge that passes, mm (default: measured, not gated)");
  add_limit(sub, "--uncut", verify.limits.uncut_mm, verify.limits.has_uncut,
            "Largest uncut that passes, mm (default: measured, not gated)");
  sub.add_option("-o,--output", verify.output,
                 "Output folder (default: limitgauge-out/NAME of the program)");
  add_common(sub, parsed);
}

void add_inspect(CLI::App& app, Parsed& parsed) {
  InspectCommand& inspect = parsed.inspect;
  parsed.inspect_app = app.add_subcommand("inspect", "What a cage or a program is");
  CLI::App& sub = *parsed.inspect_app;
  sub.add_option("FILE", inspect.file, "Cage (.obj) or program")->required();
  CLI::Option* samples =
      sub.add_option("--samples", inspect.samples, "N: reference points at N x N parameters a face")
          ->check(CLI::Range(2, 10000));
  CLI::Option* csv = sub.add_option("--csv", inspect.csv, "Where to write the reference points");
  samples->needs(csv);
  csv->needs(samples);
  sub.add_flag("--moves", inspect.moves, "The program's canonical moves, one a line, mm")
      ->excludes(samples);
  add_machine(sub, inspect.machine);
  add_common(sub, parsed);
}

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  return result.append(text) + "\"";
}

/// A word that is no command, before the library says so in its own way.
void refuse_unknown_command(int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  const std::string_view word = argv[1];
  if (std::find(kCommands.begin(), kCommands.end(), word) != kCommands.end()) return;
  if (std::find(kLaterCommands.begin(), kLaterCommands.end(), word) != kLaterCommands.end()) {
    throw UsageError("the command " + in_quotes(word) +
                     " is not in this release; expected run, plan, verify or inspect");
  }
  throw UsageError("unknown command " + in_quotes(word) + "; expected " +
                   in_quotes(nearest_key(word, kCommands)) + " or another of run, plan, verify, " +
                   "inspect");
}

void complete(Parsed& parsed) {
  const unsigned all = std::max(1U, std::thread::hardware_concurrency());
  parsed.common.threads = parsed.threads > 0 ? static_cast<unsigned>(parsed.threads) : all;
  const bool has_job = parsed.run_app->parsed() || parsed.plan_app->parsed();
  if (!has_job && !parsed.common.overrides.empty()) {
    throw UsageError(
        "--set overrides a key of a job and this command reads none; "
        "expected it with run or plan");
  }
  if (parsed.common.quiet && parsed.common.verbose) {
    throw UsageError("--quiet and --verbose contradict each other; expected one of them");
  }
}

Command chosen(const Parsed& parsed) {
  if (parsed.run_app->parsed()) return parsed.run;
  if (parsed.plan_app->parsed()) return parsed.plan;
  if (parsed.verify_app->parsed()) return parsed.verify;
  return parsed.inspect;
}

std::string help_of(const CLI::App& app, const Parsed& parsed) {
  for (const CLI::App* sub :
       {parsed.run_app, parsed.plan_app, parsed.verify_app, parsed.inspect_app}) {
    if (sub->parsed()) return sub->help("limitgauge " + sub->get_name());
  }
  return app.help();
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  refuse_unknown_command(argc, argv);
  CLI::App app("Simulates, measures and gates toolpaths against an exact limit surface.",
               "limitgauge");
  app.set_version_flag("--version", "limitgauge " LIMITGAUGE_VERSION);
  app.require_subcommand(1);
  app.footer(kExitCodes);
  Parsed parsed;
  add_run(app, parsed);
  add_plan(app, parsed);
  add_verify(app, parsed);
  add_inspect(app, parsed);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return {PrintCommand{help_of(app, parsed)}, {}};
  } catch (const CLI::CallForVersion& version) {
    return {PrintCommand{std::string(version.what()) + "\n"}, {}};
  } catch (const CLI::ParseError& error) {
    throw UsageError(std::string(error.what()) + "; see limitgauge --help");
  }
  complete(parsed);
  return {chosen(parsed), parsed.common};
}

}  // namespace limitgauge::app
