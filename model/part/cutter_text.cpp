#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "model/part/cutter.h"
#include "model/text/message_text.h"
#include "model/text/number_text.h"
#include "model/text/spec_text.h"

namespace limitgauge::model {
namespace {

constexpr std::array kTypes = {CutterType::flat,  CutterType::ball,  CutterType::bull,
                               CutterType::taper, CutterType::drill, CutterType::apt};
constexpr std::array<std::string_view, 6> kTypeNames = {"flat",  "ball",  "bull",
                                                        "taper", "drill", "apt"};

/// A key of the text, and which types have it.
struct Key {
  std::string_view word;
  bool (*fits)(CutterType);
};
constexpr std::array<Key, 11> kKeys = {
    {{"D", [](CutterType) { return true; }},
     {"r",
      [](CutterType t) {
        return t == CutterType::bull || t == CutterType::taper || t == CutterType::apt;
      }},
     {"angle", [](CutterType t) { return t == CutterType::taper || t == CutterType::drill; }},
     {"e", [](CutterType t) { return t == CutterType::apt; }},
     {"f", [](CutterType t) { return t == CutterType::apt; }},
     {"a", [](CutterType t) { return t == CutterType::apt; }},
     {"b", [](CutterType t) { return t == CutterType::apt; }},
     {"L", [](CutterType) { return true; }},
     {"ramp", [](CutterType) { return true; }},
     {"shank", [](CutterType) { return true; }},
     {"holder", [](CutterType) { return true; }}}};

std::string keys_of(CutterType type) {
  std::string all;
  for (std::size_t i = 0; i < kKeys.size(); ++i)
    if (kKeys[i].fits(type))
      all += (all.empty() ? "" : i + 1 < kKeys.size() ? ", " : " or ") + std::string(kKeys[i].word);
  return all;
}

std::string with_article(CutterType type) {
  return std::string(type == CutterType::apt ? "an " : "a ") + name(type);
}

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
    const std::string near = meant_word(type, kTypeNames);
    text_.fail_at(0, "unknown cutter " + in_quotes(type),
                  near.empty() ? "flat, ball, bull, taper, drill or apt" : in_quotes(near));
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
    set(key, signed_value(key));
  }

  /// All but angles that may be level or lean inwards, lengths that may be on the axis, and corners
  /// that may be sharp, are greater than 0.
  double signed_value(const std::string& key) {
    const bool any =
        key == "a" || key == "b" || key == "e" || key == "f" || key == "ramp" ||
        (key == "r" && (cutter_.type == CutterType::apt || cutter_.type == CutterType::taper));
    return any ? text_.number(",", key) : text_.positive(",", key);
  }

  void set(const std::string& key, double value) {
    if (key == "D") cutter_.diameter_mm = value;
    if (key == "r") cutter_.corner_radius_mm = value;
    if (key == "angle" && cutter_.type == CutterType::taper) cutter_.taper_angle_deg = value;
    if (key == "angle" && cutter_.type == CutterType::drill)
      cutter_.tip_angle_deg = (180 - value) / 2;
    if (key == "e") centre_radius_mm_ = value;
    if (key == "f") centre_height_mm_ = value;
    if (key == "a") cutter_.tip_angle_deg = value;
    if (key == "b") cutter_.taper_angle_deg = value;
    if (key == "L") cutter_.flute_length_mm = value;
    if (key == "ramp") cutter_.steepest_descent_deg = value;
  }

  void require_known(const std::string& key, std::size_t begin) const {
    std::array<std::string_view, kKeys.size()> words;
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
      words[i] = kKeys[i].word;
      if (key != words[i]) continue;
      if (!kKeys[i].fits(cutter_.type))
        text_.fail_at(begin, with_article(cutter_.type) + " cutter has no '" + key + "'",
                      keys_of(cutter_.type));
      return;
    }
    const std::string near = meant_word(key, words);
    text_.fail_at(begin, "unknown key " + in_quotes(key),
                  near.empty() ? keys_of(cutter_.type) : in_quotes(near));
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
    if (cutter_.type == CutterType::taper || cutter_.type == CutterType::drill)
      require_key("angle");
    if (cutter_.type == CutterType::ball) cutter_.corner_radius_mm = cutter_.radius_mm();
    if (!places_.contains("L"))
      cutter_.flute_length_mm = kDefaultFluteDiameters * cutter_.diameter_mm;
    try {
      require_valid(cutter_);
      require_centre(cutter_, centre_radius_mm_ ? &*centre_radius_mm_ : nullptr,
                     centre_height_mm_ ? &*centre_height_mm_ : nullptr);
    } catch (const std::invalid_argument& problem) {
      text_.fail_at(place_of(problem.what()), problem.what(), "figures that make a cutter");
    }
  }

  void require_key(const std::string& key) const {
    if (!places_.contains(key))
      text_.fail_at(text_.position(), with_article(cutter_.type) + " cutter needs '" + key + "='",
                    "it");
  }

  /// The value that a complaint of require_valid or require_centre is about.
  std::size_t place_of(std::string_view problem) const {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kAbout = {
        {{"corner", "r"},
         {"flute", "L"},
         {"taper", "angle"},
         {"point", "angle"},
         {"tip", "a"},
         {"side", "b"},
         {"steepest", "ramp"},
         {"e ", "e"},
         {"f ", "f"},
         {"", "D"}}};
    const auto about = std::find_if(kAbout.begin(), kAbout.end(), [&](const auto& entry) {
      return problem.starts_with(entry.first);
    });
    const auto found = places_.find(std::string(about->second));
    return found == places_.end() ? 0 : found->second;
  }

  SpecText text_;
  Cutter cutter_;
  std::optional<double> centre_radius_mm_, centre_height_mm_;  ///< as stated
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

/// What stands between the diameter and the flute length.
std::string shape_text(const Cutter& cutter) {
  const auto figure = [](const char* key, double value) {
    return value == 0 ? std::string() : std::string(key) + shortest(value);
  };
  switch (cutter.type) {
    case CutterType::flat:
    case CutterType::ball:
      return {};
    case CutterType::bull:
      return figure(",r=", cutter.corner_radius_mm);
    case CutterType::taper:
      return figure(",r=", cutter.corner_radius_mm) + figure(",angle=", cutter.taper_angle_deg);
    case CutterType::drill:
      return ",angle=" + shortest(180 - 2 * cutter.tip_angle_deg);
    case CutterType::apt:
      break;
  }
  return figure(",r=", cutter.corner_radius_mm) + figure(",a=", cutter.tip_angle_deg) +
         figure(",b=", cutter.taper_angle_deg);
}

}  // namespace

Cutter parse_cutter(std::string_view text) {
  return CutterText(text).read();
}

std::string to_text(const Cutter& cutter) {
  std::string text = std::string(name(cutter.type)) + ":D=" + shortest(cutter.diameter_mm);
  text += shape_text(cutter) + ",L=" + shortest(cutter.flute_length_mm);
  if (cutter.steepest_descent_deg != 90) text += ",ramp=" + shortest(cutter.steepest_descent_deg);
  return text + parts_text("shank", cutter.shank) + parts_text("holder", cutter.holder);
}

}  // namespace limitgauge::model
