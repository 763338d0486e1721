#include "app/inputs/input_checksums.h"

#include <fstream>
#include <sstream>

#include "app/job/job_reader.h"
#include "app/verify/verify_job.h"
#include "model/base/error.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::app {
namespace {

// NIST, FIPS 180-4 examples.
constexpr const char* kOfNothing =
    "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
constexpr const char* kOfAbc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
constexpr const char* kOfTwoBlocks =
    "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1";
constexpr const char* kOfMillionA =
    "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0";

Checksum of(const std::string& text) {
  std::istringstream in(text);
  return checksum(in);
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

const reports::InputFile& with_role(const std::vector<reports::InputFile>& inputs,
                                    const std::string& role) {
  for (const reports::InputFile& input : inputs)
    if (input.role == role) return input;
  FAIL("no input with role " << role);
  return inputs.front();
}

}  // namespace

TEST_CASE("checksums are SHA-256", "[unit][inputs]") {
  CHECK(of("").sha256 == kOfNothing);
  CHECK(of("abc").sha256 == kOfAbc);
  CHECK(of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq").sha256 == kOfTwoBlocks);
  // More than one piece of reading.
  const Checksum million = of(std::string(1'000'000, 'a'));
  CHECK(million.sha256 == kOfMillionA);
  CHECK(million.bytes == 1'000'000);
}

TEST_CASE("every file that a job names has its checksum, each once", "[unit][inputs]") {
  const tests::TemporaryFolder folder;
  write(folder.path() / "job.toml", "abc");
  write(folder.path() / "cage.obj", "");
  write(folder.path() / "p.ngc", "abc");
  write(folder.path() / "clamp.obj", "abc");
  Job job;
  job.sources = {{JobFile::Role::tool_table, folder.path() / "p.ngc", "tool.tbl"},
                 {JobFile::Role::job, folder.path() / "job.toml", "jobs/job.toml"}};
  JobDesign& design = job.design.emplace();
  design.file = folder.path() / "cage.obj", design.as_stated = "../cage.obj";
  JobStage stage;
  stage.program = folder.path() / "p.ngc", stage.program_as_stated = "p.ngc";
  job.stages = {stage, stage};
  job.stages[1].part.tool = 2;
  job.fixtures = {
      {"clamp", folder.path() / "clamp.obj", (folder.path() / "clamp.obj").string(), {}}};
  const std::vector<reports::InputFile> inputs = input_checksums(job);
  std::vector<std::string> roles;
  for (const reports::InputFile& input : inputs) roles.push_back(input.role);
  CHECK(roles == std::vector<std::string>{"job", "cage", "program", "fixture", "tool table"});
  CHECK(with_role(inputs, "job").file == "jobs/job.toml");
  CHECK(with_role(inputs, "job").sha256 == kOfAbc);
  CHECK(with_role(inputs, "job").bytes == 3);
  CHECK(with_role(inputs, "cage").file == "../cage.obj");
  CHECK(with_role(inputs, "cage").sha256 == kOfNothing);
  // Stated from the root: only its name is told.
  CHECK(with_role(inputs, "fixture").file == "clamp.obj");
}

TEST_CASE("a job knows the files that it was read from", "[unit][inputs]") {
  const std::filesystem::path fixtures = tests::fixtures();
  const Job job = read_job(fixtures / "jobs/quick-dome.toml", {});
  const std::vector<reports::InputFile> inputs = input_checksums(job);
  REQUIRE(inputs.size() == 2);
  CHECK(inputs[0].bytes == file_size(fixtures / "jobs/quick-dome.toml"));
  CHECK(inputs[1].file == "../cages/quick-dome.obj");
  CHECK(inputs[1].bytes == file_size(fixtures / "cages/quick-dome.obj"));
}

TEST_CASE("verify's stock and tool table are among its inputs", "[unit][inputs]") {
  const std::filesystem::path fixtures = tests::fixtures();
  const tests::TemporaryFolder folder;
  write(folder.path() / "tool.tbl", "T1 P1 Z50 D8\n");
  VerifyCommand command;
  command.cage = fixtures / "foreign/plate.obj";
  command.program = fixtures / "foreign/plate.ngc";
  command.stock = "mesh:" + (fixtures / "findings/clamp.obj").string();
  command.tools = {"1=flat:D=8"};
  command.machine.tool_table = folder.path() / "tool.tbl";
  const std::vector<reports::InputFile> inputs = input_checksums(job_of(command));
  CHECK(with_role(inputs, "stock").file == "clamp.obj");
  CHECK(with_role(inputs, "stock").bytes == file_size(fixtures / "findings/clamp.obj"));
  CHECK(with_role(inputs, "tool table").bytes == 13);
  CHECK(with_role(inputs, "program").file == "plate.ngc");
}

TEST_CASE("a file that went away has no checksum", "[unit][inputs]") {
  Job job;
  job.design.emplace().file = "/nonexistent/cage.obj";
  CHECK_THROWS_AS(input_checksums(job), model::InputError);
}

}  // namespace limitgauge::app
