#pragma once

#include <array>
#include <ostream>
#include <streambuf>
#include <string>

namespace limitgauge::app {

/// Opens what is closed of standard input, output and errors as something that cannot be used:
/// else a file of results would get its number, and be written into by whoever prints.
void hold_standard_descriptors();

/// What goes to a descriptor, with the reason why the first of it could not be written.
class DescriptorBuffer : public std::streambuf {
 public:
  explicit DescriptorBuffer(int descriptor);
  /// An errno; 0 where all that was flushed has been written.
  int error() const { return error_; }

 protected:
  int_type overflow(int_type c) override;
  int sync() override;

 private:
  bool flush();

  int descriptor_, error_ = 0;
  std::array<char, std::size_t{1} << 16> bytes_;
};

/// A stream of its own for a descriptor. What could not be written is known at the end.
class StandardStream : public std::ostream {
 public:
  explicit StandardStream(int descriptor) : std::ostream(nullptr), buffer_(descriptor) {
    rdbuf(&buffer_);
  }
  /// Why something that was printed is lost, once all of it is flushed; empty where nothing is.
  std::string failure();

 private:
  DescriptorBuffer buffer_;
};

}  // namespace limitgauge::app
