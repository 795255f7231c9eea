// StoredPlans: the tree of chunks built again from the rows, and the check of rows, records and items against one
// another.
#include <algorithm>

#include "base/float_environment.h"
#include "storage/rows/store_error.h"
#include "storage/table/stored_plans.h"

namespace foresee {

// A chunk that is damaged or missing is an error before anything changes; one of no object is deleted.
void StoredPlans::rebuild(std::vector<Head>& heads, std::span<const double> records, Interrupt& interrupt) {
  const FloatEnvironment environment;
  const auto record_size = static_cast<std::size_t>(at_.size),
             item_size = static_cast<std::size_t>(item_at_.size);
  std::vector<std::int64_t> numbers, strays;
  std::vector<double> items;
  std::vector<Leg> legs;
  const auto take = [&](const Head& head, std::int64_t number, std::span<const std::byte> blob) {
    legs.clear();
    require(append_legs(opened(number, blob, &head), legs), number);
    numbers.push_back(number);
    items.resize(items.size() + item_size);
    make_item(legs, records.data() + head.record * record_size, items.data() + items.size() - item_size);
  };
  scan(
      heads, take, [&](std::int64_t number) { strays.push_back(number); }, interrupt);
  std::int64_t total = 0;
  for (const Head& head : heads) total += head.chunks;
  if (total != static_cast<std::int64_t>(numbers.size()))
    damaged("its objects have " + std::to_string(total) + " chunks, but " + std::to_string(numbers.size()) +
            " are stored");
  tree_.replace_all(numbers, items, interrupt);
  if (strays.empty()) return;
  join();
  abandon_newest_mark();
  for (const std::int64_t number : strays) rows_->erase(number, number);
}

}  // namespace foresee
