#include "model/part/cutter.h"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "model/base/error.h"
#include "tests/model/fixture_files.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

std::string cutter_error_of(const std::string& text) {
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
         a.tip_angle_deg == b.tip_angle_deg && a.steepest_descent_deg == b.steepest_descent_deg &&
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
  CHECK(parse_cutter("taper:D=1,r=0,angle=5").corner_radius_mm == 0);
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
  CHECK(cutter_error_of("boll:D=6") == "tool:1:1: error: unknown cutter 'boll'; expected 'ball'");
  CHECK(
      cutter_error_of("lollipop:D=6") ==
      "tool:1:1: error: unknown cutter 'lollipop'; expected flat, ball, bull, taper, drill or apt");
  CHECK(cutter_error_of("ball") == "tool:1:5: error: the cutter has no figures; expected ':D=6'");
  CHECK(cutter_error_of("ball:") ==
        "tool:1:6: error: unknown key ''; expected D, L, ramp, shank or holder");
  CHECK(cutter_error_of("ball:d=6") == "tool:1:6: error: unknown key 'd'; expected 'D'");
  CHECK(cutter_error_of("ball:D=6,shnk=6:1") ==
        "tool:1:10: error: unknown key 'shnk'; expected 'shank'");
  CHECK(cutter_error_of("ball:D") == "tool:1:7: error: 'D' has no value; expected '='");
  CHECK(cutter_error_of("ball:D=") ==
        "tool:1:8: error: D '' is not a number; expected a number of millimetres or degrees");
  CHECK(cutter_error_of("ball:D=6mm") ==
        "tool:1:8: error: D '6mm' is not a number; expected a number of millimetres or degrees");
  CHECK(cutter_error_of("ball:D=0") == "tool:1:8: error: D is 0; expected more than 0");
  CHECK(cutter_error_of("ball:D=-6") == "tool:1:8: error: D is -6; expected more than 0");
  CHECK(cutter_error_of("ball:D=6,D=6") == "tool:1:10: error: 'D' stands twice; expected it once");
  CHECK(cutter_error_of("ball:D=6,r=3") ==
        "tool:1:10: error: a ball cutter has no 'r'; expected D, L, ramp, shank or holder");
  CHECK(cutter_error_of("bull:D=6") == "tool:1:9: error: a bull cutter needs 'r='; expected it");
  CHECK(cutter_error_of("taper:D=1,r=0.5") ==
        "tool:1:16: error: a taper cutter needs 'angle='; expected it");
  CHECK(cutter_error_of("bull:D=6,r=4") ==
        "tool:1:12: error: corner radius must not exceed half the "
        "diameter; expected figures that make a cutter");
  CHECK(cutter_error_of("ball:D=6,L=2") ==
        "tool:1:12: error: flute length must reach to the end of the "
        "corner radius; expected figures that make a cutter");
  CHECK(cutter_error_of("taper:D=1,angle=90") ==
        "tool:1:17: error: taper angle must lie between 0 and 90 "
        "degrees; expected figures that make a cutter");
  CHECK(cutter_error_of("ball:D=6,shank=6") ==
        "tool:1:17: error: 'shank' has no length; expected 'shank=D:L'");
  CHECK(cutter_error_of("ball:D=6,holder=6:0") ==
        "tool:1:19: error: holder length is 0; expected more than 0");
  CHECK(cutter_error_of("ball:D=6,") ==
        "tool:1:10: error: unknown key ''; expected D, L, ramp, shank or holder");
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

TEST_CASE("the largest radius of a side that leans inwards stands at the corner",
          "[unit][cutter]") {
  CHECK(largest_radius_mm(parse_cutter("drill:D=6,angle=118")) == 3);
  CHECK(largest_radius_mm(parse_cutter("apt:D=10,b=-45,L=3")) == 5);
  // 45 degrees inwards from a level bottom: e = 5 - r·cos 45 / (1 - sin 45).
  const double half = std::sqrt(0.5);
  CHECK(largest_radius_mm(parse_cutter("apt:D=10,r=1,b=-45,L=3")) ==
        Approx(5 - half / (1 - half) + 1).epsilon(1e-14));
  CHECK(largest_radius_mm(parse_cutter("apt:D=10,b=45,L=3")) == Approx(8).epsilon(1e-14));
}

TEST_CASE("drills and apt cutters from their texts", "[unit][cutter]") {
  const Cutter drill = parse_cutter("drill:D=6,angle=118,L=40,ramp=90");
  CHECK(drill.type == CutterType::drill);
  CHECK(drill.tip_angle_deg == 31);
  CHECK(drill.corner_radius_mm == 0);
  CHECK(drill.steepest_descent_deg == 90);
  CHECK(parse_cutter("flat:D=6,ramp=0").steepest_descent_deg == 0);
  CHECK(to_text(parse_cutter("flat:D=6,ramp=2.5")) == "flat:D=6,L=24,ramp=2.5");
  CHECK(to_text(drill) == "drill:D=6,angle=118,L=40");
  const Cutter apt = parse_cutter("apt:D=10,r=1,e=4,f=1,a=0,b=0,L=30");
  CHECK(apt.type == CutterType::apt);
  CHECK(to_text(apt) == "apt:D=10,r=1,L=30");
  CHECK(to_text(parse_cutter("apt:D=10,r=1,a=5,b=-10,L=9")) == "apt:D=10,r=1,a=5,b=-10,L=9");
  // Stated to the hundredth.
  CHECK_NOTHROW(parse_cutter("apt:D=10,r=1,e=3.991,L=30"));
}

TEST_CASE("drill and apt texts that make no cutter", "[unit][cutter]") {
  const auto has = [](const std::string& text, const std::string& message) {
    CAPTURE(text);
    CHECK_THAT(cutter_error_of(text), ContainsSubstring(message));
  };
  has("drill:D=6", "1:10: error: a drill cutter needs 'angle='");
  has("drill:D=6,angle=180", "1:17: error: point angle must lie between 0 and 180 degrees");
  has("drill:D=6,angle=181", "1:17: error: point angle");
  has("drill:D=6,angle=90,L=2", "1:22: error: flute length must reach to the end of the point");
  has("drill:D=6,angle=90,r=1", "1:20: error: a drill cutter has no 'r'; expected D, angle, L, ");
  has("apt:r=1", "an apt cutter needs 'D='");
  has("apt:D=10,r=-1", "1:12: error: corner radius must not be negative");
  has("apt:D=10,r=6", "1:12: error: corner radius does not fit between the axis and the side");
  has("apt:D=10,a=-1", "1:12: error: tip angle must be at least 0");
  has("apt:D=10,a=90", "1:12: error: tip angle must be at least 0 and less than 90");
  has("apt:D=10,b=90", "1:12: error: side angle must lie between -90 and 90");
  has("apt:D=10,a=50,b=40", "1:17: error: side angle and tip angle must make less than 90 degrees");
  has("apt:D=10,b=-45,L=5.1", "1:12: error: side angle closes the side below");
  has("apt:D=10,r=2,L=1", "1:16: error: flute length must reach to the end of the corner radius");
  has("apt:D=10,r=1,e=3.98", "1:16: error: e is 3.98, but the other figures make it 4");
  has("apt:D=10,r=1,f=1.02", "1:16: error: f is 1.02, but the other figures make it 1");
  has("apt:D=10,angle=3", "an apt cutter has no 'angle'; expected D, r, e, f, a, b, L, ramp");
  has("flat:D=10,ramp=91", "1:16: error: steepest descent must lie between 0 and 90 degrees");
  has("flat:D=10,ramp=-1", "steepest descent");
  has("ball:D=10,a=1", "a ball cutter has no 'a'");
}

TEST_CASE("drill and apt figures that make no cutter are refused", "[unit][cutter]") {
  const Cutter good = parse_cutter("apt:D=10,r=1,a=10,b=-5,L=20");
  const auto broken = [&](auto change) {
    Cutter cutter = good;
    change(cutter);
    return message_of<std::invalid_argument>([&] { require_valid(cutter); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(broken([&](Cutter& c) { c.tip_angle_deg = nan; }), ContainsSubstring("tip angle"));
  CHECK_THAT(broken([&](Cutter& c) { c.taper_angle_deg = nan; }), ContainsSubstring("side angle"));
  CHECK_THAT(broken([&](Cutter& c) { c.corner_radius_mm = nan; }), ContainsSubstring("corner"));
  CHECK_THAT(broken([&](Cutter& c) { c.flute_length_mm = nan; }), ContainsSubstring("flute"));
  CHECK_THAT(broken([&](Cutter& c) { c.steepest_descent_deg = nan; }),
             ContainsSubstring("steepest descent"));
  CHECK_THAT(broken([](Cutter& c) { c.type = CutterType::bull; }),
             ContainsSubstring("neither drill nor apt"));
  CHECK_THAT(broken([](Cutter& c) { c.type = CutterType::drill; }),
             ContainsSubstring("taper angle of a cutter that is no taper"));
  CHECK_THAT(broken([](Cutter& c) { c.type = CutterType::drill, c.taper_angle_deg = 0; }),
             ContainsSubstring("corner radius of a drill must be 0"));
}

TEST_CASE("seven figures of a cutter, and the cutter of seven figures", "[unit][cutter]") {
  for (const char* text :
       {"flat:D=8,L=20", "ball:D=6,L=20", "bull:D=8,r=1,L=20", "drill:D=6,angle=118,L=30",
        "apt:D=10,r=1,a=10,b=-5,L=20", "apt:D=10,r=2,b=30,L=20"}) {
    CAPTURE(text);
    const Cutter cutter = parse_cutter(text);
    CHECK(same_shape(cutter_of(seven_figures(cutter)), cutter));
  }
  // A taper's diameter is of its tip: as an apt cutter it has another, and the same figures.
  const SevenFigures taper = seven_figures(parse_cutter("taper:D=2,r=0.5,angle=10,L=20"));
  const SevenFigures same = seven_figures(cutter_of(taper));
  CHECK(same.centre_radius == Approx(taper.centre_radius).epsilon(1e-14));
  CHECK(same.centre_height == Approx(taper.centre_height).epsilon(1e-14));
  // The corner touches both lines: the bottom through the tip, the side through their meeting.
  const SevenFigures c = seven_figures(parse_cutter("apt:D=10,r=1.5,a=20,b=-15,L=9"));
  const double rad = std::acos(-1.0) / 180, a = 20 * rad, b = -15 * rad;
  CHECK(c.centre_height * std::cos(a) - c.centre_radius * std::sin(a) ==
        Approx(1.5).epsilon(1e-14));
  CHECK((5 - c.centre_radius) * std::cos(b) + (c.centre_height - 5 * std::tan(a)) * std::sin(b) ==
        Approx(1.5).epsilon(1e-14));
  SevenFigures off = c;
  off.centre_height += 0.02;
  CHECK_THAT(message_of<std::invalid_argument>([&] { cutter_of(off); }),
             ContainsSubstring("but the other figures make it"));
}

TEST_CASE("changed bytes of a cutter's text give a valid cutter or an error",
          "[property][cutter]") {
  const std::vector<std::string> whole = {"ball:D=6,L=20,shank=6:40,holder=20:5",
                                          "flat:D=8,ramp=3",
                                          "bull:D=8,r=1,L=9",
                                          "taper:D=1,r=0.5,angle=5,holder=9:9",
                                          "drill:D=6,angle=118,L=40",
                                          "apt:D=10,r=1,e=4,f=1,a=0,b=0,L=30",
                                          "apt:D=9,r=2,a=12,b=-20,L=11,ramp=0"};
  const std::string alphabet = "Drefab=,:.-+0123456789eLrampnglshkdo\xFF\0 \n";
  std::mt19937 random(23);
  int parsed = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text = whole[random() % whole.size()];
    for (auto n = 1 + random() % 3; n > 0 && !text.empty(); --n) {
      const std::size_t at = random() % text.size();
      // Every second text keeps its words, so that many of them are cutters.
      if (round % 2 == 0) {
        if (text[at] >= '0' && text[at] <= '9') text[at] = static_cast<char>('0' + random() % 10);
        continue;
      }
      switch (random() % 4) {
        case 0:
          text.erase(at, 1 + random() % 3);
          break;
        case 1:
          text.insert(at, 1, alphabet[random() % alphabet.size()]);
          break;
        case 2:
          text.insert(at, text.substr(random() % text.size(), random() % 9));
          break;
        default:
          text[at] = alphabet[random() % alphabet.size()];
      }
    }
    if (round % 50 == 0)
      for (char& c : text) c = static_cast<char>(random() % 256);
    CAPTURE(text);
    try {
      const Cutter cutter = parse_cutter(text);
      ++parsed;
      CHECK_NOTHROW(require_valid(cutter));
      CHECK(same_shape(parse_cutter(to_text(cutter)), cutter));
    } catch (const InputError& error) {
      CHECK(error.place().column > 0);
    }
  }
  CHECK(parsed > 1000);
}

TEST_CASE("any cutter is the same after to_text and parse_cutter", "[property][cutter]") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> part(0.01, 1);
  for (int round = 0; round < 500; ++round) {
    Cutter cutter;
    cutter.type = static_cast<CutterType>(random() % 6);
    cutter.diameter_mm = 20 * part(random);
    if (cutter.type == CutterType::ball) cutter.corner_radius_mm = cutter.radius_mm();
    if (cutter.type == CutterType::bull || (cutter.type == CutterType::taper && random() % 2 == 0))
      cutter.corner_radius_mm = cutter.radius_mm() * part(random);
    if (cutter.type == CutterType::taper) cutter.taper_angle_deg = 80 * part(random);
    // A point angle is written, and 180 degrees less twice a tip angle must not be rounded.
    if (cutter.type == CutterType::drill) cutter.tip_angle_deg = 90 - 64 * part(random) / 2;
    if (cutter.type == CutterType::apt) {
      cutter.corner_radius_mm = cutter.radius_mm() * part(random) / 4;
      cutter.tip_angle_deg = 20 * part(random);
      cutter.taper_angle_deg = 10 * part(random) - 5;
    }
    if (random() % 3 == 0) cutter.steepest_descent_deg = 90 * part(random);
    cutter.flute_length_mm = cutter.diameter_mm * (0.5 + part(random));
    if (cutter.type == CutterType::drill)
      cutter.flute_length_mm += seven_figures(cutter).centre_height;
    for (auto n = random() % 3; n > 0; --n) cutter.shank.push_back({part(random), part(random)});
    for (auto n = random() % 3; n > 0; --n)
      cutter.holder.push_back({50 * part(random), 50 * part(random)});
    CAPTURE(to_text(cutter));
    CHECK(same_shape(parse_cutter(to_text(cutter)), cutter));
  }
}
