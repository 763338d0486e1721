#pragma once

namespace limitgauge::tests {

/// Whether everything is to be looked at, or a share of it that serves on every change: set
/// LIMITGAUGE_THOROUGH (check.sh --full does) for all random cases and whole collections.
bool thorough();

/// How many random cases, or every which one of a collection.
inline int by_effort(int usual, int all) {
  return thorough() ? all : usual;
}

}  // namespace limitgauge::tests
