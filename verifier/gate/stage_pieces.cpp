#include "verifier/gate/stage_pieces.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "model/base/chunks.h"
#include "model/base/packed_bytes.h"
#include "verifier/gate/stage_scene.h"
#include "verifier/reach/reach_entries.h"

namespace limitgauge::verifier {
namespace {

constexpr std::array<const char*, 5> kKinds = {"reach", "gouge", "missing_stock", "uncut", "field"};
constexpr std::string_view kFieldBegin = "limitgauge samples 1\n";
constexpr std::string_view kCertificateBegin = "limitgauge certificate 1\n";
/// Cells that are looked at for gouges of a part that its raw stock does not cover: where that
/// fails the stage some hundred of each that no proof closes, and where nothing is limited enough
/// for a part whose path is clear of it all along.
constexpr std::size_t kCellsOnceFailed = 30'000, kCellsOnceUncovered = 500'000;
/// Bytes of a sample at least.
constexpr std::size_t kSampleBytes = 13;

bool is_cut_into_parts(StagePiece::Kind kind) {
  return kind == StagePiece::Kind::reach || kind == StagePiece::Kind::field;
}

struct Range {
  std::size_t begin = 0, end = 0;
};

/// Part `part` of `parts` of `count` things, which begins at a multiple of `chunk`.
Range range_of(std::size_t count, std::size_t chunk, std::uint32_t part, std::uint32_t parts) {
  const std::size_t chunks = model::chunk_count(count, chunk);
  return {std::min(count, chunks * part / parts * chunk),
          std::min(count, chunks * (part + 1) / parts * chunk)};
}

void pack_vec(model::Packer& out, const model::Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) out.number(v[axis]);
}

model::Vec3 unpack_vec(model::Unpacker& in) {
  model::Vec3 v;
  for (int axis = 0; axis < 3; ++axis) v[axis] = in.number<double>();
  return v;
}

std::string to_bytes(const Certificate& c) {
  model::Packer out;
  out.mark(kCertificateBegin);
  for (const double value : {c.figure_mm.low, c.figure_mm.high}) out.number(value);
  out.number(std::uint64_t{c.cells});
  out.number(static_cast<std::uint8_t>(c.reached_resolution + 2 * c.witness.has_value()));
  if (c.witness) {
    const Witness& w = *c.witness;
    out.number(std::int32_t{w.place.patch});
    for (const double value : {w.place.u, w.place.v, w.depth_mm}) out.number(value);
    pack_vec(out, w.place.point);
    pack_vec(out, w.normal);
    out.number(w.body.pass);
    out.number(w.body.index);
  }
  return out.take();
}

std::string reach_part(const StageScene& scene, const StagePiece& piece,
                       const model::RunControl& control) {
  const Range range = range_of(scene.cells.cells().size(), 1, piece.part, piece.parts);
  ReachRecords records;
  ReachSharing sharing;
  sharing.first = static_cast<std::uint32_t>(range.begin);
  sharing.end = static_cast<std::uint32_t>(range.end);
  sharing.record = &records;
  classify_reach(scene.cells, scene.by.searches, scene.by.efforts, control, sharing);
  return records.to_bytes();
}

/// Fields of the samples that measuring fills in. The program's line is that of the move.
std::string field_part(const StageScene& scene, const ReferenceSurface& surface,
                       const StageCheck& check, std::span<const Pass> passes,
                       const StagePiece& piece, const ReachQuery& reach,
                       const model::RunControl& control) {
  DeviationField field = sample_surface(surface, check.field_spacing_mm);
  std::vector<ReachQuery::Touch> touches(field.samples.size());
  const Range range = range_of(touches.size(), kFieldChunk, piece.part, piece.parts);
  measure_samples(field, touches, range.begin, range.end, scene.cells, scene.spaces(), reach,
                  passes, check.allowance_mm, control);
  model::Packer out;
  out.mark(kFieldBegin);
  out.number(std::uint64_t{range.begin});
  out.number(std::uint64_t{range.end - range.begin});
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const DeviationField::Sample& s = field.samples[i];
    out.number(s.deviation_mm);
    out.number(static_cast<std::uint8_t>(s.reachable + 2 * s.raw_stock));
    out.number(s.stage);
    out.number(s.move);
    if (!s.reachable) continue;
    out.number(static_cast<std::uint32_t>(touches[i].cutter));
    pack_vec(out, touches[i].tip);
  }
  return out.take();
}

