#pragma once

#include <cstddef>
#include <string>

#include "app/job/job_reader.h"
#include "model/base/error.h"
#include "tests/support/folders.h"
#include "tests/support/messages.h"

namespace limitgauge::app {

/// More than any of these jobs takes.
inline constexpr std::size_t kMemory = std::size_t{4} << 30;

/// A job that is in order.
inline std::string good_job() {
  return R"(name = "dome"
[surface]
cage = "cages/quick-dome.obj"
[stock]
shape = "box"
size = [26, 26, 9]
corner = [-13, -13, -4]
[[tool]]
id = "ball3"
type = "ball"
diameter = 6
[[stage]]
name = "finish"
tool = "ball3"
strategy = "zigzag"
step = 0.1
tolerance = 0.01
feed = 1500
[stage.gate]
gouge = 0.01
)";
}

/// `text` with its one occurrence of `from` replaced.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

inline Job read(const std::string& text, std::vector<std::string> overrides = {}) {
  return read_job_text(text, "job.toml", tests::fixtures(), overrides);
}

/// What `text` is refused with.
inline std::string error_of(const std::string& text, std::vector<std::string> overrides = {}) {
  return tests::message_of<model::InputError>([&] { read(text, std::move(overrides)); });
}

}  // namespace limitgauge::app
