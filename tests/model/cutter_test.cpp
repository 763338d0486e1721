#include "engine/model/cutter.h"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "engine/model/error.h"
#include "tests/model/fixture_files.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

std::string error_of(const std::string& text) {
  return message_of<InputError>([&] { parse_cutter(text); });
}

bool same_shape(const Cutter& a, const Cutter& b) {
  const auto same_parts = [](const auto& p, const auto& q) {
    return std::equal(p.begin(), p.end(), q.begin(), q.end(), [](const auto& x, const auto& y) {
      return x.diameter_mm == y.diameter_mm && x.length_mm == y.length_mm;
    });
  };
  return a.type == b.type && a.diameter_mm == b.diameter_mm &&
         a.corner_radius_mm == b.corner_radius_mm && a.taper_angle_deg == b.taper_angle_deg &&
         a.flute_length_mm == b.flute_length_mm && same_parts(a.shank, b.shank) &&
         same_parts(a.holder, b.holder);
}

}  // namespace

TEST_CASE("the four cutters of the contract", "[unit][cutter]") {
  const Cutter ball = parse_cutter("ball:D=6");
  CHECK(ball.type == CutterType::ball);
  CHECK(ball.diameter_mm == 6);
  CHECK(ball.corner_radius_mm == 3);
  CHECK(ball.flute_length_mm == 24);
  CHECK(ball.id == "ball:D=6");
  CHECK(parse_cutter("flat:D=8").corner_radius_mm == 0);
  CHECK(parse_cutter("bull:D=8,r=1").corner_radius_mm == 1);
  CHECK(parse_cutter("taper:D=1,r=0.5,angle=5").taper_angle_deg == 5);
}

TEST_CASE("shank and holder parts are listed from the tip up", "[unit][cutter]") {
  const Cutter cutter =
      parse_cutter("flat:D=8,shank=7.5:10,holder=20:5,L=25,shank=8:40,holder=40:30");
  CHECK(cutter.flute_length_mm == 25);
  REQUIRE(cutter.shank.size() == 2);
  CHECK(cutter.shank[0].diameter_mm == 7.5);
  CHECK(cutter.shank[1].length_mm == 40);
  REQUIRE(cutter.holder.size() == 2);
  CHECK(cutter.holder[1].diameter_mm == 40);
}

TEST_CASE("cutter texts that are wrong, each with its column", "[unit][cutter]") {
  CHECK(error_of("boll:D=6") == "tool:1:1: error: unknown cutter 'boll'; expected 'ball'");
  CHECK(error_of("drill:D=6") ==
        "tool:1:1: error: unknown cutter 'drill'; expected flat, ball, bull or taper");
  CHECK(error_of("ball") == "tool:1:5: error: the cutter has no figures; expected ':D=6'");
  CHECK(error_of("ball:") ==
        "tool:1:6: error: unknown key ''; expected D, r, angle, L, shank or holder");
  CHECK(error_of("ball:d=6") == "tool:1:6: error: unknown key 'd'; expected 'D'");
  CHECK(error_of("ball:D=6,shnk=6:1") == "tool:1:10: error: unknown key 'shnk'; expected 'shank'");
  CHECK(error_of("ball:D") == "tool:1:7: error: 'D' has no value; expected '='");
  CHECK(error_of("ball:D=") ==
        "tool:1:8: error: D '' is not a number; expected a number of millimetres or degrees");
  CHECK(error_of("ball:D=6mm") ==
        "tool:1:8: error: D '6mm' is not a number; expected a number of millimetres or degrees");
  CHECK(error_of("ball:D=0") == "tool:1:8: error: D is 0; expected more than 0");
  CHECK(error_of("ball:D=-6") == "tool:1:8: error: D is -6; expected more than 0");
  CHECK(error_of("ball:D=6,D=6") == "tool:1:10: error: 'D' stands twice; expected it once");
  CHECK(error_of("ball:D=6,r=3") ==
        "tool:1:10: error: a ball cutter has no 'r'; expected D, L, shank or holder");
  CHECK(error_of("bull:D=6") == "tool:1:9: error: a bull cutter needs 'r='; expected it");
  CHECK(error_of("taper:D=1,r=0.5") ==
        "tool:1:16: error: a taper cutter needs 'angle='; expected it");
  CHECK(error_of("bull:D=6,r=4") ==
        "tool:1:12: error: corner radius must not exceed half the "
        "diameter; expected figures that make a cutter");
  CHECK(error_of("ball:D=6,L=2") ==
        "tool:1:12: error: flute length must reach to the end of the "
        "corner radius; expected figures that make a cutter");
  CHECK(error_of("taper:D=1,angle=90") ==
        "tool:1:17: error: taper angle must lie between 0 and 90 "
        "degrees; expected figures that make a cutter");
  CHECK(error_of("ball:D=6,shank=6") ==
        "tool:1:17: error: 'shank' has no length; expected 'shank=D:L'");
  CHECK(error_of("ball:D=6,holder=6:0") ==
        "tool:1:19: error: holder length is 0; expected more than 0");
  CHECK(error_of("ball:D=6,") ==
        "tool:1:10: error: unknown key ''; expected D, r, angle, L, shank or holder");
}

