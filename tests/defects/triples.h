#pragma once

#include <string>
#include <vector>

#include "tests/defects/oracle.h"
#include "verifier/gate/verify.h"

namespace limitgauge::tests::defects {

/// A surface, one to three passes over it, and what they are judged by, made from a number.
struct Triple {
  std::string name;
  model::Cage cage;
  model::BoxStock stock;
  std::vector<verifier::Pass> passes;
  verifier::StageCheck check;
};
Triple random_triple(unsigned seed);

/// What oracle and certificate say of a triple, and where they contradict each other: nowhere.
struct TripleResult {
  struct Side {
    verifier::Interval certified;
    double sure_mm = 0;  ///< some sample has this for certain
  };
  Side gouge, uncut, missing;
  std::vector<std::string> contradictions;
  double oracle_seconds = 0, verifier_seconds = 0;
};
TripleResult hold_against_oracle(const Triple& triple);

}  // namespace limitgauge::tests::defects
