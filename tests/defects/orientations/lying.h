#pragma once

#include <random>
#include <string>
#include <vector>

#include "tests/defects/orientations/posting.h"
#include "tests/defects/orientations/stated_setup.h"

namespace limitgauge::tests::defects {

/// What the suite plants where a part lies turned. The last four are of orientations alone: an
/// angle or a place that the program or the job has wrong, a turn the wrong way round, and an axis
/// word that the post-processor lost.
enum class LyingKind {
  sunk_pass,
  missing_pass,
  rapid_through,
  wrong_angle,
  wrong_place,
  wrong_sign,
  lost_word
};
inline constexpr LyingKind kLyingKinds[] = {LyingKind::sunk_pass,     LyingKind::missing_pass,
                                            LyingKind::rapid_through, LyingKind::wrong_angle,
                                            LyingKind::wrong_place,   LyingKind::wrong_sign,
                                            LyingKind::lost_word};
const char* name(LyingKind kind);
/// Whether it befalls a row or a move of the program, and not all of it.
bool is_local(LyingKind kind);

/// What holds the part: a vice that stands still, or a machine with rotary axes.
enum class Holding { still, table_table, head_table, head_head };
inline constexpr Holding kHoldings[] = {Holding::still, Holding::table_table, Holding::head_table,
                                        Holding::head_head};
const char* name(Holding holding);

/// How a part lies in its file and in the machine, and how its program is made. "Nominal" is the
/// frame that the rows are laid in, in which the tool should stand along +Z.
struct Lying {
  StatedSetup setup;  ///< as the job states it
  model::Pose file;   ///< nominal to the frame of the part's file
  Holding holding = Holding::still;
  Machine machine;          ///< as the job states it; of a part that lies still none
  Posting posting;          ///< what the post-processor believes; of a still part `lying` alone
  std::size_t tilting = 0;  ///< the axis, or the word of a plane, that tilts the tool

  /// Nominal to the work's frame with all axes at 0, by what the job states.
  model::Pose truly() const { return setup.pose() * file; }
  /// The program, and what it does as the job has everything.
  Posted posted(const NcText& program) const;
  std::string label() const;
};

/// A way to lie, drawn at random: any orientation, an origin within some millimetres.
Lying random_lying(Holding holding, std::mt19937& random);

/// Has the job or the program wrong by `size`: degrees, mm, or nothing that it goes by.
void harm(Lying& lying, LyingKind kind, double size, std::mt19937& random);

/// Any number of [a, b): std distributions differ between libraries.
double between(std::mt19937& random, double a, double b);

}  // namespace limitgauge::tests::defects