[[noreturn]] void refuse(const char* what) {
  throw std::invalid_argument(std::string("what a piece came to is no ") + what);
}

}  // namespace

std::string to_text(const StagePiece& piece) {
  return std::string(kKinds[static_cast<std::size_t>(piece.kind)]) + " " +
         std::to_string(piece.part) + " " + std::to_string(piece.parts);
}

std::optional<StagePiece> piece_of(std::string_view text) {
  StagePiece piece;
  for (std::size_t k = 0; k < kKinds.size(); ++k) {
    const std::string begin = std::string(kKinds[k]) + " ";
    if (!text.starts_with(begin)) continue;
    const char *at = text.data() + begin.size(), *const end = text.data() + text.size();
    const auto part = std::from_chars(at, end, piece.part);
    if (part.ec != std::errc() || part.ptr == end || *part.ptr != ' ') return std::nullopt;
    const auto parts = std::from_chars(part.ptr + 1, end, piece.parts);
    if (parts.ec != std::errc() || parts.ptr != end || piece.part >= piece.parts)
      return std::nullopt;
    piece.kind = static_cast<StagePiece::Kind>(k);
    return piece;
  }
  return std::nullopt;
}

std::string do_piece(const ReferenceSurface& surface, const model::Stock& raw_stock,
                     std::span<const Pass> passes, const StageCheck& check, const StagePiece& piece,
                     std::string_view reach, const model::RunControl& control) {
  const StageScene scene(surface, raw_stock, passes, check);
  if (piece.kind == StagePiece::Kind::reach) return reach_part(scene, piece, control);
  if (piece.kind == StagePiece::Kind::missing_stock)
    return to_bytes(missing_stock_of(scene, control));
  // Pieces do not wait for each other, so what is missing is found out here as well.
  if (piece.kind == StagePiece::Kind::gouge)
    return to_bytes(gouge_of(scene, missing_stock_of(scene, control), control));
  auto entries = entries_of_bytes(reach);
  if (!entries) refuse("reach map");
  const ReachMap proven(scene.cells, std::move(*entries));
  const ReachQuery query(scene.by.searches, proven);
  if (piece.kind == StagePiece::Kind::uncut) return to_bytes(uncut_of(scene, query, control));
  return field_part(scene, surface, check, passes, piece, query, control);
}

void PieceRound::ask(std::initializer_list<StagePiece::Kind> kinds, const std::string& reach) {
  for (const StagePiece::Kind kind : kinds) {
    const std::uint32_t parts = is_cut_into_parts(kind) ? workers_->parts() : 1;
    for (std::uint32_t part = 0; part < parts; ++part) pieces_.push_back({kind, part, parts});
  }
  outcomes_ = workers_->work(pieces_, reach);
}

std::vector<std::string> PieceRound::all(StagePiece::Kind kind) const {
  std::vector<std::string> found;
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    if (pieces_[i].kind == kind) found.push_back(outcomes_[i]);
  return found;
}

ReachMap gathered_reach(const StageScene& scene, const std::vector<std::string>& parts,
                        const model::RunControl& control) {
  ReachRecords all;
  for (const std::string& part : parts) {
    const auto records = ReachRecords::of_bytes(part);
    if (!records) refuse("part of a reach map");
    all.add(*records);
  }
  ReachSharing sharing;
  sharing.known = &all;
  return classify_reach(scene.cells, scene.by.searches, scene.by.efforts, control, sharing);
}

