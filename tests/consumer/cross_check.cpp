// cross_check CAGE.obj PROGRAM.ngc CUTTER STOCK: the certificate held against the simulated stock.
#include <limitgauge/model/gcode/program_path.h>
#include <limitgauge/model/part/cage_obj.h>
#include <limitgauge/simulator/instrument/stock_rays.h>
#include <limitgauge/verifier/gate/verify.h>

#include <iostream>

using namespace limitgauge;

/// The simulator's rays as the verifier asks them.
class Probe : public verifier::StockProbe {
 public:
  explicit Probe(simulator::StockModel stock) : rays_(std::move(stock)) {}
  Run run(const model::Vec3& from, const model::Vec3& along, double limit_mm) const override {
    const simulator::StockRays::Run r = rays_.run(from, along, limit_mm);
    return {r.material, r.length_mm, r.ends, r.error_mm};
  }
  double spacing_mm() const override { return rays_.voxel_mm(); }

 private:
  simulator::StockRays rays_;
};

int main(int argc, char** argv) try {
  if (argc != 5) throw std::invalid_argument("cross_check CAGE.obj PROGRAM.ngc CUTTER STOCK");
  const verifier::ReferenceSurface surface(model::read_cage_obj(argv[1]));
  const auto path = std::make_shared<const model::Toolpath>(
      to_toolpath(model::read_program(argv[2]), /* chord error, mm */ 0.001));
  const model::Cutter cutter = model::parse_cutter(argv[3]);
  const model::Stock raw = model::parse_stock(argv[4]);
  const model::RunControl control{2};

  const double voxel_mm = 0.25;
  const std::size_t memory_bytes = std::size_t{1} << 30;
  const simulator::StockModel block(raw, voxel_mm, memory_bytes, control);
  const Probe probe(block.cut({cutter, path}, control));

  verifier::StageCheck check;
  check.resolution_mm = 0.005;
  const verifier::Pass pass{cutter, path};
  // Throws InstrumentDisagreement where the two contradict each other.
  const verifier::StageDeviation d =
      measure_stage(surface, raw, {&pass, 1}, &probe, check, control);
  std::cout << "certified uncut [" << d.uncut_mm.low << ", " << d.uncut_mm.high
            << "] mm, rays into the stock read " << d.voxel_uncut_mm << " mm\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 3;
}
