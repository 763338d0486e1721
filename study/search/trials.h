#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/plan/axes.h"
#include "study/plan/plan.h"
#include "study/store/table.h"

namespace limitgauge::study {

/// Runs cases and gives their rows in the order asked; as many as can be had at a time. Fewer rows
/// than cases mean that it was stopped.
using Evaluate = std::function<std::vector<Row>(std::span<const Case>)>;

enum class SearchEnding { converged, budget, nothing_passes, stopped };

/// A search was stopped, or has no case left; what it has found so far stands.
struct OutOfCases {
  bool stopped = false;
};

/// The cases of a search: each is run once, and no more of them than the plan allows.
class Trials {
 public:
  Trials(const Plan& plan, std::span<const Figure> figures, const Evaluate& evaluate,
         const std::atomic<bool>* stop);

  const std::vector<Axis>& axes() const { return axes_; }
  const std::vector<Row>& rows() const { return rows_; }
  std::vector<Row> take_rows() { return std::move(rows_); }

  /// Runs what is new of `spots`, side by side, and says where their rows are. Throws OutOfCases
  /// after the last case that is left, or when asked to stop.
  std::vector<std::size_t> run(const std::vector<Spot>& spots);
  std::size_t run(const Spot& spot) { return run(std::vector<Spot>{spot}).front(); }
  std::size_t cases_left() const { return most_ - rows_.size(); }

  /// How far a row is from passing, above 0 unless it passes.
  double excess(std::size_t row) const;
  /// The cost of the whole job, as it is to be small; of a row that did not come to its end the
  /// greatest of all.
  double cost(std::size_t row) const;
  /// True where all figures are there, and so the cost is that of the whole job. A setting is known
  /// whatever became of the stages.
  bool is_whole(std::size_t row) const;
  /// The largest setting is sought, and no figure of the job.
  bool seeks_largest() const { return seeks_largest_; }
  bool passes(std::size_t row) const { return rows_[row].status == Status::pass; }
  /// Passing before not passing, then the cheaper, or the one nearer to passing; then the earlier.
  bool better(std::size_t a, std::size_t b) const;
  /// The best of all.
  std::optional<std::size_t> best() const { return best_; }

 private:
  std::optional<double> figure(std::size_t row, const std::optional<std::size_t>& index) const;
  /// Of a row that has it.
  double own_cost(std::size_t row) const;

  std::vector<Axis> axes_;
  const Evaluate* evaluate_;
  const std::atomic<bool>* stop_;
  std::size_t most_;
  bool seeks_largest_;
  std::vector<Figure> figures_;               ///< of the rows
  std::optional<std::size_t> cost_, excess_;  ///< into figures_
  std::map<std::string, std::size_t> known_;  ///< by settings, into rows_
  std::vector<Row> rows_;
  std::optional<std::size_t> best_;
};

}  // namespace limitgauge::study
