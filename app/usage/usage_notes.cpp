#include "app/usage/usage_notes.h"

#include <array>

namespace limitgauge::app {
namespace {

constexpr std::array<UsageNote, 5> kExitCodes = {{
    {"0", "every gate passes"},
    {"1", "a gate fails; compare found a regression; no case of a study passes"},
    {"2", "a gate is indeterminate"},
    {"3", "bad input or usage; nothing was written"},
    {"4", "out of resources, interrupted or internal error"},
}};

constexpr std::array<UsageNote, 9> kFiles = {{
    {"report.html", "the report, one page that works offline"},
    {"result.json", "its figures for programs; written last"},
    {"junit.xml", "a test case for each stage and gate"},
    {"STAGE/", "a folder for each stage: toolpath, stock, deviation and pictures"},
    {"NAME.incomplete/", "what a run that ran out of disk or memory had finished"},
    {"compare.html, .md, .json", "of compare: what got better or worse"},
    {"probe.html, .csv, .json", "of probe: residuals of measured points and the zero shift"},
    {"history.html, .csv, .json", "of history: figures of past runs"},
    {"study.html, .csv, .json", "of study: its cases, and cases/ with the result of each"},
}};

constexpr std::array<UsageNote, 4> kEnvironment = {{
    {"NO_COLOR", "not empty: no colour, also on a terminal"},
    {"TERM", "\"dumb\": neither colour nor progress"},
    {"XDG_CACHE_HOME",
     "study and run on Slurm keep results in limitgauge below it (default: ~/.cache)"},
    {"DISPLAY, WAYLAND_DISPLAY", "one of them set: view opens the desktop's browser"},
}};

constexpr std::array<UsageNote, 10> kExamples = {{
    {"limitgauge run part.toml", "Plan, cut and verify the stages of a job."},
    {"limitgauge run part.toml --set stage.finish.step=0.2", "The same with one key otherwise."},
    {"limitgauge run part.toml --engine slurm --cache /shared/limitgauge",
     "The same, measured piece by piece on a cluster."},
    {"limitgauge verify --cage part.obj --stock box:90,80,30@-45,-40,-20 --tool ball:D=6 "
     "--program part.ngc --gouge 0.01 --uncut 0.01",
     "Verify somebody else's program."},
    {"limitgauge cut --stock box:90,80,30@-45,-40,-20 --tool ball:D=6 --program part.ngc",
     "Cut it without a design: collisions, times, the finished stock."},
    {"limitgauge inspect part.ngc --moves", "What a program does, one move a line."},
    {"limitgauge compare base limitgauge-out/part", "Has accuracy slipped since that result?"},
    {"limitgauge probe limitgauge-out/part points.csv",
     "How far is the part, as measured, from its simulation?"},
    {"limitgauge study tuning.toml", "Which setting is the cheapest that passes?"},
    {"limitgauge view limitgauge-out/part", "Open the report of a finished run."},
}};

}  // namespace

std::span<const UsageNote> exit_code_notes() {
  return kExitCodes;
}
std::span<const UsageNote> file_notes() {
  return kFiles;
}
std::span<const UsageNote> environment_notes() {
  return kEnvironment;
}
std::span<const UsageNote> example_notes() {
  return kExamples;
}

}  // namespace limitgauge::app
