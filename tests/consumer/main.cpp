// certify CAGE.obj PROGRAM.ngc CUTTER STOCK: exit code 0 where the program is proven good.
#include <limitgauge/model/gcode/program_path.h>
#include <limitgauge/model/part/cage_obj.h>
#include <limitgauge/verifier/gate/verify.h>

#include <iostream>

using namespace limitgauge;

int main(int argc, char** argv) try {
  if (argc != 5) throw std::invalid_argument("certify CAGE.obj PROGRAM.ngc CUTTER STOCK");
  const verifier::ReferenceSurface surface(model::read_cage_obj(argv[1]));
  verifier::StageCheck check;
  check.limits.has_gouge = check.limits.has_uncut = true;
  check.limits.gouge_mm = check.limits.uncut_mm = 0.03;
  check.resolution_mm = verifier::automatic_resolution_mm(check.limits);

  const model::Program program = model::read_program(argv[2]);
  const double chord_error_mm = check.resolution_mm / 4;  // of arcs, part of the bound
  const verifier::Pass pass{
      model::parse_cutter(argv[3]),
      std::make_shared<const model::Toolpath>(to_toolpath(program, chord_error_mm))};
  const verifier::StageDeviation deviation = measure_stage(
      surface, model::parse_stock(argv[4]), {&pass, 1}, nullptr, check, model::RunControl{2});
  const verifier::GateDecision decision = decide(deviation, check.limits);

  std::cout << "gouge [" << deviation.gouge_mm.low << ", " << deviation.gouge_mm.high << "] mm\n"
            << "uncut [" << deviation.uncut_mm.low << ", " << deviation.uncut_mm.high << "] mm\n"
            << "verdict " << name(decision.verdict) << '\n';
  for (const std::string& reason : decision.reasons) std::cout << "  " << reason << '\n';
  return decision.verdict == verifier::Verdict::pass ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 3;
}
