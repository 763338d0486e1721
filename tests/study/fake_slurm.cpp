#include "tests/study/fake_slurm.h"

#include <cstdlib>
#include <fstream>

namespace limitgauge::study {
namespace fs = std::filesystem;

FakeSlurm::FakeSlurm() : path_(std::getenv("PATH")) {
  fs::create_directory(folder() / "bin");
  write_program("sbatch", "wc -l < sbatch.calls");
  write_program("squeue", "cat queue");
  write_program("sinfo", "cat nodes");
  write_program("scancel", "case \"$1\" in --name=*) : > queue ;; esac");
  write_program("scontrol", "echo 'MaxArraySize = 1001'");
  set_queue("");
  set_nodes("");
  setenv("PATH", ((folder() / "bin").string() + ":" + path_).c_str(), 1);
}

FakeSlurm::~FakeSlurm() {
  setenv("PATH", path_.c_str(), 1);
}

void FakeSlurm::write_program(const std::string& name, const std::string& lines) const {
  const fs::path file = folder() / "bin" / name;
  std::ofstream(file) << "#!/bin/sh\ncd '" << folder().string() << "'\necho \"$*\" >> " << name
                      << ".calls\n"
                      << lines << '\n';
  fs::permissions(file, fs::perms::owner_all);
}

void FakeSlurm::set_queue(const std::string& lines) const {
  std::ofstream(folder() / "queue") << lines;
}

void FakeSlurm::set_nodes(const std::string& lines) const {
  std::ofstream(folder() / "nodes") << lines;
}

std::vector<std::string> FakeSlurm::calls(const std::string& program) const {
  std::ifstream in(folder() / (program + ".calls"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace limitgauge::study
