#include "app/study/study_file.h"
#include "model/base/text_file.h"
#include "study/plan/design.h"
#include "tests/fuzz/reading.h"

using namespace limitgauge;

namespace {

/// More than this take longer to make than an input may.
constexpr std::size_t kMostMade = 1000;

void check_design(const study::Plan& plan) {
  const std::size_t count = study::case_count(plan);
  fuzz::require(count <= study::kMostCases, "a study has as many cases as are allowed");
  if (plan.method == study::Method::search || count > kMostMade) return;
  fuzz::require(study::design(plan).size() == count, "a design has the cases that were counted");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Whatever job the text names: this one.
  static const std::string job =
      model::read_text_file(LIMITGAUGE_FUZZ_JOB_FOLDER "/study_job.toml");
  return fuzz::answer([&] {
    const std::string text = fuzz::text_of(data, size);
    app::StudyFile file = app::read_study_text(text, "study.toml", LIMITGAUGE_FUZZ_JOB_FOLDER);
    file.plan.job = LIMITGAUGE_FUZZ_JOB_FOLDER "/study_job.toml";
    app::relate_to_job(file, job, {});
    check_design(file.plan);
  });
}
