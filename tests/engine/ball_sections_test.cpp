#include "engine/strategy/locations/ball_sections.h"

#include <algorithm>
#include <string>
#include <utility>

#include "engine/strategy/rows/ball_rows.h"
#include "engine/surface/finish_model.h"
#include "model/part/cage_obj.h"
#include "tests/engine/strategy_parts.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"

using namespace limitgauge;
using namespace engine::strategy;

namespace {

/// A part's model and a finish by a ball whose rows are `rows` to its width.
struct BallPart {
  engine::surface::FinishModel finish;
  StageRequest request;

  BallPart(const std::string& cage, double rows)
      : finish(model::read_cage_obj(tests::fixtures() / (cage + ".obj")), {0.02, 2, 8}, {}),
        request(test::finish_request(finish.patches().bounding_box(), "ball:D=4")) {
    const model::Vec3 size = finish.patches().bounding_box().size();
    request.cut.step_mm = std::max(size.x, size.y) / rows;
    request.cut.angle_deg = 30;
  }
  BallSections sections(std::size_t most_points, const model::RunControl& control = {}) const {
    return {finish.patches(), request, DriveFrame(request.cut.angle_deg), 0, control, most_points};
  }
};

std::vector<std::vector<std::vector<PlanePoint>>> runs_of(const std::vector<Envelope>& envelopes) {
  std::vector<std::vector<std::vector<PlanePoint>>> runs;
  for (const Envelope& envelope : envelopes) runs.push_back(envelope.runs);
  return runs;
}

std::vector<std::pair<double, std::vector<std::vector<Vec3>>>> lines_of_rows(
    const DriveRows& made) {
  std::vector<std::pair<double, std::vector<std::vector<Vec3>>>> lines;
  for (const DriveRow& row : made.rows) lines.emplace_back(row.across_mm, row.runs);
  return lines;
}

constexpr std::size_t kAll = 100000000;

}  // namespace

TEST_CASE("rows by strips are those of one strip to the last bit", "[property][zigzag]") {
  // Open and closed parts, creases, corners, holes, extraordinary corners, neighbours four depths
  // apart.
  const std::string cage =
      GENERATE("cages/quick-dome", "cages/ring", "cages/valley", "cages/wave",
               "torture/crease-ridge", "torture/star-12", "torture/uneven-depths");
  INFO(cage);
  const BallPart part(cage, 40);
  const BallSections whole = part.sections(kAll);
  const std::vector<double> across = even_rows(whole, part.request.cut.step_mm);
  REQUIRE(whole.strips(across).size() == 1);
  const std::size_t points = whole.strips(across).front().points;
  const auto expected = runs_of(whole.envelopes(across, {}));
  const auto rows =
      lines_of_rows(make_ball_rows(part.finish.patches(), part.request, {}, {}, kAll));
  REQUIRE(rows.size() > 20);
  for (const unsigned threads : {1U, 3U})
    for (const std::size_t most : {std::size_t{1}, points / 2, points * 3 / 4}) {
      model::RunControl control;
      control.threads = threads;
      const BallSections strips = part.sections(most, control);
      CHECK(strips.strips(across).size() > 1);
      CHECK(runs_of(strips.envelopes(across, control)) == expected);
      CHECK(lines_of_rows(make_ball_rows(part.finish.patches(), part.request, control, {}, most)) ==
            rows);
    }
}

TEST_CASE("rows of a scallop height by strips are those of one strip", "[property][zigzag]") {
  BallPart part("cages/valley", 20);
  part.request.cut.scallop_mm = 0.02;
  const auto rows =
      lines_of_rows(make_ball_rows(part.finish.patches(), part.request, {}, {}, kAll));
  CHECK(lines_of_rows(make_ball_rows(part.finish.patches(), part.request, {}, {}, 5000)) == rows);
}

TEST_CASE("the grids that are held while rows are cut stay within their bound",
          "[property][zigzag]") {
  const std::string cage = GENERATE("cages/aircraft", "torture/egg-crate");
  INFO(cage);
  const BallPart part(cage, 60);
  const BallSections whole = part.sections(kAll);
  const std::vector<double> across = even_rows(whole, part.request.cut.step_mm);
  const std::size_t all = whole.strips(across).front().points;
  // A plane meets less than half of either part; strips may take a third, or as little as they can.
  for (const std::size_t most : {all / 3, std::size_t{1}}) {
    const BallSections strips = part.sections(most);
    std::size_t worst = 0;
    for (const double place : across)
      worst = std::max(worst, strips.strips(std::vector{place}).front().points);
    REQUIRE(worst < all / 2);
    const auto nothing = [](std::size_t, const Envelope&) {};
    CHECK(strips.each_envelope(across, {}, nothing) <= std::max(most, worst));
  }
}
