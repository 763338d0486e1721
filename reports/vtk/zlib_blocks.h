#pragma once

// Seen by what includes VTK only.

#include <vtkZLibDataCompressor.h>

#include <memory>

struct libdeflate_compressor;

namespace limitgauge::reports {

/// VTK's zlib blocks as libdeflate makes them: the same format, which every reader of VTK's files
/// knows by the name of the class that this one is derived from, in about half of zlib's time.
class ZlibBlocks : public vtkZLibDataCompressor {
 public:
  /// As VTK makes its objects. Throws std::bad_alloc.
  static ZlibBlocks* New();
  size_t GetMaximumCompressionSpace(size_t size) override;

 protected:
  ZlibBlocks();
  ~ZlibBlocks() override;
  /// 0 where the space is too small: never that of GetMaximumCompressionSpace.
  size_t CompressBuffer(unsigned char const* plain, size_t plain_size, unsigned char* compressed,
                        size_t space) override;

 private:
  struct Free {
    void operator()(libdeflate_compressor* compressor) const;
  };
  std::unique_ptr<libdeflate_compressor, Free> compressor_;
};

}  // namespace limitgauge::reports
