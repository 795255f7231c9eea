// Store: plans of objects, for queries, for changes, and for 'rebuild' and 'integrity-check'.
#include "base/float_environment.h"
#include "storage/format/leaf_node.h"
#include "storage/table/store.h"

namespace foresee {
namespace {

// The plans of a store for walks. The plan of an object is compared with its chunks once per object, while chunks of
// the same object are read one after another.
class StoredChunks final : public ChunkSource {
 public:
  StoredChunks(std::shared_ptr<Store> store, StoredPlans& plans) : store_(std::move(store)), plans_(plans) {}

  NodeSource& tree() override { return plans_.tree().nodes(); }

  void prefetch_chunk(std::int64_t number) override { plans_.prefetch_chunk(number); }
  void read_chunk(std::int64_t number, const LegTimes& times, Chunk& chunk) override {
    const std::optional<std::int64_t> stamp = store_->committed_stamp();
    if (!plans_.read_chunk(number, times, stamp, chunk))
      plans_.damaged("chunk " + std::to_string(number) + " is missing");
    if (!chunk.record.empty()) return;
    if (!head_ || head_->object != chunk.object || !head_->has(number)) find_head(number, chunk.object);
    chunk.record = record_;
    if (stamp) plans_.add_record(number, record_);
  }

 private:
  void find_head(std::int64_t number, std::int64_t object) {
    const std::span<const double> record = store_->find(object, statement_state_);
    record_.assign(record.begin(), record.end());
    const bool is_known = !record_.empty() && has_plan(store_->format().at, record_.data());
    if (is_known) head_ = plans_.head_of(object, record_.data());
    if (!is_known || !head_->has(number))
      plans_.damaged("chunk " + std::to_string(number) + " is not of the plan of object " +
                     std::to_string(object));
  }

  std::shared_ptr<Store> store_;
  StoredPlans& plans_;
  StatementReadState statement_state_;
  std::optional<StoredPlans::Head> head_;
  std::vector<double> record_;
};

}  // namespace

// --- reading

Plan Store::read_plan(std::int64_t id, std::span<const double> record) {
  require_usable();
  return plans_->read(plans_->head_of(id, record.data()));
}

void Store::read_legs(std::int64_t id, std::span<const double> record, const LegTimes& times,
                      StatementReadState& statement_state, std::vector<Leg>& legs) {
  revalidate_cache(&statement_state);  // under another stamp the same number may be a chunk of another plan
  plans_->read_legs(plans_->head_of(id, record.data()), times, committed_stamp(), legs);
}

std::shared_ptr<ChunkSource> Store::chunks() {
  if (!plans_) return nullptr;
  return std::make_shared<StoredChunks>(shared_from_this(), *plans_);
}

std::vector<StoredPlans::Head> Store::read_heads(const EachObject& plain, std::vector<double>& records,
                                                 Interrupt& interrupt) {
  const auto size = static_cast<std::size_t>(format_.at.size);
  std::size_t objects = 0;
  std::vector<StoredPlans::Head> heads;
  std::vector<std::int64_t> ids;
  std::vector<double> of_leaf;
  const auto add_leaf = [&](const auto& leaf) {
    ids.clear();
    of_leaf.clear();
    append(leaf, ids, of_leaf);
    objects += ids.size();
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const std::span<const double> record(of_leaf.data() + i * size, size);
      if (!has_plan(format_.at, record.data())) {
        plain(ids[i], record, {});
        continue;
      }
      heads.push_back(plans_->head_of(ids[i], record.data(), heads.size()));
      records.insert(records.end(), record.begin(), record.end());
    }
  };
  tree_.read_leaves(interrupt, add_leaf, add_leaf);
  expect_objects(objects);
  return heads;
}

void Store::read_objects(double from, double until, const EachObject& each, Interrupt& interrupt) {
  if (plans_) revalidate_cache();
  merge_pending();
  std::vector<double> records;
  std::vector<StoredPlans::Head> heads = read_heads(each, records, interrupt);
  if (!plans_) return;
  const auto size = static_cast<std::size_t>(format_.at.size);
  const auto use = [&](const StoredPlans::Head& head, std::span<const Leg> legs) {
    each(head.object, std::span<const double>(records).subspan(head.record * size, size), legs);
  };
  plans_->read_all(heads, from, until, use, interrupt);
}

// --- changes

std::span<const double> Store::change_plans(StoredPlans::Change& plans, std::int64_t id, std::int64_t new_id,
                                            std::span<const double> record, const Plan* plan) {
  const std::optional<std::vector<double>> before = read(id);
  if (!before) throw_missing(id);
  if (new_id != id) plans.remove(new_id, read(new_id).value_or(std::vector<double>()));
  if (!plan) {
    record = plans.keep(id, new_id, *before, record);
  } else {
    std::optional<StoredPlans::Head> old;
    if (has_plan(format_.at, before->data())) old = plans_->head_of(id, before->data());
    record = plans.add(new_id, record, *plan, old ? &*old : nullptr);
  }
  require_sound(record);
  return record;
}

// --- commands

void Store::pack_plans(Interrupt& interrupt) {
  std::vector<double> records;
  const auto ignore = [](std::int64_t, std::span<const double>, std::span<const Leg>) {};
  std::vector<StoredPlans::Head> heads = read_heads(ignore, records, interrupt);
  plans_->rebuild(heads, records, interrupt);
}

}  // namespace foresee
