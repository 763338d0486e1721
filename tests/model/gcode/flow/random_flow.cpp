#include "tests/model/gcode/flow/random_flow.h"

namespace limitgauge::model::test {
namespace {

using Kind = FlowStatement::Kind;
using Body = std::vector<FlowStatement>;

constexpr int kUnits = 4;
constexpr int kDepth = 3;

class Generator {
 public:
  Generator(std::mt19937& random, FlowMixture mixture) : random_(random), mixture_(mixture) {}

  RandomFlow program() {
    RandomFlow result;
    for (unit_ = 0; unit_ < kUnits; ++unit_) {
      FlowUnit& unit = result.units.emplace_back();
      unit.is_program = unit_ > 0 && chance(3);
      unit.is_named = chance(2);
      unit.is_before_main = unit_ > 0 && !unit.is_program && chance(2);
      label_ = 0;
      loops_.clear();
      unit.body = body(kDepth);
    }
    return result;
  }

 private:
  int below(int bound) { return static_cast<int>(random_() % static_cast<unsigned>(bound)); }
  bool chance(int of) { return below(of) == 0; }

  Body body(int depth) {
    Body statements;
    for (int count = 1 + below(4); count > 0; --count) statements.push_back(statement(depth));
    return statements;
  }

  FlowStatement statement(int depth) {
    FlowStatement result;
    result.number = below(5);
    const int pick = below(depth > 0 ? 12 : 5);
    if (pick < 2) return result;
    if (pick < 4) {
      result.kind = pick == 2 ? Kind::shuffle : Kind::add;
      return result;
    }
    if (pick == 4) return call(result);
    if (pick < 8) return choice(result, depth);
    return loop(result, depth);
  }

  FlowStatement call(FlowStatement result) {
    if (unit_ + 1 < kUnits && chance(2)) {
      result.kind = Kind::call;
      result.unit = unit_ + 1 + below(kUnits - unit_ - 1);
    }
    return result;
  }

  FlowStatement choice(FlowStatement result, int depth) {
    result.kind = Kind::choose;
    result.label = ++label_;
    for (int count = 1 + below(3); count > 0; --count) {
      result.bodies.push_back(body(depth - 1));
      if (chance(3)) result.bodies.back().push_back(jump());
    }
    return result;
  }

  /// Out of a loop or a unit, or into the same subroutine again.
  FlowStatement jump() {
    FlowStatement result;
    const bool jumps = mixture_ != FlowMixture::loops_without_jumps;
    if (jumps && unit_ > 0 && chance(4)) {
      result.kind = Kind::call;
      result.unit = unit_;
      result.is_recursive = true;
    } else if (jumps && !loops_.empty()) {
      result.kind = chance(2) ? Kind::break_loop : Kind::continue_loop;
      result.label = loops_[static_cast<std::size_t>(below(static_cast<int>(loops_.size())))];
    } else if (unit_ > 0 && (jumps || repeats_ == 0)) {
      result.kind = Kind::leave;
      result.number = below(5);
    }
    return result;
  }

  FlowStatement loop(FlowStatement result, int depth) {
    result.label = ++label_;
    result.kind = loop_kind();
    const bool repeats = result.kind == Kind::repeat;
    if (repeats) ++repeats_;
    if (!repeats) loops_.push_back(result.label);
    result.bodies.push_back(body(depth - 1));
    if (repeats) --repeats_;
    if (!repeats) loops_.pop_back();
    return result;
  }

  Kind loop_kind() {
    if (mixture_ == FlowMixture::while_loops) return Kind::while_loop;
    if (mixture_ == FlowMixture::do_loops) return Kind::do_loop;
    constexpr Kind kKinds[] = {Kind::while_loop, Kind::do_loop, Kind::repeat};
    return kKinds[below(3)];
  }

  std::mt19937& random_;
  FlowMixture mixture_;
  int unit_ = 0, label_ = 0, repeats_ = 0;
  std::vector<int> loops_;
};

/// Writes the statements, each with its line.
class Writer {
 public:
  explicit Writer(RandomFlow& program) : program_(program) {}