TEST_CASE("figures that make no cutter are refused", "[unit][cutter]") {
  const Cutter good = parse_cutter("bull:D=8,r=1,shank=8:40");
  CHECK_NOTHROW(require_valid(good));
  const auto broken = [&](auto change) {
    Cutter cutter = good;
    change(cutter);
    return message_of<std::invalid_argument>([&] { require_valid(cutter); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(broken([](Cutter& c) { c.diameter_mm = 0; }) == "diameter must be greater than 0");
  CHECK(broken([&](Cutter& c) { c.diameter_mm = nan; }) == "diameter must be greater than 0");
  CHECK(broken([](Cutter& c) { c.corner_radius_mm = 4.1; }) ==
        "corner radius must not exceed half the diameter");
  CHECK(broken([](Cutter& c) { c.corner_radius_mm = 0; }) ==
        "corner radius of a bull cutter must be greater than 0");
  CHECK(broken([](Cutter& c) { c.corner_radius_mm = -1; }) == "corner radius must not be negative");
  CHECK(broken([&](Cutter& c) { c.corner_radius_mm = nan; }) ==
        "corner radius must not be negative");
  CHECK(broken([](Cutter& c) { c.type = CutterType::flat; }) ==
        "corner radius of a flat cutter must be 0");
  CHECK(broken([](Cutter& c) { c.type = CutterType::ball; }) ==
        "corner radius of a ball cutter must be half its diameter");
  CHECK(broken([](Cutter& c) { c.taper_angle_deg = 5; }) ==
        "taper angle of a cutter that is no taper must be 0");
  CHECK(broken([](Cutter& c) { c.flute_length_mm = 0.5; }) ==
        "flute length must reach to the end of the corner radius");
  CHECK(broken([](Cutter& c) { c.shank[0].length_mm = 0; }) ==
        "shank length must be greater than 0");
  CHECK(broken([&](Cutter& c) {
          c.holder = {{nan, 1}};
        }) == "holder diameter must be greater than 0");
}

TEST_CASE("the largest radius of a taper stands at the end of its flutes", "[unit][cutter]") {
  CHECK(largest_radius_mm(parse_cutter("ball:D=6")) == 3);
  // 45 degrees, sharp: one millimetre of radius a millimetre of height.
  CHECK(largest_radius_mm(parse_cutter("taper:D=2,angle=45,L=10")) == Approx(11).epsilon(1e-14));
  // A ball tip of radius 1 is tangent to the 30 degree cone at radius cos 30 and height 1 - sin 30.
  const double radius_mm = largest_radius_mm(parse_cutter("taper:D=2,r=1,angle=30,L=10.5"));
  CHECK(radius_mm == Approx(std::sqrt(0.75) + 10 / std::sqrt(3.0)).epsilon(1e-14));
}

TEST_CASE("any cutter is the same after to_text and parse_cutter", "[property][cutter]") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> part(0.01, 1);
  for (int round = 0; round < 500; ++round) {
    Cutter cutter;
    cutter.type = static_cast<CutterType>(random() % 4);
    cutter.diameter_mm = 20 * part(random);
    if (cutter.type == CutterType::ball) cutter.corner_radius_mm = cutter.radius_mm();
    if (cutter.type == CutterType::bull || (cutter.type == CutterType::taper && random() % 2 == 0))
      cutter.corner_radius_mm = cutter.radius_mm() * part(random);
    if (cutter.type == CutterType::taper) cutter.taper_angle_deg = 80 * part(random);
    cutter.flute_length_mm = cutter.diameter_mm * (0.5 + part(random));
    for (auto n = random() % 3; n > 0; --n) cutter.shank.push_back({part(random), part(random)});
    for (auto n = random() % 3; n > 0; --n)
      cutter.holder.push_back({50 * part(random), 50 * part(random)});
    CAPTURE(to_text(cutter));
    CHECK(same_shape(parse_cutter(to_text(cutter)), cutter));
  }
}
