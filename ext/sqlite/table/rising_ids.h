// Detects that a statement looks ids up in rising order, and predicts the next ones to fetch.
//
//   RisingIds rising;                          // one per statement
//   if (const auto first = rising.next(42)) store.fetch_ahead(*first, RisingIds::batch);
//
// Rising means each id a little above the one before it, as in a list or where another table is joined by its
// key. Then the ids to come are named batch by batch, each shortly before it is looked up. Cost: some
// comparisons per id.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

namespace foresee {

class RisingIds {
 public:
  static constexpr std::int64_t batch = 16;  ///< ids

  /// `id` is looked up now. The first id of a batch to come, if it is time to fetch that.
  std::optional<std::int64_t> next(std::int64_t id) {
    const std::uint64_t gap = static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(last_);
    const bool rises = last_ < id && gap <= widest_gap && id <= limit;
    last_ = id;
    if (!rises) {
      named_until_ = id;
      return std::nullopt;
    }
    if (id + lead < named_until_) return std::nullopt;
    const std::int64_t first = named_until_ > id ? named_until_ : id + 1;
    named_until_ = first + batch;
    return first;
  }

 private:
  /// How many ids before its first one a batch is named: fetching takes about as long as so many look-ups.
  static constexpr std::int64_t lead = 4;
  static constexpr std::uint64_t widest_gap = 4;
  static constexpr std::int64_t limit = std::numeric_limits<std::int64_t>::max() - 2 * batch;

  std::int64_t last_ = limit;
  std::int64_t named_until_ = 0;  ///< of a rising order: ids below have been named
};

}  // namespace foresee
