#include "engine/model/gcode/interpreter.h"

#include <cmath>

#include "engine/model/gcode/arc.h"
#include "engine/model/words.h"

namespace limitgauge::model::gcode {
namespace {

constexpr double kInchMm = 25.4;
/// A thousand kilometres: beyond any machine, and far from where squares overflow.
constexpr double kLargestCoordinateMm = 1e9;
/// More turns in one block are a typing error, and each becomes at least four chords.
constexpr double kMostTurns = 10000;
constexpr std::array<char, 3> kAxes = {'X', 'Y', 'Z'};
constexpr std::array<char, 3> kCentres = {'I', 'J', 'K'};

bool is_arc(std::optional<int> motion) {
  return motion == 20 || motion == 30;
}

bool has_axis_word(const Statement& statement) {
  return statement.word('X') || statement.word('Y') || statement.word('Z');
}

bool has_centre_word(const Statement& statement) {
  return statement.word('I') || statement.word('J') || statement.word('K');
}

/// Upper case and without blanks.
std::string plain(const Word& word) {
  std::string text(1, word.letter);
  for (const char c : word.text.substr(1)) {
    if (c != ' ' && c != '\t' && c != '\r') text += c;
  }
  return text;
}

bool is_ignored(const Statement& statement, const Word& word) {
  if (word.letter == 'S' || word.letter == 'T') return true;
  if (&word == statement.g_word(GGroup::non_modal)) return true;
  if (&word == statement.g_word(GGroup::path_control)) return true;
  if (word.letter != 'M') return false;
  const int stop = statement.m(MGroup::stopping).value_or(0);
  return &word != statement.m_word(MGroup::stopping) || stop < 2;
}

/// Comments that a controller acts on: a message to the operator, output to a file.
bool is_active(std::string_view comment) {
  if (comment.front() != '(') return false;
  std::string word;
  for (const char c : comment.substr(1)) {
    if (c == ' ' || c == '\t') continue;
    if (c == ',') break;
    if (c == ')' || word.size() > 10) return false;
    word += static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  }
  return word == "MSG" || word == "DEBUG" || word == "PRINT" || word == "LOG" ||
         word == "LOGOPEN" || word == "LOGAPPEND" || word == "PROBEOPEN";
}

}  // namespace

bool Interpreter::execute(const Statement& statement) {
  list_messages(statement.block());
  if (statement.block().words.empty()) return true;
  check_companions(statement);
  list_ignored(statement);
  set_feed(statement);
  change_tool(statement);
  set_spindle(statement);
  set_modes(statement);
  const std::optional<int> motion = motion_of(statement);
  if (motion) move(statement, *motion);
  return statement.m(MGroup::stopping).value_or(0) < 2;
}

void Interpreter::add_ignored(std::uint32_t line, std::string word) {
  program_.ignored.push_back({line, std::move(word)});
}

void Interpreter::list_messages(const Block& block) {
  if (block.block_delete) add_ignored(block.line, "/");
  for (const Comment& comment : block.comments) {
    if (is_active(comment.text)) add_ignored(block.line, std::string(comment.text));
  }
}

void Interpreter::list_ignored(const Statement& statement) {
  for (const Word& word : statement.block().words) {
    if (!is_ignored(statement, word)) continue;
    std::string text = plain(word);
    const bool takes_p = word.letter == 'G';
    if (const Word* p = statement.word('P'); takes_p && p) text.append(" ").append(plain(*p));
    if (const Word* q = statement.word('Q'); takes_p && q) text.append(" ").append(plain(*q));
    add_ignored(statement.block().line, std::move(text));
  }
}

/// Words that only mean something beside a certain code.
void Interpreter::check_companions(const Statement& statement) const {
  const bool dwell = statement.g(GGroup::non_modal).has_value();
  const bool blending = statement.g(GGroup::path_control) == 640;
  const bool arc = is_arc(motion_of(statement));
  const Word* const p = statement.word('P');
  if (dwell && arc)
    statement.fail(*statement.g_word(GGroup::non_modal), "G4 beside an arc, which may use P too",
                   "a block of its own");
  if (dwell && (!p || p->value < 0))
    statement.fail(*statement.g_word(GGroup::non_modal), "a dwell without its time",
                   "P with 0 or more seconds");
  if (p && !dwell && !blending && !arc)
    statement.fail(*p, "P beside no code that uses it", "G2, G3, G4 or G64");
  if (const Word* q = statement.word('Q'); q && !blending)
    statement.fail(*q, "Q beside no code that uses it", "G64");
  if (const Word* centre = statement.first_of({'I', 'J', 'K', 'R'}); centre && !arc)
    statement.fail(*centre, in_quotes(centre->text) + " beside no arc", "G2 or G3");
}

/// Before a change of units in the same block, as RS274/NGC orders it.
void Interpreter::set_feed(const Statement& statement) {
  // LinuxCNC forgets the feed rate whenever a feed mode is programmed.
  if (statement.g(GGroup::feed_mode)) feed_mm_min_ = 0;
  const Word* const f = statement.word('F');
  if (!f) return;
  if (f->value < 0) statement.fail(*f, "a negative feed rate", "0 or more");
  if (f->value * unit_mm_ > kLargestCoordinateMm)
    statement.fail(*f, "a feed rate beyond any machine", "at most 1e9 mm/min");
  feed_mm_min_ = f->value * unit_mm_;
}

/// One program is verified with one cutter: another one must not pass unseen.
void Interpreter::change_tool(const Statement& statement) {
  const Word* const t = statement.word('T');
  if (t && (t->value < 0 || t->value != std::floor(t->value)))
    statement.fail(*t, "tool number " + in_quotes(t->text), "an integer from 0");
  if (const Word* s = statement.word('S'); s && s->value < 0)
    statement.fail(*s, "a negative spindle speed", "0 or more");
  if (t) selected_tool_ = t->value;
  const Word* const change = statement.m_word(MGroup::tool_change);
  if (!change || !selected_tool_) return;
  if (loaded_tool_ && *loaded_tool_ != *selected_tool_)
    statement.fail(*change, "a change to a second tool is not supported in this release",
                   "one tool a program");
  loaded_tool_ = selected_tool_;
}

/// A tool change stops the spindle, and comes before M3 of the same block. A program without M3 and
/// M4 leaves the spindle to the operator; one that starts it somewhere had it at rest before.
void Interpreter::set_spindle(const Statement& statement) {
  if (const Word* s = statement.word('S')) speed_is_zero_ = s->value == 0;
  if (statement.m_word(MGroup::tool_change) && spindle_on_) spindle_on_ = false;
  const auto code = statement.m(MGroup::spindle);
  if (!code) return;
  if (!spindle_on_) motions_before_spindle_ = program_.motions.size();
  spindle_on_ = *code != 5;
  if (*code == 5 || program_.starts_spindle) return;
  program_.starts_spindle = true;
  for (std::size_t i = 0; i < motions_before_spindle_; ++i)
    program_.motions[i].spindle_stopped = true;
}

void Interpreter::set_modes(const Statement& statement) {
  if (const auto code = statement.g(GGroup::plane)) plane_ = static_cast<ArcPlane>(*code / 10);
  if (const auto code = statement.g(GGroup::units)) unit_mm_ = *code == 200 ? kInchMm : 1;
  if (const auto code = statement.g(GGroup::distance)) incremental_ = *code == 910;
  if (const auto code = statement.g(GGroup::arc_distance)) centre_absolute_ = *code == 901;
  if (const auto code = statement.g(GGroup::motion)) {
    const Word* const axis = statement.first_of({'X', 'Y', 'Z'});
    if (*code == 800 && axis) statement.fail(*axis, "an axis word beside G80", "G0, G1, G2 or G3");
    motion_mode_ = *code == 800 ? std::nullopt : code;
  }
}

/// The motion that this block asks for. G0 and G1 alone are motions of no length, as in LinuxCNC.
std::optional<int> Interpreter::motion_of(const Statement& statement) const {
  if (const auto code = statement.g(GGroup::motion)) return *code == 800 ? std::nullopt : code;
  if (has_axis_word(statement)) {
    if (!motion_mode_)
      statement.fail(*statement.first_of({'X', 'Y', 'Z'}), "an axis word without a motion mode",
                     "G0, G1, G2 or G3");
    return motion_mode_;
  }
  return has_centre_word(statement) && is_arc(motion_mode_) ? motion_mode_ : std::nullopt;
}

void Interpreter::move(const Statement& statement, int code) {
  Motion motion;
  motion.kind = code == 0 ? MotionKind::rapid : code == 10 ? MotionKind::feed : MotionKind::arc;
  motion.line = statement.block().line;
  motion.plane = plane_;
  if (code != 0) motion.feed_mm_min = static_cast<float>(feed_mm_min_);
  motion.spindle_stopped = spindle_on_.has_value() && (!*spindle_on_ || speed_is_zero_);
  motion.to = end_of(statement);
  if (motion.kind == MotionKind::arc) arc(statement, code == 30, motion);
  motion.position_known = known_[0] && known_[1] && known_[2];
  position_mm_ = motion.to;
  program_.motions.push_back(motion);
}

Vec3 Interpreter::end_of(const Statement& statement) {
  Vec3 end_mm = position_mm_;
  for (int axis = 0; axis < 3; ++axis) {
    const Word* const word = statement.word(kAxes[axis]);
    if (!word) continue;
    end_mm[axis] = word->value * unit_mm_ + (incremental_ ? position_mm_[axis] : 0);
    if (!incremental_) known_[axis] = true;
    if (!(std::abs(end_mm[axis]) <= kLargestCoordinateMm))
      statement.fail(*word, "a position beyond any machine", "at most 1e9 mm");
  }
  return end_mm;
}

void Interpreter::arc(const Statement& statement, bool counter_clockwise, Motion& motion) const {
  const auto [first, second, normal] = axes_of(plane_);
  const PlanePoint start = {position_mm_[first], position_mm_[second]};
  const PlanePoint end = {motion.to[first], motion.to[second]};
  const Word* const radius = statement.word('R');
  const Word* const centre = statement.first_of({'I', 'J', 'K'});
  const Word* const code = statement.g_word(GGroup::motion);
  const Word& blamed = centre   ? *centre
                       : radius ? *radius
                       : code   ? *code
                                : *statement.first_of({'X', 'Y', 'Z'});
  if (!radius && !centre) statement.fail(blamed, "an arc without centre or radius", "I J K or R");
  if (radius && centre) statement.fail(*radius, "R beside I, J or K", "one of the two forms");
  if (radius && !statement.word(kAxes[first]) && !statement.word(kAxes[second]))
    statement.fail(*radius, "an arc by radius without its end point in the plane",
                   std::string(1, kAxes[first]) + " or " + kAxes[second]);
  const double spiral_mm = unit_mm_ == 1 ? kSpiralToleranceMm : kSpiralToleranceInch * kInchMm;
  const ArcCentre found =
      radius ? centre_by_radius(start, end, radius->value * unit_mm_, counter_clockwise)
             : centre_by_offset(start, end, centre_words(statement), spiral_mm);
  if (!found.wrong.empty()) statement.fail(blamed, found.wrong, found.expected);
  motion.centre1 = found.centre[0];
  motion.centre2 = found.centre[1];
  motion.turns = counter_clockwise ? turns(statement) : -turns(statement);
}

PlanePoint Interpreter::centre_words(const Statement& statement) const {
  const auto [first, second, normal] = axes_of(plane_);
  if (const Word* stray = statement.word(kCentres[normal]))
    statement.fail(*stray, in_quotes(stray->text) + " is no centre word of this plane",
                   std::string(1, kCentres[first]) + " and " + kCentres[second]);
  PlanePoint centre{};
  for (int i = 0; i < 2; ++i) {
    const int axis = i == 0 ? first : second;
    const Word* const word = statement.word(kCentres[axis]);
    if (!word && centre_absolute_)
      statement.fail(*statement.first_of({'I', 'J', 'K'}),
                     std::string("an absolute centre without ") + kCentres[axis],
                     "both words of the centre under G90.1");
    centre[i] = (word ? word->value * unit_mm_ : 0) + (centre_absolute_ ? 0 : position_mm_[axis]);
    if (!(std::abs(centre[i]) <= kLargestCoordinateMm))
      statement.fail(*word, "a centre beyond any machine", "at most 1e9 mm");
  }
  return centre;
}

/// LinuxCNC's count: one for the part turn that reaches the end point, one more for each whole
/// turn.
double Interpreter::turns(const Statement& statement) const {
  const Word* const p = statement.word('P');
  if (!p) return 1;
  const double count = std::round(p->value);
  if (std::abs(p->value - count) > 0.001 || count < 1 || count > kMostTurns)
    statement.fail(*p, in_quotes(p->text) + " turns of an arc", "an integer from 1 to 10000");
  return count;
}

}  // namespace limitgauge::model::gcode
