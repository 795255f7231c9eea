// Detects that a statement looks ids up in rising order, and predicts the next ones to fetch.
//
//   RisingIds rising;                          // one per statement
//   if (const auto first = rising.next(42)) store.fetch_ahead(*first, RisingIds::batch);
//
// Rising means that each id exceeds the previous one by at most 4, as in a list or in a join with another
// table by its key. The next ids are then predicted in batches, each shortly before its first look-up. Cost:
// a few comparisons per id.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

namespace foresee {

class RisingIds {
 public:
  static constexpr std::int64_t batch = 16;  ///< ids

  /// `id` is looked up now. Returns the first id of the next batch if it is time to fetch that batch.
  std::optional<std::int64_t> next(std::int64_t id) {
    const std::uint64_t gap = static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(last_);
    const bool rises = last_ < id && gap <= widest_gap && id <= limit;
    last_ = id;
    if (!rises) {
      predicted_until_ = id;
      return std::nullopt;
    }
    if (id + lead < predicted_until_) return std::nullopt;
    const std::int64_t first = predicted_until_ > id ? predicted_until_ : id + 1;
    predicted_until_ = first + batch;
    return first;
  }

 private:
  /// A batch is predicted this many ids before its first one: a fetch takes about as long as so many
  /// look-ups.
  static constexpr std::int64_t lead = 4;
  static constexpr std::uint64_t widest_gap = 4;
  static constexpr std::int64_t limit = std::numeric_limits<std::int64_t>::max() - 2 * batch;

  std::int64_t last_ = limit;
  std::int64_t predicted_until_ = 0;  ///< of a rising order: ids below have been predicted
};

}  // namespace foresee
