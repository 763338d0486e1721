#include "reports/vtk/zlib_blocks.h"

#include <libdeflate.h>
#include <vtkObjectFactory.h>

#include <new>

namespace limitgauge::reports {
namespace {

/// Of meshes as small as zlib's own lowest level makes them, in about half of its time. A level
/// less is larger by a sixth, levels more are no smaller.
constexpr int kLevel = 2;

}  // namespace

ZlibBlocks* ZlibBlocks::New() {
  VTK_STANDARD_NEW_BODY(ZlibBlocks);
}

ZlibBlocks::ZlibBlocks() : compressor_(libdeflate_alloc_compressor(kLevel)) {
  if (!compressor_) throw std::bad_alloc();
}

ZlibBlocks::~ZlibBlocks() = default;

void ZlibBlocks::Free::operator()(libdeflate_compressor* compressor) const {
  libdeflate_free_compressor(compressor);
}

size_t ZlibBlocks::GetMaximumCompressionSpace(size_t size) {
  return libdeflate_zlib_compress_bound(compressor_.get(), size);
}

size_t ZlibBlocks::CompressBuffer(unsigned char const* plain, size_t plain_size,
                                  unsigned char* compressed, size_t space) {
  return libdeflate_zlib_compress(compressor_.get(), plain, plain_size, compressed, space);
}

}  // namespace limitgauge::reports
