#include "reports/picture/png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <unordered_map>
#include <vector>

namespace limitgauge::reports {
namespace {

constexpr std::size_t kMostColours = 256;

using Channels = std::array<std::uint8_t, 4>;
// libpng takes pixels for rows of bytes.
static_assert(sizeof(Rgba) == 4 && sizeof(Channels) == 4);

Channels channels(const Rgba& c) {
  // What is not seen at all is one colour.
  return c.a == 0 ? Channels{0, 0, 0, 0} : Channels{c.r, c.g, c.b, c.a};
}

/// The same colour as one number: less of it sorts as less in its channels.
std::uint32_t key_of(const Channels& c) {
  return std::uint32_t(c[0]) << 24 | std::uint32_t(c[1]) << 16 | std::uint32_t(c[2]) << 8 | c[3];
}

Channels channels_of(std::uint32_t key) {
  const auto byte = [key](int shift) { return static_cast<std::uint8_t>(key >> shift & 0xff); };
  return {byte(24), byte(16), byte(8), byte(0)};
}

/// A colour of the picture, how many pixels have it, and its place in the palette.
struct Entry {
  Channels colour{};
  std::size_t count = 0;
  std::uint8_t index = 0;
};

/// Entries [first, last) that share one colour of the palette.
struct Bin {
  std::size_t first = 0, last = 0, widest = 0;
  double weight = 0;  ///< pixels times range: what splitting it gains
};

Bin bin_of(const std::vector<Entry>& entries, std::size_t first, std::size_t last) {
  Bin bin{first, last, 0, 0};
  std::size_t pixels = 0;
  for (std::size_t i = first; i < last; ++i) pixels += entries[i].count;
  int range = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto less = [k](const Entry& a, const Entry& b) { return a.colour[k] < b.colour[k]; };
    const auto [low, high] = std::minmax_element(entries.begin() + std::ptrdiff_t(first),
                                                 entries.begin() + std::ptrdiff_t(last), less);
    const int spread = high->colour[k] - low->colour[k];
    if (spread > range) range = spread, bin.widest = k;
  }
  // Squared: a large step between two colours is seen more than many pixels that are a little off.
  bin.weight = static_cast<double>(pixels) * range * range;
  return bin;
}

/// Cuts a bin where half of its pixels are on either side along its widest channel.
std::pair<Bin, Bin> halves(std::vector<Entry>& entries, const Bin& bin) {
  const auto first = entries.begin() + std::ptrdiff_t(bin.first),
             last = entries.begin() + std::ptrdiff_t(bin.last);
  std::sort(first, last, [k = bin.widest](const Entry& a, const Entry& b) {
    return a.colour[k] != b.colour[k] ? a.colour[k] < b.colour[k] : a.colour < b.colour;
  });
  std::size_t pixels = 0, seen = 0;
  for (auto it = first; it != last; ++it) pixels += it->count;
  std::size_t cut = bin.first;
  while (cut + 1 < bin.last && (cut == bin.first || 2 * (seen + entries[cut].count) <= pixels))
    seen += entries[cut++].count;
  return {bin_of(entries, bin.first, cut), bin_of(entries, cut, bin.last)};
}

/// Median cut.
std::vector<Bin> bins_of(std::vector<Entry>& entries) {
  std::vector<Bin> bins = {bin_of(entries, 0, entries.size())};
  while (bins.size() < std::min(kMostColours, entries.size())) {
    const auto heaviest = std::max_element(
        bins.begin(), bins.end(), [](const Bin& a, const Bin& b) { return a.weight < b.weight; });
    const auto [low, high] = halves(entries, *heaviest);
    *heaviest = low;
    bins.push_back(high);
  }
  return bins;
}

/// The mean colour of a bin, which its entries then refer to.
Channels settle(std::vector<Entry>& entries, const Bin& bin, std::uint8_t index) {
  std::array<std::size_t, 4> sums{};
  std::size_t pixels = 0;
  for (std::size_t i = bin.first; i < bin.last; ++i) {
    Entry& e = entries[i];
    e.index = index;
    pixels += e.count;
    for (std::size_t k = 0; k < 4; ++k) sums[k] += e.colour[k] * e.count;
  }
  Channels mean{};
  for (std::size_t k = 0; k < 4; ++k)
    mean[k] = static_cast<std::uint8_t>((sums[k] + pixels / 2) / pixels);
  return mean;
}

[[noreturn]] void fail(const png_image& png) {
  throw std::runtime_error(std::string("libpng: ") + png.message);
}

/// `pixels` as `format` and `flags` of libpng say, which are places in `palette` where it has one.
std::string encoded(const Image& image, png_uint_32 format, png_uint_32 flags, const void* pixels,
                    const std::vector<Channels>& palette) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width());
  png.height = static_cast<png_uint_32>(image.height());
  png.format = format;
  png.flags = flags;
  png.colormap_entries = static_cast<png_uint_32>(palette.size());
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  // Most of what a picture may take is never touched.
  const auto room = std::make_unique_for_overwrite<char[]>(size);
  if (!png_image_write_to_memory(&png, room.get(), &size, 0, pixels, 0, palette.data())) fail(png);
  return {room.get(), size};
}

}  // namespace

