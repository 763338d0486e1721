#include "app/cli/command_definition.h"

#include <utility>

#include "app/cli/option_checks.h"
#include "app/run/gate_limits.h"

namespace limitgauge::app {
namespace {

CLI::Option* add_limit(CLI::App& app, const std::string& option, double& value, bool& stated,
                       const std::string& help) {
  return app.add_option_function<double>(
      option,
      [&value, &stated](const double& limit) {
        value = limit;
        stated = true;
      },
      help);
}

CLI::Option* add_unreachable(CLI::App& app, verifier::GateLimits& limits) {
  return app.add_option_function<std::string>(
      "--unreachable",
      [&limits](const std::string& text) {
        if (!set_unreachable(text, limits))
          throw CLI::ValidationError("--unreachable",
                                     "\"" + text + "\" is neither " + kUnreachableExpected);
      },
      "Largest part of the surface that no cutter used so far may reach: a share, or an area as "
      "12.5mm2 (default: measured, not gated)");
}

}  // namespace

CommandDefinition::CommandDefinition()
    : app_("Simulates, measures and gates toolpaths against an exact limit surface.",
           "limitgauge") {
  app_.set_help_flag("-h,--help", "Print this help");
  app_.set_version_flag("--version", "limitgauge " LIMITGAUGE_VERSION, "Print the version");
  app_.require_subcommand(1);
  add_run();
  add_plan();
  add_verify();
  add_cut();
  add_inspect();
  add_compare();
  add_probe();
  add_study();
  add_history();
  add_view();
}

CLI::Option* CommandDefinition::hint(CLI::Option* option, const std::string& value,
                                     ValueHint hint) {
  hints_[option] = std::move(hint);
  return option->type_name(value);
}

CLI::Option* CommandDefinition::file(CLI::Option* option, const std::string& extension) {
  return hint(option->check(not_empty()), "FILE", {ValueHint::Kind::file, extension, {}});
}

CLI::Option* CommandDefinition::folder(CLI::Option* option) {
  return hint(option->check(not_empty()), "DIR", {ValueHint::Kind::folder, {}, {}});
}

void CommandDefinition::add_common(CLI::App& sub) {
  CommonOptions& common = parsed_.common;
  hint(sub.add_option("--threads", parsed_.threads, "Threads to use (default: all)"), "N")
      ->check(whole_number(1, 4096));
  sub.add_flag("--quiet", common.quiet, "No table, no progress: errors only");
  sub.add_flag("--verbose", common.verbose, "Say how long each stage took");
  sub.add_flag("--json", common.json)->group("");
  sub.add_flag("--no-pictures", common.no_pictures, "Write no pictures");
  sub.add_flag("--force", common.force, "Overwrite a finished output folder");
  hint(
      sub.add_option("--set", common.overrides, "Override a key of the job: stage.finish.step=0.2"),
      "KEY=VALUE")
      ->allow_extra_args(false);
}

/// Of commands that have a result.
void CommandDefinition::offer_json(CLI::App& sub, const char* help) {
  sub.get_option("--json")->group("Options")->description(help);
}

/// Every command takes the common options; those that change nothing in it are not told of.
void CommandDefinition::hide_unused(CLI::App& sub) {
  for (const char* name : {"--threads", "--verbose", "--no-pictures", "--force", "--set"})
    sub.get_option(name)->group("");
}

void CommandDefinition::add_run() {
  CLI::App& sub = *app_.add_subcommand("run", "Plan, cut, verify, gate and report a job");
  file(sub.add_option("JOB", parsed_.run.job, "Job file (TOML)"), "toml")->required();
  folder(sub.add_option("-o,--output", parsed_.run.output,
                        "Output folder (default: limitgauge-out/NAME)"));
  add_history_options(sub, parsed_.run.history);
  add_engine(sub, parsed_.run.engine, "each stage is measured, piece by piece",
             "slurm: 16; local: one process");
  add_cache(sub, parsed_.run.engine, "pieces are exchanged on Slurm");
  add_common(sub);
  offer_json(sub, "Print result.json instead of the table");
}

void CommandDefinition::add_plan() {
  CLI::App& sub = *app_.add_subcommand("plan", "Toolpaths of a job only: G-code and .vtp");
  file(sub.add_option("JOB", parsed_.plan.job, "Job file (TOML)"), "toml")->required();
  folder(sub.add_option("-o,--output", parsed_.plan.output,
                        "Output folder (default: limitgauge-out/NAME-plan)"));
  add_common(sub);
}

void CommandDefinition::add_machine(CLI::App& sub, MachineOptions& machine) {
  std::vector<std::string> controls;
  for (const model::Control control : model::kControls) controls.emplace_back(name(control));
  hint(sub.add_option(
           "--control", machine.control,
           "Whose habits the program is read by: " + control_names() + " (default: linuxcnc)"),
       "NAME", {ValueHint::Kind::text, {}, controls});
  folder(sub.add_option("--subprograms", machine.subprograms,
                        "Folder with a file for each subprogram that M98 or G65 may call, as "
                        "O1000.nc (default: those of the program's own file only)"));
  hint(sub.add_option("--work-offset", machine.work_offsets,
                      "G54=X,Y,Z or G54=X,Y,Z,TURN: origin of a work offset on the machine, mm "
                      "and degrees; G54.1P7=X,Y,Z of Fanuc and Haas"),
       "OFFSET")
      ->allow_extra_args(false);
  hint(sub.add_option("--home", machine.home, "The machine's reference point, where G28 goes, mm"),
       "X,Y,Z");
  hint(sub.add_option("--second-home", machine.second_home, "Where G30 goes, mm"), "X,Y,Z");
  hint(sub.add_option("--start", machine.start,
                      "Where the tip stands before the first line, in the program's frame, mm "
                      "(default: verify, cut: its zero, above everything; inspect: 0,0,0)"),
       "X,Y,Z");
  file(sub.add_option("--tool-table", machine.tool_table,
                      "Lengths and diameters of the tools: LinuxCNC's tool table, mm"),
       "tbl");
}

void CommandDefinition::add_inputs(CLI::App& sub, CutCommand& command) {
  hint(sub.add_option("--stock", command.stock,
                      "box:LX,LY,LZ@X,Y,Z (size @ lower corner), mm; mesh:FILE (STL, OBJ, PLY); "
                      "vdb:FILE (stock of an earlier run)"),
       "STOCK", {ValueHint::Kind::text, {}, {"box:", "mesh:", "vdb:"}})
      ->required();
  hint(sub.add_option(
           "--tool", command.tools,
           "ball:D=6 | flat:D=8 | bull:D=8,r=1 | taper:D=1,r=0.5,angle=5 | "
           "drill:D=6,angle=118 | apt:D=10,r=1,a=5,b=-10,L=9; with L= flute length, ramp= "
           "steepest descent, shank=D:L, holder=D:L from the tip up; "
           "N=... for each T number of a program with several"),
       "TOOL",
       {ValueHint::Kind::text,
        {},
        {"ball:D=", "flat:D=", "bull:D=", "taper:D=", "drill:D=", "apt:D="}})
      ->required()
      ->allow_extra_args(false);
  file(sub.add_option("--program", command.program, "Program (G-code)"))->required();
  hint(sub.add_option("--tolerance", command.tolerances,
                      "What is not known, as half widths in mm: zero=X,Y,Z of the program's zero; "
                      "N:radius=R,length=L,corner_radius=C,flat=F of tool N (N: may be left out "
                      "where there is one); path=P, runout=R and positioning=X,Y,Z, which differ "
                      "from move to move (default: all is as stated)"),
       "TOLERANCE",
       {ValueHint::Kind::text, {}, {"zero=", "radius=", "path=", "runout=", "positioning="}})
      ->allow_extra_args(false);
  file(sub.add_option("--fixture", command.fixtures,
                      "Mesh that nothing of the tool may touch: STL, OBJ, PLY"))
      ->allow_extra_args(false);
  hint(sub.add_option("--near-miss", command.near_miss_mm,
                      "List what passes stock or fixtures within this, mm (default: not looked "
                      "for)"),
       "MM")
      ->check(length(false));
  hint(sub.add_option("--voxel", command.voxel_mm,
                      "Edge of the simulated stock's voxels, mm (default: chosen, and stated in "
                      "the report)"),
       "MM")
      ->check(length(false));
}

void CommandDefinition::add_placement(CLI::App& sub, CutCommand& command) {
  add_machine(sub, command.machine);
  hint(sub.add_option("--program-offset", command.program_offset,
                      "The program's zero in the stock's frame, mm (default: 0,0,0)"),
       "X,Y,Z");
  hint(sub.add_option("--program-rotation", command.program_rotation_deg,
                      "Turn of the program's frame about Z against the stock's, degrees "
                      "(default: 0)"),
       "DEGREES")
      ->check(angle());
  folder(sub.add_option("-o,--output", command.output,
                        "Output folder (default: limitgauge-out/NAME of the program)"));
  add_history_options(sub, command.history);
  add_common(sub);
  offer_json(sub, "Print result.json instead of the table");
}

void CommandDefinition::add_checks(CLI::App& sub) {
  VerifyCommand& verify = parsed_.verify;
  hint(sub.add_option("--allowance", verify.allowance_mm, "Material to be left (default: 0 mm)"),
       "MM")
      ->check(length(true));
  hint(add_limit(sub, "--gouge", verify.limits.gouge_mm, verify.limits.has_gouge,
                 "Largest gouge that passes, mm (default: measured, not gated)"),
       "MM")
      ->check(length(false));
  hint(add_limit(sub, "--uncut", verify.limits.uncut_mm, verify.limits.has_uncut,
                 "Largest uncut that passes, mm (default: measured, not gated)"),
       "MM")
      ->check(length(false));
  hint(add_limit(sub, "--coverage", verify.limits.coverage, verify.limits.has_coverage,
                 "Least share of the reachable area within both limits, 0 to 1 (default: "
                 "measured, not gated)"),
       "SHARE")
      ->check(share());
  hint(add_unreachable(sub, verify.limits), "SHARE");
  hint(add_limit(sub, "--unavoidable", verify.limits.unavoidable_mm, verify.limits.has_unavoidable,
                 "Largest uncut where nothing can reach, mm (default: measured, not gated)"),
       "MM")
      ->check(length(true));
}

void CommandDefinition::add_verify() {
  VerifyCommand& verify = parsed_.verify;
  CLI::App& sub = *app_.add_subcommand("verify", "Verify a G-code program without a job file");
  file(sub.add_option("--cage", verify.cage, "Cage of the design (OBJ)"), "obj");
  file(sub.add_option("--target", verify.target,
                      "The design as a triangle mesh, in place of --cage: STL, PLY or OBJ; its "
                      "facets are the truth"));
  add_inputs(sub, verify);
  add_checks(sub);
  add_placement(sub, verify);
}

void CommandDefinition::add_cut() {
  CLI::App& sub = *app_.add_subcommand("cut", "Cut a G-code program without a design");
  add_inputs(sub, parsed_.cut);
  add_placement(sub, parsed_.cut);
}

void CommandDefinition::add_inspect() {
  InspectCommand& inspect = parsed_.inspect;
  CLI::App& sub = *app_.add_subcommand("inspect", "What a cage or a program is");
  file(sub.add_option("FILE", inspect.file, "Cage (.obj) or program"))->required();
  CLI::Option* samples = hint(sub.add_option("--samples", inspect.samples,
                                             "Reference points at N x N parameters of each face"),
                              "N")
                             ->check(whole_number(2, 10000));
  CLI::Option* csv =
      file(sub.add_option("--csv", inspect.csv, "Where to write the reference points"), "csv");
  samples->needs(csv);
  csv->needs(samples);
  sub.add_flag("--moves", inspect.moves, "The program's canonical moves, one a line, mm")
      ->excludes(samples);
  add_machine(sub, inspect.machine);
  add_common(sub);
  hide_unused(sub);
}

void CommandDefinition::add_view() {
  ViewCommand& view = parsed_.view;
  CLI::App& sub = *app_.add_subcommand("view", "Open a finished report in the browser");
  folder(sub.add_option("DIR", view.folder,
                        "Output folder of a run, or its report.html; served on 127.0.0.1 until "
                        "Ctrl-C"))
      ->required();
  hint(sub.add_option("--port", view.port, "Port to serve it on (default: a free one)"), "N")
      ->check(whole_number(1, 65535));
  sub.add_flag("--no-browser", view.no_browser, "Open no browser, only serve");
  add_common(sub);
  hide_unused(sub);
}

OptionReference CommandDefinition::reference(const CLI::Option& option) const {
  OptionReference said;
  said.positional = option.get_positional();
  if (said.positional) said.names.push_back(option.get_name(true));
  for (const std::string& name : option.get_snames()) said.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) said.names.push_back("--" + name);
  said.required = option.get_required();
  const bool has_value = option.get_items_expected_max() > 0;
  said.repeatable = has_value && option.get_items_expected_max() > 1;
  if (has_value) said.value = option.get_type_name();
  said.summary = option.get_description();
  if (const auto found = hints_.find(&option); found != hints_.end()) said.hint = found->second;
  return said;
}

CommandReference CommandDefinition::reference(const CLI::App& app) const {
  CommandReference said{app.get_name(), app.get_description(), {}, {}};
  for (const CLI::Option* option : app.get_options())
    if (!option->get_group().empty()) said.options.push_back(reference(*option));
  const auto subs = app.get_subcommands([](const CLI::App*) { return true; });
  for (const CLI::App* sub : subs) said.commands.push_back(reference(*sub));
  return said;
}

CommandReference CommandDefinition::reference() const {
  return reference(app_);
}

}  // namespace limitgauge::app
