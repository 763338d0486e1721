#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "verifier/certificate/certificate.h"
#include "verifier/gate/deviation_field.h"
#include "verifier/gate/field_samples.h"
#include "verifier/gate/verify.h"
#include "verifier/reach/reach_map.h"

namespace limitgauge::verifier {

class StageScene;

/// A piece of a stage's measurement: what comes of it depends on the stage alone and, of some
/// kinds, on the whole reach map, not on any other piece.
struct StagePiece {
  enum class Kind : std::uint8_t {
    reach,          ///< what can be touched of a group of cells
    gouge,          ///< a certificate, whole: its batches depend on each other
    missing_stock,  ///< likewise
    uncut,          ///< likewise; needs the reach map
    field,          ///< some of the samples; needs the reach map
  };
  Kind kind = Kind::reach;
  std::uint32_t part = 0, parts = 1;  ///< reach and field are cut into parts
};
std::string to_text(const StagePiece& piece);  ///< "reach 0 8"
/// Nothing for a text that is not to_text() of a piece.
std::optional<StagePiece> piece_of(std::string_view text);

/// Whoever has pieces of one stage done, in other processes.
class PieceWorkers {
 public:
  virtual ~PieceWorkers() = default;
  /// Into how many parts reach and field are to be cut; 1 or more.
  virtual std::uint32_t parts() const = 0;
  /// What do_piece() makes of each of them, in their order. `reach` is the reach map as bytes,
  /// empty as long as there is none. Throws model::ResourceError where a piece is not done,
  /// Interrupted.
  virtual std::vector<std::string> work(std::span<const StagePiece> pieces,
                                        const std::string& reach) = 0;
};

/// Does a piece of measuring the stage whose pass is the last of `passes`. The same for any number
/// of threads. Throws std::invalid_argument for a reach map that is none, Interrupted.
std::string do_piece(const ReferenceSurface& surface, const model::Stock& raw_stock,
                     std::span<const Pass> passes, const StageCheck& check, const StagePiece& piece,
                     std::string_view reach, const model::RunControl& control);

/// Pieces that are worked on at the same time.
class PieceRound {
 public:
  explicit PieceRound(PieceWorkers* workers) : workers_(workers) {}
  /// Has all parts of these kinds done.
  void ask(std::initializer_list<StagePiece::Kind> kinds, const std::string& reach);
  /// What came of one kind, part by part.
  std::vector<std::string> all(StagePiece::Kind kind) const;

 private:
  PieceWorkers* workers_;
  std::vector<StagePiece> pieces_;
  std::vector<std::string> outcomes_;
};

/// The whole of what parts have found. Throw std::invalid_argument for bytes that are none of
/// theirs.
ReachMap gathered_reach(const StageScene& scene, const std::vector<std::string>& parts,
                        const model::RunControl& control);
std::vector<ReachQuery::Touch> gathered_field(DeviationField& field,
                                              const std::vector<std::string>& parts,
                                              std::span<const Pass> passes);
Certificate certificate_of_bytes(std::string_view bytes);
/// The three certificates, worked out here.
Certificate missing_stock_of(const StageScene& scene, const model::RunControl& control);
Certificate uncut_of(const StageScene& scene, const ReachQuery& reach,
                     const model::RunControl& control);
/// Where the raw stock is proven not to cover the part the stage fails for that. What gouges there
/// are is looked for with less effort: past the block nothing but S ends a run, and no proof tells
/// what was swept right before S from what was swept behind it, however small a cell is.
Certificate gouge_of(const StageScene& scene, const Certificate& missing,
                     const model::RunControl& control);

}  // namespace limitgauge::verifier