std::vector<ReachQuery::Touch> gathered_field(DeviationField& field,
                                              const std::vector<std::string>& parts,
                                              std::span<const Pass> passes) {
  std::vector<ReachQuery::Touch> touches(field.samples.size());
  std::size_t next = 0;
  for (const std::string& part : parts) {
    model::Unpacker in(part);
    in.mark(kFieldBegin);
    const auto begin = in.number<std::uint64_t>();
    const std::size_t count = in.count(kSampleBytes);
    if (!in.good() || begin != next || count > field.samples.size() - next)
      refuse("part of the field of samples");
    for (std::size_t i = 0; i < count && in.good(); ++i, ++next) {
      DeviationField::Sample& s = field.samples[next];
      s.deviation_mm = in.number<float>();
      const auto bits = in.number<std::uint8_t>();
      s.reachable = (bits & 1) != 0, s.raw_stock = (bits & 2) != 0;
      s.stage = in.number<std::uint32_t>(), s.move = in.number<std::uint32_t>();
      if (s.stage >= passes.size() ||
          (!s.raw_stock && s.move >= passes[s.stage].path->moves.size()))
        refuse("sample");
      if (!s.raw_stock) s.line = passes[s.stage].path->moves[s.move].line;
      if (!s.reachable) continue;
      touches[next].cutter = in.number<std::uint32_t>();
      touches[next].tip = unpack_vec(in);
    }
    if (!in.done()) refuse("part of the field of samples");
  }
  if (next != field.samples.size()) refuse("whole field of samples");
  return touches;
}

Certificate certificate_of_bytes(std::string_view bytes) {
  model::Unpacker in(bytes);
  in.mark(kCertificateBegin);
  Certificate c;
  for (double* value : {&c.figure_mm.low, &c.figure_mm.high}) *value = in.number<double>();
  c.cells = in.number<std::uint64_t>();
  const auto bits = in.number<std::uint8_t>();
  c.reached_resolution = (bits & 1) != 0;
  if ((bits & 2) != 0) {
    Witness& w = c.witness.emplace();
    w.place.patch = in.number<std::int32_t>();
    for (double* value : {&w.place.u, &w.place.v, &w.depth_mm}) *value = in.number<double>();
    w.place.point = unpack_vec(in);
    w.normal = unpack_vec(in);
    w.body.pass = in.number<std::uint32_t>(), w.body.index = in.number<std::uint32_t>();
  }
  if (!in.done()) refuse("certificate");
  return c;
}

Certificate missing_stock_of(const StageScene& scene, const model::RunControl& control) {
  return certify(scene.cells, scene.raw, Side::missing_stock, nullptr, scene.request, control);
}

Certificate uncut_of(const StageScene& scene, const ReachQuery& reach,
                     const model::RunControl& control) {
  const auto figure = [&](const RemovedSpace& space) {
    return certify(scene.cells, space, Side::uncut, &reach, scene.request, control);
  };
  Certificate out = figure(scene.cut);
  if (scene.cut.stock_blunt_mm() == 0) return out;
  // What is reached is reached in the stock as it is said to be, what is excluded in the other.
  const Certificate grown = figure(scene.cut.with_stock_grown());
  out.reached_resolution = out.reached_resolution && grown.reached_resolution &&
                           grown.figure_mm.high <= out.figure_mm.high;
  out.figure_mm.high = std::max(out.figure_mm.high, grown.figure_mm.high);
  out.cells += grown.cells;
  return out;
}

Certificate gouge_of(const StageScene& scene, const Certificate& missing,
                     const model::RunControl& control) {
  CertificateRequest request = scene.request;
  const bool is_limited = std::isfinite(request.gouge_limit_mm);
  if (missing.figure_mm.low > (is_limited ? request.gouge_limit_mm : request.resolution_mm))
    request.largest_cell_count =
        std::min(request.largest_cell_count, is_limited ? kCellsOnceFailed : kCellsOnceUncovered);
  return certify(scene.cells, scene.spaces().swept, Side::gouge, nullptr, request, control);
}

}  // namespace limitgauge::verifier
