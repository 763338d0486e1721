#include "verifier/gate/stage_pieces.h"

#include <algorithm>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/rasters.h"
#include "verifier/reach/reach_entries.h"

namespace limitgauge::verifier {
namespace {

using namespace tests;

const model::Stock kPieceBlock = model::BoxStock{{-20, -20, -10}, {40, 40, 20}};
constexpr double kBowlBend = 0.2;

/// A bowl, cut by two balls that its bottom is too narrow for, by one more than by the other.
struct Bowl {
  ReferenceSurface surface{paraboloid_cage(3, kBowlBend)};
  std::vector<Pass> passes;
  StageCheck check;

  Bowl() {
    for (const double radius : {3.0, 2.7})
      passes.push_back({ball_cutter(radius), shared(raster(3, 0.5, 0.5, [](double x, double y) {
                          return kBowlBend * (x * x + y * y) + 0.3;
                        }))});
    check.resolution_mm = 0.05;
    check.field_spacing_mm = 0.5;
    check.limits = {true, true, false, 0.05, 0.2, 0};
  }
};

/// Does pieces as other processes would: each from bytes, on other threads.
class ByBytes : public PieceWorkers {
 public:
  ByBytes(const Bowl& bowl, std::uint32_t parts) : bowl_(bowl), parts_(parts) {}
  std::uint32_t parts() const override { return parts_; }
  std::vector<std::string> work(std::span<const StagePiece> pieces,
                                const std::string& reach) override {
    std::vector<std::string> out;
    for (const StagePiece& piece : pieces) {
      const auto told = piece_of(to_text(piece));
      REQUIRE(told);
      out.push_back(do_piece(bowl_.surface, kPieceBlock, bowl_.passes, bowl_.check, *told, reach,
                             {1 + piece.part % 2, nullptr, {}}));
    }
    done += pieces.size();
    return out;
  }
  std::size_t done = 0;

 private:
  const Bowl& bowl_;
  std::uint32_t parts_;
};

bool same(const Interval& a, const Interval& b) {
  return a.low == b.low && a.high == b.high;
}

void check_same(const StageDeviation& a, const StageDeviation& b) {
  CHECK(same(a.gouge_mm, b.gouge_mm));
  CHECK(same(a.uncut_mm, b.uncut_mm));
  CHECK(same(a.missing_stock_mm, b.missing_stock_mm));
  CHECK(same(a.unavoidable_uncut_mm, b.unavoidable_uncut_mm));
  CHECK(a.cells == b.cells);
  CHECK(a.coverage == b.coverage);
  CHECK(a.rms_mm == b.rms_mm);
  CHECK(a.proven_reach.reachable_mm2 == b.proven_reach.reachable_mm2);
  CHECK(a.proven_reach.unreachable_mm2 == b.proven_reach.unreachable_mm2);
  CHECK(a.proven_reach.undecided_mm2 == b.proven_reach.undecided_mm2);
  REQUIRE(a.uncuts.size() == b.uncuts.size());
  for (std::size_t i = 0; i < a.uncuts.size(); ++i) {
    CHECK(a.uncuts[i].depth_mm == b.uncuts[i].depth_mm);
    CHECK(a.uncuts[i].line == b.uncuts[i].line);
  }
  REQUIRE(a.field.samples.size() == b.field.samples.size());
  const auto differs = [](const DeviationField::Sample& x, const DeviationField::Sample& y) {
    return x.deviation_mm != y.deviation_mm || x.reachable != y.reachable ||
           x.raw_stock != y.raw_stock || x.stage != y.stage || x.move != y.move || x.line != y.line;
  };
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.field.samples.size(); ++i)
    different += differs(a.field.samples[i], b.field.samples[i]);
  CHECK(different == 0);
}

bool same_entry(const ReachMap::Entry& a, const ReachMap::Entry& b) {
  return a.cell.whole == b.cell.whole && a.cell.u == b.cell.u && a.cell.v == b.cell.v &&
         a.cell.size_u == b.cell.size_u && a.cell.size_v == b.cell.size_v && a.reach == b.reach &&
         a.cutter == b.cutter && a.area_mm2 == b.area_mm2;
}

}  // namespace

