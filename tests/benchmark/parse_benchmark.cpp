// read_program over five million lines of a finish program against std::from_chars over every
// number in the same bytes that has a meaning to the path, both from memory and on one thread. That
// scanner passes over comments, blanks and the words of spindle, tool and machine functions.

#include <benchmark/benchmark.h>

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <system_error>

#include "model/gcode/program.h"

namespace limitgauge::benchmarks {
namespace {

constexpr int kLines = 5'000'000, kPointsOfARow = 1000, kRowsOfAFeed = 10;
constexpr double kRow_mm = 0.013, kAlong_mm = 0.08;

/// `text` with `value` behind it, four decimals.
void append(std::string& text, char letter, double value) {
  char digits[32];
  const auto end =
      std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, 4);
  text += letter;
  text.append(digits, static_cast<std::size_t>(end.ptr - digits));
}

double height(double x, double y) {
  return -0.005 * (x * x + y * y);
}

/// Back and forth in rows joined by half circles; every few rows the tool goes up and comes down
/// again with another feed rate.
std::string finish_program() {
  std::string text = "G21 G17 G90 G94\nT1 M6\nS8000 M3\nG0 X0 Y0 Z20\n";
  text.reserve(std::size_t{kLines} * 32);
  int lines = 4;
  double side = -1, y = -32.5;
  for (int row = 0; lines < kLines; ++row, side = -side, y += kRow_mm) {
    const double begin = side * kAlong_mm * kPointsOfARow / 2;
    if (row % kRowsOfAFeed == 0) {
      text += "(the next rows)\nG0 Z20.\n";
      append(text += "G0", 'X', begin);
      append(text, 'Y', y);
      append(text += "\nG1", 'Z', height(begin, y));
      text += " F300\nF1200\n";
      lines += 5;
    }
    for (int point = 0; point <= kPointsOfARow; ++point) {
      const double x = begin - side * kAlong_mm * point;
      append(text += point % 4 == 0 ? "G1 " : "", 'X', x);
      append(text += ' ', 'Y', y);
      append(text += ' ', 'Z', height(x, y));
      text += '\n';
    }
    append(text += side < 0 ? "G3" : "G2", 'Y', y + kRow_mm);
    append(text, 'J', kRow_mm / 2);
    text += '\n';
    lines += kPointsOfARow + 2;
  }
  return text + "G0 Z20.\nM30\n";
}

const std::string& program_text() {
  static const std::string text = finish_program();
  return text;
}

void parse_program(benchmark::State& state) {
  const std::string& text = program_text();
  std::size_t motions = 0;
  for (auto _ : state)
    motions = model::read_program(std::string_view(text), "finish.ngc").motions.size();
  state.counters["motions"] = static_cast<double>(motions);
}
BENCHMARK(parse_program)->Iterations(1)->Unit(benchmark::kMillisecond);

/// Letters that have no meaning to a path: numbers of lines, spindle, tool, machine functions.
bool is_without_meaning(char letter) {
  return letter == 'N' || letter == 'S' || letter == 'T' || letter == 'M';
}

/// Where the next number of a word with a meaning to the path begins; `end` where there is none.
/// Blanks, line ends, comments and words without such a meaning are passed over.
const char* next_number(const char* at, const char* end) {
  while (at < end) {
    const char c = *at++;
    if (c >= 'A' && c <= 'Z') {
      if (!is_without_meaning(c)) return at;
      while (at < end && (*at == '.' || *at == '-' || (*at >= '0' && *at <= '9'))) ++at;
    } else if (c == '(') {
      while (at < end && *at++ != ')') continue;
    } else if (c == ';') {
      while (at < end && *at != '\n') ++at;
    }
  }
  return end;
}

/// A scanner that does nothing but find the numbers that matter and read them.
void parse_from_chars(benchmark::State& state) {
  const std::string& text = program_text();
  const char* const end = text.data() + text.size();
  double sum = 0;
  std::size_t numbers = 0;
  for (auto _ : state) {
    sum = 0, numbers = 0;
    for (const char* at = next_number(text.data(), end); at < end; at = next_number(at, end)) {
      double value = 0;
      const auto [next, error] = std::from_chars(at, end, value, std::chars_format::fixed);
      if (error != std::errc()) return state.SkipWithError("a word without a number");
      at = next, sum += value, ++numbers;
    }
    benchmark::DoNotOptimize(sum);
  }
  state.counters["numbers"] = static_cast<double>(numbers);
}
BENCHMARK(parse_from_chars)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace limitgauge::benchmarks
