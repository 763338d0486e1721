#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limitgauge::model::gcode {

/// The parameters of a running program: numbered, and named ones that are local to a subroutine's
/// call or, with a leading `_`, global. Numbers 1 to 30 are local to a call too, as in LinuxCNC.
/// What was never set has no value; reading it is the caller's error. Some are the machine's own
/// (the position in 5420 to 5422, the offsets in 5161 and on, `_metric`, ...): numbers beyond
/// kLargestFree and names with a leading `_` are asked for through `system` when they are read, and
/// looked up among what was set where it has no answer.
class Parameters {
 public:
  static constexpr int kLargest = 5999;
  static constexpr int kLargestFree = 5000;
  static constexpr int kLargestLocal = 30;
  static constexpr int kLargestMacroLocal = 33;  ///< of macro B
  static constexpr int kFirstMacroSystem = 1000;
  using SystemNumbered = std::function<std::optional<double>(int)>;
  using SystemNamed = std::function<std::optional<double>(std::string_view)>;

  void set_system(SystemNumbered numbered, SystemNamed named);

  std::optional<double> numbered(int number) const;
  /// `name` in lower case without blanks.
  std::optional<double> named(std::string_view name) const;
  /// Whether the program may set it: a number from 1 to kLargest, or a name, that neither LinuxCNC
  /// holds read-only nor stands for an offset or a reference point. Those (5161 to 5390) LinuxCNC
  /// takes over at some later code; here G10, G28.1, G30.1 and G92 set them.
  static bool is_settable(int number);
  static bool is_settable(std::string_view name);
  void set(int number, double value);
  void set(std::string_view name, double value);

  /// A call of a subroutine: `arguments` become 1, 2, ...; the rest of 1 to 30 is 0, as in
  /// LinuxCNC, and no local name is known. leave() brings the caller's back.
  void enter(const std::vector<double>& arguments);
  /// From now on 1 to 33 are local, as in macro B.
  void use_macro_variables() { locals_ = kLargestMacroLocal; }
  /// What was set is forgotten: macro B's vacant variable.
  void clear(int number);
  using MacroArguments = std::array<std::optional<double>, kLargestMacroLocal + 1>;
  /// A call by G65: its arguments by the variables that they are handed over in; the rest is
  /// vacant.
  void enter_macro(const MacroArguments& arguments);
  /// The local variables by number as they are.
  const MacroArguments& locals() const { return frames_.back().numbered; }
  /// A call by M98: 1 to 30 are the caller's own, but no local name is known.
  void enter();
  void leave();
  std::size_t depth() const { return frames_.size(); }
  /// Which call runs at `depth`, counted over the program; 0: none any more.
  std::size_t call_at(std::size_t depth) const {
    return depth >= 1 && depth <= frames_.size() ? frames_[depth - 1].call : 0;
  }

 private:
  struct Frame {
    MacroArguments numbered;
    std::map<std::string, double, std::less<>> named;
    bool shares_numbers = false;  // with its caller
    std::size_t call = 1;
  };
  std::vector<std::optional<double>> numbered_ =
      std::vector<std::optional<double>>(kLargest + std::size_t{1});
  std::map<std::string, double, std::less<>> named_;
  std::vector<Frame> frames_ = std::vector<Frame>(1);
  std::size_t calls_ = 1;
  int locals_ = kLargestLocal;
  SystemNumbered system_numbered_;
  SystemNamed system_named_;
};

}  // namespace limitgauge::model::gcode
