// VTK 9.1 takes a std::string byte by byte and reads UTF-8 only from the type that it declares
// deprecated; from 9.2 on a std::string is UTF-8 and the other type is gone.
#define VTK_DEPRECATION_LEVEL 0

#include "reports/picture/lettering.h"

#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkVersion.h>
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
#include <vtkUnicodeString.h>
#endif

#include <algorithm>
#include <cmath>
#include <mutex>
#include <string>
#include <vector>

#include "reports/text/text.h"
#include "reports/vtk/vtk_support.h"

namespace limitgauge::reports {
namespace {

constexpr int kPointsPerInch = 72;  ///< a point is a pixel
/// Height of a capital as a share of the font size in URW Gothic, which VTK calls Arial.
constexpr double kCapital = 0.74;
constexpr const char* kNoGlyph = "◊";

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
vtkUnicodeString vtk_text(const std::string& utf8) {
  return vtkUnicodeString::from_utf8(utf8);
}
#else
vtkStdString vtk_text(const std::string& utf8) {
  return utf8;
}
#endif

/// How much of each pixel a text covers, 0 to 1; (0, 0) stands right of its start, on the baseline.
struct Cover {
  Cover(int left_end, int lowest, int columns, int rows)
      : left(left_end),
        bottom(lowest),
        width(columns),
        height(rows),
        share(std::size_t(columns) * rows) {}
  double& at(int x, int y) { return share[std::size_t(y - bottom) * width + (x - left)]; }

  /// Calls visit(x, y, share) for each pixel that is covered; y is up.
  template <typename Visit>
  void each(const Visit& visit) const {
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (const double c = share[std::size_t(y) * width + x]; c > 0)
          visit(left + x, bottom + y, c);
  }

  int left, bottom, width, height;
  std::vector<double> share;
};

/// `cover` wider by `by` pixels on all sides.
Cover grown(const Cover& cover, int by) {
  Cover out(cover.left - by, cover.bottom - by, cover.width + 2 * by, cover.height + 2 * by);
  cover.each([&](int x, int y, double share) {
    for (int dy = -by; dy <= by; ++dy)
      for (int dx = -by; dx <= by; ++dx)
        if (dx * dx + dy * dy <= by * by + by)
          out.at(x + dx, y + dy) = std::max(out.at(x + dx, y + dy), share);
  });
  return out;
}

/// VTK's FreeType tools, of which a process has one; held by one thread at a time.
class Lettering {
 public:
  Lettering(double height, bool bold) : lock_(mutex()) {
    property_->SetFontFamilyToArial();
    property_->SetFontSize(static_cast<int>(std::lround(height / kCapital)));
    property_->SetBold(bold);
  }

  /// Pixels from the left end to the right one.
  int width(const std::string& text) const {
    int box[4] = {0, -1, 0, -1};  // left, right, bottom, top; the last pixel included
    tools().GetBoundingBox(property_, vtk_text(text), kPointsPerInch, box);
    return box[1] - box[0] + 1;
  }

  bool has_glyph(const std::string& character) const {
    return width("|" + character + "|") > width("||");
  }

  Cover cover(const std::string& text) const {
    vtkNew<vtkImageData> image;
    if (text.empty() || !tools().RenderString(property_, vtk_text(text), kPointsPerInch, image))
      return {0, 0, 0, 0};
    const int* e = image->GetExtent();
    const int baseline = 1 - descent();
    Cover out(e[0], e[2] - baseline, e[1] - e[0] + 1, e[3] - e[2] + 1);
    for (int y = e[2]; y <= e[3]; ++y)
      for (int x = e[0]; x <= e[1]; ++x)
        out.at(x, y - baseline) =
            static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0))[3] / 255.0;
    return out;
  }

 private:
  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }
  static vtkFreeTypeTools& tools() { return *vtkFreeTypeTools::GetInstance(); }

  /// Of the lowest letters, negative, in VTK's count; the same for every text.
  int descent() const {
    vtkTextRenderer::Metrics metrics;
    tools().GetMetrics(property_, vtkStdString("g"), kPointsPerInch, metrics);
    return metrics.Descent.GetY();
  }

  const std::lock_guard<std::mutex> lock_;
  const QuietVtk quiet_;
  vtkNew<vtkTextProperty> property_;
};

/// The characters of UTF-8 text, U+FFFD for what is none.
std::vector<std::string> characters(std::string_view text) {
  std::vector<std::string> out;
  for (const char c : clean_text(text)) {
    const bool continues = (static_cast<unsigned char>(c) & 0xC0) == 0x80;
    if (!continues || out.empty()) out.emplace_back();
    out.back() += c;
  }
  return out;
}

/// `text` as it can be drawn.
std::string drawable(std::string_view text, const Lettering& letters) {
  std::string out;
  for (const std::string& c : characters(text)) out += letters.has_glyph(c) ? c : kNoGlyph;
  return out;
}

}  // namespace

void draw_text(Image& image, std::string_view text, const model::Vec2& at, const TextStyle& style) {
  const Lettering letters(style.height, style.bold);
  const int left = static_cast<int>(std::lround(at.x)), base = static_cast<int>(std::lround(at.y));
  const Cover plain = letters.cover(drawable(text, letters));
  const Cover cover = style.grown > 0 ? grown(plain, style.grown) : plain;
  cover.each([&](int x, int y, double share) {
    image.blend(left + x, base - 1 - y, style.colour, share);
  });
}

double text_width(std::string_view text, const TextStyle& style) {
  const Lettering letters(style.height, style.bold);
  return text.empty() ? 0 : letters.width(drawable(text, letters));
}

bool has_glyphs(std::string_view text) {
  const TextStyle style;
  const Lettering letters(style.height, style.bold);
  return std::ranges::all_of(characters(text),
                             [&](const std::string& c) { return letters.has_glyph(c); });
}

}  // namespace limitgauge::reports
