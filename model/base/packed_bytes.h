#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "model/base/byte_reader.h"

namespace limitgauge::model {

/// Values as bytes, for this program on machines of this kind: numbers as they stand in memory.
class Packer {
 public:
  template <class T>
  void number(T value) {
    static_assert(std::is_arithmetic_v<T>);
    raw(&value, sizeof value);
  }
  void text(std::string_view bytes) {
    number(std::uint64_t{bytes.size()});
    bytes_ += bytes;
  }
  void mark(std::string_view mark) { bytes_ += mark; }
  void raw(const void* bytes, std::size_t count) {
    bytes_.append(static_cast<const char*>(bytes), count);
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads what Packer wrote; once something is missing everything is nothing, and good() is false.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : left_(bytes) {}
  bool good() const { return good_; }
  bool done() const { return good_ && left_.empty(); }
  void refuse() { good_ = false; }
  template <class T>
  T number() {
    const std::string_view bytes = take(sizeof(T));
    return good_ ? number_in<T>(bytes, std::endian::native) : T{};
  }
  /// How many things of `bytes` bytes at least follow.
  std::size_t count(std::size_t bytes) {
    const auto stated = number<std::uint64_t>();
    if (stated > left_.size() / bytes) good_ = false;
    return good_ ? static_cast<std::size_t>(stated) : 0;
  }
  std::string text() { return std::string(take(count(1))); }
  void mark(std::string_view expected) {
    if (take(expected.size()) != expected) good_ = false;
  }
  std::string_view take(std::size_t count) {
    if (count > left_.size()) good_ = false;
    if (!good_) return {};
    const std::string_view taken = left_.substr(0, count);
    left_.remove_prefix(count);
    return taken;
  }

 private:
  std::string_view left_;
  bool good_ = true;
};

}  // namespace limitgauge::model
