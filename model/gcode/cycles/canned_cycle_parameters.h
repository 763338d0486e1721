#pragma once

#include <optional>
#include <string>

#include "model/gcode/text/statement.h"

namespace limitgauge::model::gcode {

/// G73, G74, G81 to G89; `code` in tenths.
bool is_canned_cycle(int code);
/// Whether the cycle has a use for the word, beside X, Y, Z: R and L all, P the ones that dwell, Q
/// the ones that peck, I J K the back bore. Others are an error where nothing else of the block
/// takes them.
bool cycle_takes(int code, char letter);

/// The words of a canned cycle that stay from block to block, as programmed.
struct CycleParameters {
  std::optional<double> r, q, p, i, j, k;
  std::optional<double> bottom;  ///< of the axis along the tool
  bool r_is_step = false;        ///< from the initial level
  bool bottom_is_step = false;   ///< from R

  /// Takes what stands in the block, of G91 or not; `along` is the letter of the axis along the
  /// tool. LinuxCNC reads R and the bottom of earlier blocks by this block's mode as well.
  void take(const Statement& statement, int code, char along, bool incremental);
  /// Throws InputError for words that cycle `code` needs and that neither this block nor one before
  /// it gave, and for those that cannot be.
  void check(const Statement& statement, int code, char along) const;

 private:
  const std::optional<double>& of(char letter) const;
};

/// L; 1 where there is none. Throws InputError unless it is a whole number from 1 to `most`.
int holes_of(const Statement& statement, int most);

/// The word to show where one is missing: the cycle's code, or the first axis word.
const Word& blamed(const Statement& statement);
/// The word of `letter`, or where it is not in this block, blamed().
const Word& word_or_blamed(const Statement& statement, char letter);
/// `G83` for 830.
std::string cycle_name(int code);

}  // namespace limitgauge::model::gcode