  void write() {
    for (std::size_t i = 1; i < program_.units.size(); ++i) {
      if (program_.units[i].is_before_main) unit(i);
    }
    line("#1=1 #2=2 #100=0");
    unit_ = 0;
    body(program_.units[0].body);
    line("M2");
    for (std::size_t i = 1; i < program_.units.size(); ++i) {
      if (!program_.units[i].is_before_main) unit(i);
    }
  }

 private:
  int line(const std::string& text) {
    program_.text.append(text).append("\n");
    return ++line_;
  }
  static std::string number(int value) { return std::to_string(value); }

  std::string name(std::size_t unit) const {
    const std::string digits = number(100 + static_cast<int>(unit));
    return program_.units[unit].is_named && !program_.units[unit].is_program
               ? "o<unit " + digits + ">"
               : "o" + digits;
  }

  void unit(std::size_t index) {
    unit_ = index;
    const bool is_program = program_.units[index].is_program;
    line(name(index) + (is_program ? "" : " sub"));
    body(program_.units[index].body);
    line(is_program ? "M99" : name(index) + " endsub");
  }

  void body(Body& statements) {
    for (FlowStatement& statement : statements) write(statement);
  }

  void write(FlowStatement& statement) {
    const std::string label = "o" + number(statement.label);
    switch (statement.kind) {
      case Kind::move:
        statement.line = line("G0 X#100 Y#1");
        break;
      case Kind::shuffle:
        line("#100=[[#100*3+" + number(statement.number) + "] MOD 7]");
        break;
      case Kind::add:
        line("#1=[#1+" + number(statement.number) + "]");
        break;
      case Kind::choose:
        choice(statement, label);
        break;
      case Kind::break_loop:
        line(label + " break");
        break;
      case Kind::continue_loop:
        line(label + " continue");
        break;
      case Kind::call:
        call(statement);
        break;
      case Kind::leave:
        line(program_.units[unit_].is_program
                 ? "M99"
                 : name(unit_) + " return [#100+" + number(statement.number) + "]");
        break;
      default:
        loop(statement, label);
    }
  }

  void choice(FlowStatement& statement, const std::string& label) {
    line(label + " if [#100 GT " + number(statement.number) + "]");
    body(statement.bodies[0]);
    if (statement.bodies.size() > 1)
      line(label + " elseif [#100 EQ " + number(statement.number) + "]");
    if (statement.bodies.size() > 1) body(statement.bodies[1]);
    if (statement.bodies.size() > 2) line(label + " else");
    if (statement.bodies.size() > 2) body(statement.bodies[2]);
    line(label + " endif");
  }

  void loop(FlowStatement& statement, const std::string& label) {
    const std::string counter = "#<c" + number(statement.label) + ">";
    const std::string condition = " while [" + counter + " LT " + number(statement.number) + "]";
    const bool repeats = statement.kind == Kind::repeat, ends = statement.kind == Kind::do_loop;
    if (!repeats) line(counter + "=0");
    line(label + (repeats ? " repeat [" + number(statement.number) + "]"
                  : ends  ? " do"
                          : condition));
    if (!repeats) line(counter + "=[" + counter + "+1]");
    body(statement.bodies[0]);
    line(label + (repeats ? " endrepeat" : ends ? condition : " endwhile"));
  }

  void call(const FlowStatement& statement) {
    const auto unit = static_cast<std::size_t>(statement.unit);
    const std::string digits = number(100 + statement.unit);
    const std::string guard = "o" + number(900 + line_);
    if (statement.is_recursive) line(guard + " if [#1 GT 1]");
    if (statement.is_recursive) line("#1=[#1-2]");
    if (program_.units[unit].is_program) {
      line("M98 P" + digits + " L" + number(1 + statement.number % 2));
    } else {
      line((statement.number == 0 && !program_.units[unit].is_named
                ? "o[1+" + number(99 + statement.unit) + "]"
                : name(unit)) +
           " call [#1+" + number(statement.is_recursive ? 0 : statement.number) + "] [#100]");
    }
    line("#100=[[#<_value>+#<_value_returned>] MOD 7]");
    if (statement.is_recursive) line(guard + " endif");
  }

  RandomFlow& program_;
  std::size_t unit_ = 0;
  int line_ = 0;
};

}  // namespace

RandomFlow random_flow(std::mt19937& random, FlowMixture mixture) {
  RandomFlow program = Generator(random, mixture).program();
  Writer(program).write();
  return program;
}

}  // namespace limitgauge::model::test
