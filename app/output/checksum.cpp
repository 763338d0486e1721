#include "app/output/checksum.h"

#include <array>
#include <fstream>
#include <span>
#include <vector>

#include <openssl/evp.h>

#include "model/base/error.h"
#include "model/text/hexadecimal.h"

namespace limitgauge::app {
namespace {

constexpr std::size_t kPiece_bytes = std::size_t(1) << 16;

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

std::string sha256_of(std::string_view bytes) {
  Sha256 sum;
  sum.add(bytes);
  return sum.digits();
}

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

}  // namespace limitgauge::app
