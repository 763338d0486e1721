#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limitgauge::e2e {

/// An empty folder of one test, removed at its end.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  /// Names of what stands in it, hidden files included, sorted.
  std::vector<std::string> entries() const;

 private:
  std::filesystem::path path_;
};

struct Outcome {
  int exit_code = -1;  ///< minus the signal that ended the program
  std::string out, errors;
  double peak_bytes = 0;  ///< most memory that it had in use
};

/// Whether the process, by its folder under /proc, has become the program.
bool is_program(const std::filesystem::path& process);

struct Conditions {
  std::optional<std::chrono::milliseconds> interrupt_after;  ///< SIGINT then
  std::optional<std::size_t> largest_file_bytes;             ///< stands in for a full disk
  std::optional<std::size_t> most_descriptors = std::nullopt;
  std::optional<std::size_t> most_memory_bytes = std::nullopt;
  /// Processes and threads; root, whom no such limit holds, is nobody then.
  std::optional<std::size_t> most_threads = std::nullopt;
  enum class Out { file, full, pipe_nobody_reads, closed } out = Out::file;  ///< standard output
};

/// Runs the built program in `folder` and waits for its end.
Outcome limitgauge(const Scratch& folder, const std::vector<std::string>& arguments,
                   const Conditions& conditions = {});

/// A command with the quick job and the settings that make it a coarser one, which takes less than
/// a second and passes: for what becomes of a run, whatever its figures.
std::vector<std::string> coarsely(std::vector<std::string> command,
                                  const std::vector<std::string>& more = {});
/// `run` of it, without pictures.
std::vector<std::string> run_coarse_job(const std::string& output,
                                        const std::vector<std::string>& more = {});

std::string read_text(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, const std::string& text);
/// A file below fixtures/.
std::string fixture(const std::string& name);

}  // namespace limitgauge::e2e
