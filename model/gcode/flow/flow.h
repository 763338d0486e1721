#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "model/gcode/flow/flow_keyword.h"
#include "model/gcode/flow/flow_marks.h"
#include "model/gcode/flow/flow_spans.h"
#include "model/gcode/flow/flow_subroutines.h"
#include "model/gcode/text/lexer.h"
#include "model/gcode/text/parameters.h"

namespace limitgauge::model::gcode {

#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
inline constexpr std::size_t kFlowShare = 50;  ///< sanitizers are that much slower
#else
inline constexpr std::size_t kFlowShare = 1;
#endif

/// Bounds on what a program may expand to: a program from a stranger must end, in seconds and in
/// less than 1 GiB. They count what is carried out in loops, subroutines and programs.
struct FlowLimits {
  /// As many blocks as the longest programs have that are written without loops.
  std::size_t most_blocks = 5'000'000 / kFlowShare;
  /// Their text: what a block costs to read goes by its length, at most 35 ns a byte (parameters
  /// within parameters), so that no program of some kilobytes takes a second.
  std::size_t most_bytes = 25'000'000 / kFlowShare;
  /// And so many times what stands before the loop or call, in blocks and bytes: a long program may
  /// call a subroutine for each of its holes.
  std::size_t most_times_before = 100 / kFlowShare;
  /// Blocks on end of which none may move an axis. Sums and searches need thousands; a loop without
  /// end that moves nothing is found in a tenth of a second.
  std::size_t most_idle_blocks = 500'000 / kFlowShare;
  std::size_t most_depth = 100;  ///< of calls and of blocks within blocks together
  std::size_t most_calls = 9;    ///< within each other; LinuxCNC's
};

/// A subprogram's file.
struct SubprogramFile {
  std::string name;
  std::string text;
};
/// The file of a program number; nothing where there is none.
using FindSubprogram = std::function<std::optional<SubprogramFile>(const std::string& number)>;

/// Which block of a program comes next: carries out O words (sub, endsub, return, call, do, while,
/// endwhile, break, continue, if, elseif, else, endif, repeat, endrepeat) and Fanuc's M98 P L, M99
/// and O-number programs in the same file, as LinuxCNC does
/// (https://linuxcnc.org/docs/2.9/html/gcode/o-code.html). Sets the parameters of a line after it
/// has been read whole. What LinuxCNC takes and this does not:
///  - labels that are computed, save for calls;
///  - spans that overlap or are not ended, and a label of another subroutine at endsub or return;
///  - what its interpreter (2.9) carries out otherwise than it documents: a do loop behind a break
///    out of a while loop, a break or a repeat behind a continue in a do loop, a repeat whose count
///    return, break or continue have left over, or a call has used up.
/// Subprograms may also stand before the M98 that calls them, and M98 P31000 means three times
/// program 1000, as on older Fanuc controls, where there is no program 31000.
/// Where the lexer's control has them: macro B's GOTO, WHILE, DO and END, G65 with its arguments,
/// M97, M99 P, and calls at the end of a block of other words, which come after it.
class Flow {
 public:
  /// `lexer` stands at the beginning of its text. `lexer` and `parameters` outlive it.
  Flow(Lexer& lexer, Parameters& parameters, FlowLimits limits = {},
       FindSubprogram find_subprogram = {});
  Flow(const Flow&) = delete;
  Flow& operator=(const Flow&) = delete;

  /// The next block to carry out; false at the end of the program. O lines and M98 and M99 do not
  /// come, save that begin with `/`: these come with their O word or without any word, so that they
  /// can be listed. Throws InputError with the place for labels that do not match, calls without
  /// their subroutine, values that are missing, and limits that are exceeded.
  bool next(Block& block);
  /// Within no loop and no call, and behind no jump: a line that asks for none of these comes next
  /// as it stands in the text, and nothing is counted.
  bool goes_straight() const { return !pending_ && !jump_ && frames_.empty(); }

 private:
  /// Something that has been begun and not ended.
  struct Frame {
    FlowSpan* span = nullptr;              // null: a call
    FlowSubroutine* subroutine = nullptr;  // of a call
    Lexer::Bookmark back;                  // of a call: behind its line
    double left = 0;                       // turns of a repeat, runs of a program
    int loop = 0;                          // of macro B: DO's number; `back` is before its END
    std::optional<Parameters::MacroArguments> arguments;  // of a call by G65
    std::size_t branch = 0;  // lines of elseif and else that have been reached
    bool taken = false;      // a branch of an if has been carried out
    Lexer::Bookmark begin;   // before its line
    std::uint32_t column = 0;
  };

