#include "app/run/stage_prefix.h"

namespace limitgauge::app {

std::size_t StagePrefix::memory_bytes() const {
  std::size_t sum = model ? model->figures().memory_bytes : 0;
  if (stock) sum += stock->stock.memory_bytes() + stock->lines.memory_bytes();
  for (const RecordedStage& stage : stages)
    sum += stage.json->size() + stage.program_text->size() +
           stage.path->moves.size() * sizeof(model::Move);
  return sum;
}

}  // namespace limitgauge::app
