#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace limitgauge::app {

/// SHA-256 of what is put in piece by piece. Throws ResourceError where the library fails.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;
  void add(std::string_view bytes);
  /// 64 lower-case hexadecimal digits; nothing can be put in afterwards.
  std::string digits();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace limitgauge::app
