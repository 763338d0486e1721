#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace limitgauge::study {

/// Programs called as Slurm's are, first in PATH while this lives: sbatch takes every job and
/// starts none (its number is 1, 2, ...), squeue and sinfo print what they are told to, all calls
/// are written down.
class FakeSlurm {
 public:
  FakeSlurm();
  ~FakeSlurm();
  FakeSlurm(const FakeSlurm&) = delete;
  FakeSlurm& operator=(const FakeSlurm&) = delete;

  const std::filesystem::path& folder() const { return folder_.path(); }
  /// "1 0 RUNNING|n1|long|None" and such.
  void set_queue(const std::string& lines) const;
  void set_nodes(const std::string& lines) const;
  /// From now on this program does not come to its end.
  void hang(const std::string& program) const { write_program(program, "exec sleep 100"); }
  /// Lines of all calls of a program: its arguments.
  std::vector<std::string> calls(const std::string& program) const;

 private:
  void write_program(const std::string& name, const std::string& lines) const;

  tests::TemporaryFolder folder_;
  std::string path_;
};

}  // namespace limitgauge::study
