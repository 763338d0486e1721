#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <ostream>

#include "app/cli/commands.h"
#include "app/output/manifest.h"
#include "app/serve/report_server.h"
#include "model/base/absolute_path.h"
#include "model/base/error.h"

namespace limitgauge::app {
namespace fs = std::filesystem;
namespace {

constexpr const char* kExpected = "the output folder of a finished run";

/// The folder of a report that is complete: result.json is written last.
fs::path finished_folder(const fs::path& stated) {
  std::error_code ignored;
  const bool is_report = stated.filename() == "report.html" && fs::is_regular_file(stated, ignored);
  const fs::path folder = is_report ? model::absolute_path(stated).parent_path() : stated;
  const auto wrong = [&](const std::string& what) {
    return model::InputError({stated.string(), 0, 0}, what, kExpected);
  };
  if (!fs::exists(folder, ignored)) throw wrong("this does not exist");
  if (!fs::is_directory(folder, ignored)) throw wrong("this is no folder");
  if (fs::exists(folder / kIncompleteFile, ignored))
    throw wrong("the run in this folder did not come to its end and has no report");
  for (const char* file : {"report.html", "result.json"})
    if (!fs::is_regular_file(folder / file, ignored))
      throw wrong("there is no finished report in this folder: no " + std::string(file));
  return folder;
}

bool has_display() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) {
    const char* value = std::getenv(name);
    if (value != nullptr && *value != '\0') return true;
  }
  return false;
}

/// Asks the desktop for its browser. Where there is none, the address has been printed. The browser
/// is a session of its own: Ctrl-C here does not end it.
void open_browser(const std::string& address) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_init(&attributes);
  // What is ignored here to be heard of as an error is to end a program that never asked for it.
  sigset_t ending;
  sigemptyset(&ending);
  sigaddset(&ending, SIGPIPE);
  posix_spawnattr_setsigdefault(&attributes, &ending);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGDEF);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&files, stream, "/dev/null", O_RDWR, 0);
  std::string program = "xdg-open", argument = address;
  char* const words[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  posix_spawnp(&child, program.c_str(), &files, &attributes, words, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
}

}  // namespace

ExitCode execute(const ViewCommand& command, const CommonOptions& common, const Console& console) {
  ReportServer server(finished_folder(command.folder), command.port);
  if (!common.quiet) console.out << "report: " << server.address() << " (Ctrl-C ends)" << std::endl;
  if (!command.no_browser && has_display()) open_browser(server.address());
  static const std::atomic<bool> never{false};
  server.serve(console.stop == nullptr ? never : *console.stop);
  return ExitCode::pass;
}

}  // namespace limitgauge::app