TEST_CASE("a stage that is measured in pieces has the figures of one that is not", "[unit][slow]") {
  const Bowl bowl;
  const StageDeviation whole =
      measure_stage(bowl.surface, kPieceBlock, bowl.passes, nullptr, bowl.check, {2});
  // Both classes, and something left to find, or nothing would be shared out here.
  CHECK(whole.proven_reach.reachable_mm2 > 0);
  CHECK(whole.proven_reach.unreachable_mm2 + whole.proven_reach.undecided_mm2 > 0);
  CHECK(!whole.uncuts.empty());
  for (const std::uint32_t parts : {2U, 7U}) {
    ByBytes workers(bowl, parts);
    check_same(whole, measure_stage(bowl.surface, kPieceBlock, bowl.passes, nullptr, bowl.check,
                                    {2}, &workers));
    CHECK(workers.done == 2 * parts + 3);
  }
}

TEST_CASE("groups of cells add up to the whole reach map, whenever the effort ends", "[unit]") {
  const Bowl bowl;
  const SurfaceCells cells(bowl.surface.tree(), 1);
  std::vector<Reachability> cutters;
  for (const Pass& pass : bowl.passes) cutters.emplace_back(cells, pass.cutter, 0, kContact_mm);
  const auto count = static_cast<std::uint32_t>(cells.cells().size());
  for (const std::size_t effort : {std::size_t{1}, std::size_t{count} + 40, std::size_t{1000}}) {
    const std::vector<ReachOptions> options(cutters.size(), {0.05, effort});
    const ReachMap whole = classify_reach(cells, cutters, options, {2});
    ReachRecords all;
    for (std::uint32_t part = 0; part < 3; ++part) {
      ReachRecords records;
      classify_reach(cells, cutters, options, {1},
                     {count * part / 3, count * (part + 1) / 3, &records, nullptr});
      const auto read = ReachRecords::of_bytes(records.to_bytes());
      REQUIRE(read);
      all.add(*read);
    }
    ReachSharing known;
    known.known = &all;
    const ReachMap gathered = classify_reach(cells, cutters, options, {2}, known);
    CHECK(std::equal(whole.entries().begin(), whole.entries().end(), gathered.entries().begin(),
                     gathered.entries().end(), same_entry));
    const auto entries = entries_of_bytes(entries_to_bytes(whole.entries()));
    REQUIRE(entries);
    CHECK(std::equal(whole.entries().begin(), whole.entries().end(), entries->begin(),
                     entries->end(), same_entry));
  }
}

TEST_CASE("bytes that no piece came to are refused", "[unit]") {
  const std::string records = ReachRecords().to_bytes();
  CHECK(ReachRecords::of_bytes(records));
  CHECK_FALSE(ReachRecords::of_bytes(records + "x"));
  CHECK_FALSE(ReachRecords::of_bytes(records.substr(0, records.size() - 1)));
  CHECK_FALSE(entries_of_bytes("limitgauge reach map 1\n\xff\xff\xff\xff\xff\xff\xff\xff"));
  CHECK_THROWS_AS(certificate_of_bytes("limitgauge"), std::invalid_argument);
  DeviationField field;
  field.samples.resize(3);
  CHECK_THROWS_AS(gathered_field(field, {}, {}), std::invalid_argument);
  for (const char* text : {"", "reach", "reach 1", "reach 1 1", "reach 0 0", "reach -1 2",
                           "reach 0 2 ", "gouge 0", "flood 0 1"})
    CHECK_FALSE(piece_of(text));
  CHECK(piece_of("field 1 2")->kind == StagePiece::Kind::field);
}

}  // namespace limitgauge::verifier
