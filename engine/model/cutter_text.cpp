#include <array>
#include <map>
#include <stdexcept>

#include "engine/model/cutter.h"
#include "engine/model/spec_text.h"
#include "engine/model/words.h"

namespace limitgauge::model {
namespace {

constexpr std::array kTypes = {CutterType::flat, CutterType::ball, CutterType::bull,
                               CutterType::taper};
constexpr std::array<std::string_view, 4> kTypeNames = {"flat", "ball", "bull", "taper"};
constexpr std::array<std::string_view, 6> kKeys = {"D", "r", "angle", "L", "shank", "holder"};
constexpr double kDefaultFluteDiameters = 4;

class CutterText {
 public:
  explicit CutterText(std::string_view text) : text_(text, "tool") { cutter_.id = text; }

  Cutter read() {
    read_type();
    do read_pair();
    while (text_.take(','));
    complete();
    return cutter_;
  }

 private:
  void read_type() {
    const std::string_view type = text_.take_until(":");
    for (std::size_t i = 0; i < kTypes.size(); ++i) {
      if (type != kTypeNames[i]) continue;
      cutter_.type = kTypes[i];
      if (!text_.take(':')) text_.fail_at(text_.position(), "the cutter has no figures", "':D=6'");
      return;
    }
    const std::string near = nearest_word(type, kTypeNames.data(), kTypeNames.size());
    text_.fail_at(0, "unknown cutter " + in_quotes(type),
                  near.empty() ? "flat, ball, bull or taper" : in_quotes(near));
  }

  void read_pair() {
    const std::size_t begin = text_.position();
    const std::string key(text_.take_until("=,"));
    require_known(key, begin);
    if (!text_.take('=')) text_.fail_at(text_.position(), in_quotes(key) + " has no value", "'='");
    const bool first = places_.emplace(key, text_.position()).second;
    if (key == "shank") return cutter_.shank.push_back(part(key));
    if (key == "holder") return cutter_.holder.push_back(part(key));
    if (!first) text_.fail_at(begin, in_quotes(key) + " stands twice", "it once");
    const double value = text_.positive(",", key);
    if (key == "D") cutter_.diameter_mm = value;
    if (key == "r") cutter_.corner_radius_mm = value;
    if (key == "angle") cutter_.taper_angle_deg = value;
    if (key == "L") cutter_.flute_length_mm = value;
  }

  void require_known(const std::string& key, std::size_t begin) const {
    for (const std::string_view known : kKeys) {
      if (key != known) continue;
      if (!fits_type(key))
        text_.fail_at(begin,
                      std::string("a ") + name(cutter_.type) + " cutter has no '" + key + "'",
                      "D, L, shank or holder");
      return;
    }
    const std::string near = nearest_word(key, kKeys.data(), kKeys.size());
    text_.fail_at(begin, "unknown key " + in_quotes(key),
                  near.empty() ? "D, r, angle, L, shank or holder" : in_quotes(near));
  }

  bool fits_type(const std::string& key) const {
    if (key == "angle") return cutter_.type == CutterType::taper;
    if (key == "r") return cutter_.type == CutterType::bull || cutter_.type == CutterType::taper;
    return true;
  }

  CylinderPart part(const std::string& key) {
    CylinderPart read;
    read.diameter_mm = text_.positive(":,", key + " diameter");
    if (!text_.take(':'))
      text_.fail_at(text_.position(), in_quotes(key) + " has no length", "'" + key + "=D:L'");
    read.length_mm = text_.positive(",", key + " length");
    return read;
  }

  void complete() {
    require_key("D");
    if (cutter_.type == CutterType::bull) require_key("r");
    if (cutter_.type == CutterType::taper) require_key("angle");
    if (cutter_.type == CutterType::ball) cutter_.corner_radius_mm = cutter_.radius_mm();
    if (!places_.contains("L"))
      cutter_.flute_length_mm = kDefaultFluteDiameters * cutter_.diameter_mm;
    try {
      require_valid(cutter_);
    } catch (const std::invalid_argument& problem) {
      text_.fail_at(place_of(problem.what()), problem.what(), "figures that make a cutter");
    }
  }

  void require_key(const std::string& key) const {
    if (!places_.contains(key))
      text_.fail_at(text_.position(),
                    std::string("a ") + name(cutter_.type) + " cutter needs '" + key + "='", "it");
  }

  /// The value that a complaint of require_valid is about.
  std::size_t place_of(std::string_view problem) const {
    const std::string key = problem.starts_with("corner")  ? "r"
                            : problem.starts_with("flute") ? "L"
                            : problem.starts_with("taper") ? "angle"
                                                           : "D";
    const auto found = places_.find(key);
    return found == places_.end() ? 0 : found->second;
  }

  SpecText text_;
  Cutter cutter_;
  std::map<std::string, std::size_t> places_;
};

std::string parts_text(const char* key, const std::vector<CylinderPart>& parts) {
  std::string text;
  for (const CylinderPart& part : parts) {
    text +=
        std::string(",") + key + "=" + shortest(part.diameter_mm) + ":" + shortest(part.length_mm);
  }
  return text;
}

}  // namespace

Cutter parse_cutter(std::string_view text) {
  return CutterText(text).read();
}

std::string to_text(const Cutter& cutter) {
  std::string text = std::string(name(cutter.type)) + ":D=" + shortest(cutter.diameter_mm);
  const bool rounded = cutter.type == CutterType::bull || cutter.type == CutterType::taper;
  if (rounded && cutter.corner_radius_mm > 0) text += ",r=" + shortest(cutter.corner_radius_mm);
  if (cutter.type == CutterType::taper) text += ",angle=" + shortest(cutter.taper_angle_deg);
  text += ",L=" + shortest(cutter.flute_length_mm);
  return text + parts_text("shank", cutter.shank) + parts_text("holder", cutter.holder);
}

}  // namespace limitgauge::model
