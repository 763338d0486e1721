#include "app/run/input_checksums.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <openssl/evp.h>

#include "model/base/error.h"
#include "model/base/hexadecimal.h"

namespace limitgauge::app {
namespace {

void require(int done) {
  if (done != 1) throw model::ResourceError("no SHA-256: the cryptographic library failed");
}

}  // namespace

struct Sha256::Context {
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> digest{EVP_MD_CTX_new(),
                                                                 &EVP_MD_CTX_free};
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {
  if (!context_->digest) throw model::ResourceError("no SHA-256: out of memory");
  require(EVP_DigestInit_ex(context_->digest.get(), EVP_sha256(), nullptr));
}
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::add(std::string_view bytes) {
  require(EVP_DigestUpdate(context_->digest.get(), bytes.data(), bytes.size()));
}

std::string Sha256::digits() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> sum{};
  unsigned length = 0;
  require(EVP_DigestFinal_ex(context_->digest.get(), sum.data(), &length));
  return model::hexadecimal(std::span(sum.data(), length));
}

namespace {

constexpr std::size_t kPiece_bytes = std::size_t(1) << 16;

/// All that the job names, in the order of the report; a program stands once however many stages
/// take a part of it.
std::vector<JobFile> files_of(const Job& job) {
  std::vector<JobFile> files;
  const auto add = [&](const JobFile& file) {
    const auto same = [&](const JobFile& known) {
      return known.role == file.role && known.path == file.path;
    };
    if (std::none_of(files.begin(), files.end(), same)) files.push_back(file);
  };
  const auto add_sources = [&](JobFile::Role role) {
    for (const JobFile& file : job.sources)
      if (file.role == role) add(file);
  };
  add_sources(JobFile::Role::job);
  add({JobFile::Role::cage, job.cage, job.cage_as_stated});
  add_sources(JobFile::Role::stock);
  for (const JobStage& stage : job.stages)
    if (!stage.plan) add({JobFile::Role::program, stage.program, stage.program_as_stated});
  for (const JobFixture& fixture : job.fixtures)
    add({JobFile::Role::fixture, fixture.file, fixture.file_as_stated});
  add_sources(JobFile::Role::tool_table);
  return files;
}

const char* name(JobFile::Role role) {
  switch (role) {
    case JobFile::Role::job:
      return "job";
    case JobFile::Role::cage:
      return "cage";
    case JobFile::Role::stock:
      return "stock";
    case JobFile::Role::program:
      return "program";
    case JobFile::Role::fixture:
      return "fixture";
    case JobFile::Role::tool_table:
      break;
  }
  return "tool table";
}

std::string shown_name(const std::string& as_stated) {
  const std::filesystem::path path(as_stated);
  return path.is_absolute() ? path.filename().string() : as_stated;
}

}  // namespace

Checksum checksum(std::istream& in) {
  Sha256 digest;
  Checksum out;
  std::vector<char> piece(kPiece_bytes);
  while (in) {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const auto count = static_cast<std::size_t>(in.gcount());
    digest.add({piece.data(), count});
    out.bytes += count;
  }
  if (in.bad()) throw model::ResourceError("no SHA-256: a file cannot be read to its end");
  out.sha256 = digest.digits();
  return out;
}

Checksum file_checksum(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw model::InputError({file.string(), 0, 0}, "cannot be read", "a file");
  return checksum(in);
}

std::vector<reports::InputFile> input_checksums(const Job& job, const FileChecksum& sum_of) {
  std::vector<reports::InputFile> inputs;
  for (const JobFile& file : files_of(job)) {
    // What came through a pipe is gone: no sum is better than that of nothing.
    std::error_code error;
    if (exists(file.path, error) && !is_regular_file(file.path, error)) continue;
    Checksum sum = sum_of(file.path);
    inputs.push_back(
        {name(file.role), shown_name(file.as_stated), sum.bytes, std::move(sum.sha256)});
  }
  return inputs;
}

}  // namespace limitgauge::app