std::string png_bytes(const Image& image) {
  const std::vector<Rgba>& pixels = image.pixels();
  const bool is_opaque =
      std::all_of(pixels.begin(), pixels.end(), [](const Rgba& c) { return c.a == 255; });
  // Rows as they are, little searched for: a fifth of the time of libpng's usual effort, for files
  // that are a tenth larger and without an alpha that says nothing as large as before.
  constexpr png_uint_32 kFlags = PNG_IMAGE_FLAG_FAST;
  if (!is_opaque) return encoded(image, PNG_FORMAT_RGBA, kFlags, pixels.data(), {});
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * pixels.size());
  for (const Rgba& c : pixels) bytes.insert(bytes.end(), {c.r, c.g, c.b});
  return encoded(image, PNG_FORMAT_RGB, kFlags, bytes.data(), {});
}

namespace {

/// The colours of a picture and how often each occurs, in their order. Pixels of one colour stand
/// beside each other: runs of them are far fewer.
std::vector<Entry> colours_of(const Image& image) {
  std::unordered_map<std::uint32_t, std::size_t> counts;
  const std::vector<Rgba>& pixels = image.pixels();
  for (std::size_t i = 0; i < pixels.size();) {
    const std::size_t first = i;
    while (i < pixels.size() && pixels[i] == pixels[first]) ++i;
    counts[key_of(channels(pixels[first]))] += i - first;
  }
  std::vector<Entry> entries;
  entries.reserve(counts.size());
  for (const auto& [key, count] : counts) entries.push_back({channels_of(key), count, 0});
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.colour < b.colour; });
  return entries;
}

/// Of each pixel, its colour's place in the palette.
std::vector<std::uint8_t> indices_of(const Image& image, const std::vector<Entry>& entries) {
  std::unordered_map<std::uint32_t, std::uint8_t> index;
  for (const Entry& e : entries) index.emplace(key_of(e.colour), e.index);
  const std::vector<Rgba>& pixels = image.pixels();
  std::vector<std::uint8_t> indices(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
    indices[i] = i > 0 && pixels[i] == pixels[i - 1] ? indices[i - 1]
                                                     : index.at(key_of(channels(pixels[i])));
  return indices;
}

}  // namespace

std::string palette_png(const Image& image) {
  std::vector<Entry> entries = colours_of(image);
  std::vector<Channels> palette;
  for (const Bin& bin : bins_of(entries))
    palette.push_back(settle(entries, bin, static_cast<std::uint8_t>(palette.size())));
  const std::vector<std::uint8_t> pixels = indices_of(image, entries);
  return encoded(image, PNG_FORMAT_RGBA_COLORMAP, 0, pixels.data(), palette);
}

Image read_png(std::string_view bytes) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size())) fail(png);
  png.format = PNG_FORMAT_RGBA;
  Image image(static_cast<int>(png.width), static_cast<int>(png.height));
  if (!png_image_finish_read(&png, nullptr, image.pixels().data(), 0, nullptr)) fail(png);
  return image;
}

}  // namespace limitgauge::reports
