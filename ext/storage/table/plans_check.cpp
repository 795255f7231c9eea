// StoredPlans: the tree of chunks built again from the rows, and the check of rows, records and items against one
// another.
#include "base/float_environment.h"
#include "database/sqlite_api.h"
#include "shape/chunk_item.h"
#include "storage/table/stored_plans.h"

namespace foresee {
namespace {

/// Compares the starts of chunks with those that the first chunk of the plan has. A query finds the legs of few
/// instants by these, so a wrong one hides legs.
class StartsCheck {
 public:
  /// What is wrong with a chunk of `head`; null: nothing. Call it for the chunks in order.
  const char* fault(const StoredPlans::Head& head, std::int64_t number, const StoredChunk& chunk) {
    if (chunk.is_first) {
      first_ = number;
      starts_.clear();
      for (std::size_t i = 0; i < chunk.plan_chunks; ++i) starts_.push_back(chunk.start(i));
    }
    if (first_ != head.first) return nullptr;  // that chunk is damaged
    return starts_[static_cast<std::size_t>(number - first_)] == chunk.t()
               ? nullptr
               : "the first chunk of its plan has another start for it";
  }

 private:
  std::int64_t first_ = 0;
  std::vector<double> starts_;
};

}  // namespace

// A chunk that is damaged or missing is an error before anything changes; one of no object is deleted.
void StoredPlans::rebuild(std::vector<Head>& heads, std::span<const double> records, Interrupt& interrupt) {
  const FloatEnvironment environment;
  changed_.add_all();
  const auto record_size = static_cast<std::size_t>(at_.size),
             item_size = static_cast<std::size_t>(item_at_.size);
  std::vector<std::int64_t> strays;
  std::vector<double> item(item_size);
  std::vector<Leg> legs;
  StartsCheck starts;
  const auto for_each_item = [&](const TreeStore::UseObject& use) {
    bool goes_on = true;
    strays.clear();
    const auto read_chunk = [&](const Head& head, std::int64_t number, std::span<const std::byte> blob) {
      if (!goes_on) return;
      legs.clear();
      const StoredChunk chunk = opened(number, blob, &head);
      require(starts.fault(head, number, chunk), number);
      require(append_legs(chunk, legs), number);
      write_chunk_item(layout_, records.data() + head.record * record_size, legs, item.data());
      goes_on = use(number, item.data());
    };
    scan(
        heads, read_chunk, [&](std::int64_t number) { strays.push_back(number); }, interrupt);
  };
  TreeStore::Replacement replacement(tree_, interrupt);
  replacement.read(for_each_item);
  std::int64_t total = 0;
  for (const Head& head : heads) total += head.chunks;
  if (total != static_cast<std::int64_t>(replacement.objects()))
    throw_damaged(name_, "its objects have " + std::to_string(total) + " chunks, but " +
                             std::to_string(replacement.objects()) + " are stored");
  replacement.write();
  if (strays.empty()) return;
  join();
  abandon_newest_mark();
  for (const std::int64_t number : strays) rows_->erase(number, number);
}

namespace {

/// Compares the rows of plans with the objects and with the items, one chunk after another.
class PlansCheck {
 public:
  PlansCheck(StoredPlans& plans, std::span<const double> records, const StoredPlans::Say& say)
      : plans_(plans),
        say_(say),
        records_(records),
        at_(record_offsets(plans.layout())),
        item_at_(record_offsets(plans.tree().format().layout)) {}

  /// Calls it for each chunk of `head`, in order.
  void chunk(const StoredPlans::Head& head, std::int64_t number, const StoredChunk& chunk,
             std::span<const Leg> legs) {
    const double* const record = records_.data() + head.record * static_cast<std::size_t>(at_.size);
    if (number == head.first) {
      if (!starts_with(record, legs.front())) say_(object(head) + " has another first leg than its plan");
      plan_legs_ = chunk.plan_legs;
      legs_ = 0;
    } else if (!(until_ <= legs.front().t)) {
      say_(name(number) + " starts before the chunk before it ends");
    }
    until_ = legs.back().until;
    legs_ += legs.size();
    if (number == head.last() && legs_ != plan_legs_)
      say_(object(head) + " has another number of legs than its first chunk");
    item(record, number, legs);
  }

  static std::string name(std::int64_t number) { return "chunk " + std::to_string(number); }
  static std::string object(const StoredPlans::Head& head) { return "object " + std::to_string(head.object); }

 private:
  bool starts_with(const double* record, const Leg& leg) const {
    bool same = record[at_.t] == leg.t;
    for (int axis = 0; axis < plans_.layout().axes; ++axis) {
      const auto j = static_cast<std::size_t>(axis);
      same &= record[at_.x + axis] == leg.x[j] && record[at_.v + axis] == leg.v[j] &&
              (at_.a == Offsets::absent || record[at_.a + axis] == leg.a[j]);
    }
    return same;
  }

  /// The box may be larger than that of write_chunk_item(): another version may have written it.
  void item(const double* record, std::int64_t number, std::span<const Leg> legs) {
    const double* const item = plans_.tree().nodes().find_record(number);
    if (!item) return say_(name(number) + " is missing in the tree of chunks");
    std::vector<double> own(static_cast<std::size_t>(item_at_.size));
    write_chunk_item(plans_.layout(), record, legs, own.data(), item);
    bool contains = item[item_at_.t] <= own[static_cast<std::size_t>(item_at_.t)] &&
                    own[static_cast<std::size_t>(item_at_.until)] <= item[item_at_.until];
    for (int axis = 0; axis < plans_.layout().axes; ++axis)
      contains &= own[static_cast<std::size_t>(item_at_.half + axis)] <= item[item_at_.half + axis];
    if (!contains) say_(name(number) + " is not within its box");
    for (const int place : {item_at_.category, item_at_.mask})
      if (place != Offsets::absent && own[static_cast<std::size_t>(place)] != item[place])
        say_(name(number) + " has other kinds than its object");
  }

  StoredPlans& plans_;
  const StoredPlans::Say& say_;
  std::span<const double> records_;
  Offsets at_, item_at_;
  double until_ = 0;                      ///< of the chunk before
  std::size_t legs_ = 0, plan_legs_ = 0;  ///< of the object so far, and as its first chunk says
};

}  // namespace

void StoredPlans::check(std::vector<Head>& heads, std::span<const double> records, const Say& say,
                        Interrupt& interrupt) {
  const FloatEnvironment environment;
  PlansCheck check(*this, records, say);
  StartsCheck starts;
  std::vector<Leg> legs;
  std::int64_t found = 0, total = 0, sound = 0;
  const auto read_chunk = [&](const Head& head, std::int64_t number, std::span<const std::byte> blob) {
    ++found;
    try {
      legs.clear();
      const StoredChunk chunk = opened(number, blob, &head);
      require(starts.fault(head, number, chunk), number);
      require(append_legs(chunk, legs), number);
      check.chunk(head, number, chunk, legs);
      ++sound;
    } catch (const StoreError& error) {
      if (!error.is_damage()) throw;
      say(without_name(name_, error.what()));
    }
  };
  scan(
      heads, read_chunk, [&](std::int64_t number) { say(PlansCheck::name(number) + " is of no object"); },
      interrupt);
  for (const Head& head : heads) total += head.chunks;
  if (found != total)
    say("its objects have " + std::to_string(total) + " chunks, but " + std::to_string(found) +
        " are stored");
  const std::int64_t items = tree_rows_->map().count_ids();
  if (sound == found && items != found)
    say("the tree of chunks has " + std::to_string(items) + " of them, but " + std::to_string(found) +
        " are stored");
}

}  // namespace foresee