  void count(const Block& block);
  [[noreturn]] void fail_without_end(const std::string& amount) const;
  void set(Block& block);
  void check_end() const;
  void carry_out(const Block& block);
  void push(const Block& block, std::uint32_t column, const Frame& frame);

  // flow_loops.cpp
  void begin_if(const Block& block);
  void go_to_branch(const Frame& frame);
  void branch(const Block& block, FlowKeyword keyword);
  void end_if(const Block& block);
  void begin_while(const Block& block);
  void end_while(const Block& block);
  void begin_do(const Block& block);
  void end_do(const Block& block);
  bool ends_do(const Block& block) const;
  void begin_repeat(const Block& block);
  void end_repeat(const Block& block);
  bool repeats(const Block& block, Frame& frame);
  void break_loop(const Block& block);
  void continue_loop(const Block& block);
  std::size_t loop_of(const Block& block, FlowKeyword keyword) const;
  FlowSpan& opened(const Block& block, FlowKeyword keyword);
  Frame& innermost(const Block& block, FlowKeyword keyword, FlowKeyword kind);
  double value(const Block& block, FlowKeyword keyword);
  void no_values(const Block& block, FlowKeyword keyword);

  // flow_calls.cpp
  void define(const Block& block);
  void call(const Block& block);
  const FlowSubroutine& checked(const Block& block, std::uint32_t column,
                                const FlowSubroutine& found) const;
  void find_span(FlowSubroutine& sub);
  void return_from_sub(const Block& block, FlowKeyword keyword);
  void set_returned(std::optional<double> value);
  const Frame* innermost_call() const;
  void push_call(const Block& block, std::uint32_t column, const Frame& frame);
  Frame pop_call();

  // flow_programs.cpp
  bool carry_out_code(const Block& block);
  void call_program(const Block& block);
  FlowSubroutine& called_program(const Block& block, const Word& p, const Word* l, double& runs);
  void return_from_program(const Block& block);
  void begin_program(const Block& block);
  double whole(const Block& block, const Word& word, double most) const;
  Frame call_frame() const;
  void take_call_words(const Block& block, const Word*& p, const Word*& l) const;
  FlowSubroutine* find_program(const std::string& label);
  FlowSubroutine& program_numbered(const Block& block, const Word& p, double number);
  [[noreturn]] void fail_missing(const Block& block, const Word& p, const std::string& label);

  // flow_macro.cpp
  void carry_out_macro(const Block& block);
  void jump(const Block& block, std::uint32_t column, int number, Lexer::Bookmark from);
  const NumberedBlock& numbered_block(const Block& block, std::uint32_t column, int number,
                                      Lexer::Bookmark from);
  void begin_loop(const Block& block);
  void end_loop(const Block& block);
  void call_macro(Block& block);
  void note_doubtful_arguments(Block& block);
  void call_local(const Block& block);
  bool split_call(Block& block);
  [[noreturn]] void fail_at(const Block& block, const Word& word, const std::string& wrong,
                            const std::string& expected) const;

  bool take(Block& block);
  bool is_for_flow(Block& block);
  void name_main_line(Block& block) const;
  void check_setting(const Block& block, const Setting& setting) const;
  [[noreturn]] void fail(const Block& block, const std::string& wrong,
                         const std::string& expected) const;

  Lexer& lexer_;
  Parameters& parameters_;
  FlowLimits limits_;
  FlowSpans spans_;
  FlowSubroutines subroutines_;
  FlowMarks marks_;
  FindSubprogram find_subprogram_;
  std::map<std::uint32_t, FlowSubroutine> locals_;  // by line
  std::optional<Block> pending_;  // a call that stands behind other words of its block
  std::optional<Frame> jump_;     // where the first GOTO led
  std::vector<Frame> frames_;
  std::size_t calls_ = 0;
  bool doubts_arguments_ = true;  // those without a decimal point are still to be told of
  std::size_t blocks_ = 0, bytes_ = 0, idle_blocks_ = 0;
  std::unordered_map<std::string, std::uint32_t> lines_of_labels_;  // "scope#label"
  // LinuxCNC remembers these beyond the loop that they leave.
  std::optional<std::uint32_t> break_line_, continue_line_;
};

}  // namespace limitgauge::model::gcode
