#include "app/cli/command_line.h"

#include "tests/support/catch.h"
#include "tests/support/messages.h"

namespace limitgauge::app {
namespace {

CommandLine parse(std::vector<const char*> words) {
  words.insert(words.begin(), "limitgauge");
  return parse_command_line(static_cast<int>(words.size()), words.data());
}

std::string error_of(const std::vector<const char*>& words) {
  return tests::message_of<UsageError>([&] { parse(words); });
}

TEST_CASE("run takes a job and the common options", "[unit][command_line]") {
  const CommandLine line = parse({"run", "a.toml", "-o", "out", "--threads", "3", "--set", "a=1",
                                  "--set", "b=[1, 2]", "--force", "--no-pictures", "--quiet"});
  const auto& run = std::get<RunCommand>(line.command);
  CHECK(run.job == "a.toml");
  CHECK(run.output == "out");
  CHECK(line.common.threads == 3);
  CHECK(line.common.overrides == std::vector<std::string>{"a=1", "b=[1, 2]"});
  CHECK(line.common.force);
  CHECK(line.common.no_pictures);
  CHECK(line.common.quiet);
}

TEST_CASE("run takes where its stages are measured", "[unit][command_line]") {
  const auto engine = [](std::vector<const char*> more) {
    more.insert(more.begin(), {"run", "a.toml"});
    const CommandLine line = parse(more);
    return std::get<RunCommand>(line.command).engine;
  };
  CHECK(engine({}).engine == "local");
  const EngineOptions slurm = engine({"--engine", "slurm", "--jobs", "64", "--cache", "shared",
                                      "--slurm-option=--mem=4G", "--retries", "1"});
  CHECK(slurm.engine == "slurm");
  CHECK(slurm.jobs == 64);
  CHECK(slurm.retries == 1);
  CHECK(slurm.cache == "shared");
  CHECK(slurm.slurm_options == std::vector<std::string>{"--mem=4G"});
  CHECK_THAT(error_of({"run", "a.toml", "--engine", "cloud"}), ContainsSubstring("--engine"));
}

TEST_CASE("threads default to all of them", "[unit][command_line]") {
  CHECK(parse({"plan", "a.toml"}).common.threads >= 1);
}

TEST_CASE("study takes minutes for tasks that do not come back", "[unit][command_line]") {
  const auto patience_min = [](std::vector<const char*> more) {
    more.insert(more.begin(), {"study", "s.toml"});
    const CommandLine line = parse(more);
    return std::get<StudyCommand>(line.command).slurm_patience_min;
  };
  CHECK(patience_min({}) == 8);
  CHECK(patience_min({"--slurm-patience", "0.5"}) == 0.5);
  for (const char* wrong : {"0", "-1", "nan", "soon"})
    CHECK_THAT(error_of({"study", "s.toml", "--slurm-patience", wrong}),
               ContainsSubstring("--slurm-patience"));
}

TEST_CASE("verify gates only what it is told", "[unit][command_line]") {
  const std::vector<const char*> words = {"verify",   "--cage",          "c.obj",
                                          "--stock",  "box:1,1,1@0,0,0", "--tool",
                                          "ball:D=6", "--program",       "p.ngc"};
  const CommandLine open_line = parse(words);
  const auto& open = std::get<VerifyCommand>(open_line.command);
  CHECK_FALSE(open.limits.has_gouge);
  CHECK_FALSE(open.limits.has_uncut);
  CHECK(open.allowance_mm == 0);
  std::vector<const char*> more = words;
  for (const char* word : {"--gouge", "0.01", "--uncut", "0.02", "--allowance", "0.2"}) {
    more.push_back(word);
  }
  const CommandLine gated_line = parse(more);
  const auto& gated = std::get<VerifyCommand>(gated_line.command);
  CHECK(gated.limits.has_gouge);
  CHECK(gated.limits.gouge_mm == 0.01);
  CHECK(gated.limits.uncut_mm == 0.02);
  CHECK(gated.allowance_mm == 0.2);
  more.back() = "-1";
  CHECK_THAT(error_of(more), ContainsSubstring("--allowance"));
}

TEST_CASE("verify gates coverage and what cannot be reached", "[unit][command_line]") {
  const auto limits = [](const char* unreachable) {
    const CommandLine line =
        parse({"verify", "--cage", "c.obj", "--stock", "box:1,1,1@0,0,0", "--tool", "ball:D=6",
               "--program", "p.ngc", "--uncut", "0.1", "--coverage", "0.99", "--unavoidable", "0",
               "--unreachable", unreachable});
    return std::get<VerifyCommand>(line.command).limits;
  };
  const verifier::GateLimits share = limits("0.05"), area = limits("12.5 mm2");
  CHECK(share.has_coverage);
  CHECK(share.coverage == 0.99);
  CHECK(share.has_unavoidable);
  CHECK(share.unavoidable_mm == 0);
  CHECK(share.has_unreachable);
  CHECK(share.unreachable_is_share);
  CHECK(share.unreachable == 0.05);
  CHECK_FALSE(area.unreachable_is_share);
  CHECK(area.unreachable == 12.5);
  for (const char* option : {"--coverage", "--unreachable", "--unavoidable"})
    for (const char* value : {"-1", "a", "nan", "1.5 m"}) {
      const std::string error =
          error_of({"verify", "--cage", "c.obj", "--stock", "box:1,1,1@0,0,0", "--tool", "ball:D=6",
                    "--program", "p.ngc", option, value});
      INFO(error);
      CHECK_THAT(error, ContainsSubstring(option));
    }
}

TEST_CASE("a coverage of nothing is refused", "[unit][command_line]") {
  const std::vector<std::string> words = {"verify",          "--cage",     "c.obj",    "--stock",
                                          "box:1,1,1@0,0,0", "--tool",     "ball:D=6", "--program",
                                          "p.ngc",           "--coverage", "0.9"};
  const auto with = [&](std::vector<std::string> more) {
    std::vector<const char*> all;
    for (const std::string& word : words) all.push_back(word.c_str());
    for (const std::string& word : more) all.push_back(word.c_str());
    return all;
  };
  CHECK_THAT(error_of(with({})),
             ContainsSubstring("--coverage: without a limit of gouge or uncut"));
  CHECK(std::get<VerifyCommand>(parse(with({"--gouge", "0.1"})).command).limits.has_coverage);
  CHECK(std::get<VerifyCommand>(parse(with({"--set", "stage.program.gate.uncut=1"})).command)
            .limits.has_coverage);
}

TEST_CASE("view takes a folder, a port and whether to open a browser", "[unit][command_line]") {
  const CommandLine plain_line = parse({"view", "out"});
  const auto& plain = std::get<ViewCommand>(plain_line.command);
  CHECK(plain.folder == "out");
  CHECK(plain.port == 0);
  CHECK_FALSE(plain.no_browser);
  const CommandLine stated_line = parse({"view", "--port", "8080", "--no-browser", "out"});
  const auto& stated = std::get<ViewCommand>(stated_line.command);
  CHECK(stated.port == 8080);
  CHECK(stated.no_browser);
}

TEST_CASE("the texts for manual and shells are printed", "[unit][command_line]") {
  for (const char* kind : {"man", "bash", "zsh", "fish"}) {
    const CommandLine line = parse({"--generate", kind});
    CHECK_THAT(std::get<PrintCommand>(line.command).text, ContainsSubstring("--verbose") ||
                                                              ContainsSubstring("-l verbose") ||
                                                              ContainsSubstring("\\-verbose"));
  }
}

TEST_CASE("usage that cannot be obeyed is refused", "[unit][command_line]") {
  CHECK_THAT(error_of({}), ContainsSubstring("subcommand"));
  CHECK_THAT(error_of({"run"}), ContainsSubstring("JOB is required"));
  CHECK_THAT(error_of({"rnu", "a.toml"}), ContainsSubstring("expected 'run'"));
  CHECK_THAT(error_of({"run", "a.toml", "--threads", "0"}), ContainsSubstring("--threads"));
  CHECK_THAT(error_of({"inspect", "c.obj", "--samples", "5"}), ContainsSubstring("--csv"));
  CHECK_THAT(error_of({"inspect", "c.obj", "--samples", "1", "--csv", "a.csv"}),
             ContainsSubstring("--samples"));
  CHECK_THAT(error_of({"inspect", "c.obj", "--set", "a=1"}), ContainsSubstring("--set"));
  CHECK_THAT(error_of({"run", "a.toml", "--quiet", "--verbose"}), ContainsSubstring("contradict"));
  CHECK_THAT(error_of({"view"}), ContainsSubstring("DIR is required"));
  CHECK_THAT(error_of({"view", "out", "--port", "70000"}), ContainsSubstring("--port"));
  CHECK_THAT(error_of({"view", "out", "--set", "a=1"}), ContainsSubstring("--set"));
  CHECK_THAT(error_of({"--generate", "tcsh"}), ContainsSubstring("expected man, bash"));
  CHECK_THAT(error_of({"--generate"}), ContainsSubstring("expected man, bash"));
}

TEST_CASE("a mistyped option names the one that was meant", "[unit][command_line]") {
  CHECK_THAT(error_of({"run", "a.toml", "--thread", "2"}),
             ContainsSubstring("unknown option '--thread' of run; expected '--threads'"));
  // What is missing for want of it comes second.
  CHECK_THAT(error_of({"cut", "--tol=flat:D=8"}), ContainsSubstring("expected '--tool'"));
  CHECK_THAT(error_of({"verify", "--guge", "0.1"}), ContainsSubstring("expected '--gouge'"));
  CHECK_THAT(error_of({"run", "a.toml", "--gouge", "1"}),
             ContainsSubstring("it is one of verify;"));
  CHECK_THAT(error_of({"run", "a.toml", "--qqqqqqqq"}),
             ContainsSubstring("expected one that it has; see limitgauge run --help"));
  // A value is no option, whatever it begins with.
  CHECK_THAT(error_of({"run", "a.toml", "--label", "--thread", "--threads", "0"}),
             !ContainsSubstring("unknown option '--thread' of"));
}

TEST_CASE("JSON is printed by commands that have a result", "[unit][command_line]") {
  CHECK(parse({"run", "a.toml", "--json"}).common.json);
  CHECK(parse({"run", "a.toml", "--json", "--quiet"}).common.json);
  CHECK(parse({"compare", "a", "b", "--json"}).common.json);
  CHECK(parse({"probe", "a", "b", "--json"}).common.json);
  CHECK_FALSE(parse({"run", "a.toml"}).common.json);
  for (const char* command : {"plan", "inspect", "view"})
    CHECK_THAT(error_of({command, "a", "--json"}),
               ContainsSubstring("expected it with run, verify, cut, compare or probe"));
}

TEST_CASE("probe takes a result, points and what to judge by", "[unit][command_line]") {
  const CommandLine line = parse({"probe", "out", "points.csv", "--stage", "rough", "--residual",
                                  "0.02", "--stock", "raw.stl", "-o", "there"});
  const auto& probe = std::get<ProbeCommand>(line.command);
  CHECK(probe.result == "out");
  CHECK(probe.points == "points.csv");
  CHECK(probe.stage == "rough");
  CHECK(probe.residual_mm == 0.02);
  CHECK(probe.stock == "raw.stl");
  CHECK(probe.output == "there");
  CHECK_FALSE(std::get<ProbeCommand>(parse({"probe", "a", "b"}).command).residual_mm);
  CHECK_THAT(error_of({"probe", "out"}), ContainsSubstring("POINTS is required"));
  CHECK_THAT(error_of({"probe", "a", "b", "--residual", "-1"}), ContainsSubstring("--residual"));
  CHECK_THAT(error_of({"probe", "a", "b", "--gouge", "1"}), ContainsSubstring("--gouge"));
}

TEST_CASE("help names what there is and nothing else", "[unit][command_line]") {
  const CommandLine all = parse({"--help"});
  const std::string& text = std::get<PrintCommand>(all.command).text;
  for (const char* word : {"run", "plan", "verify", "cut", "inspect", "compare", "probe", "study",
                           "history", "view", "Exit codes"}) {
    CHECK_THAT(text, ContainsSubstring(word));
  }
  CHECK_THAT(text, !ContainsSubstring("--generate"));
  const CommandLine verify = parse({"verify", "--help"});
  CHECK_THAT(std::get<PrintCommand>(verify.command).text, ContainsSubstring("--stock"));
  const CommandLine version = parse({"--version"});
  CHECK_THAT(std::get<PrintCommand>(version.command).text, ContainsSubstring("limitgauge 0."));
}

}  // namespace
}  // namespace limitgauge::app
