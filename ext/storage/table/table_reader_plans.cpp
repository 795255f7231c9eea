// TableReader: plans of objects, for queries, and for 'rebuild'.
#include "format/leaf_node.h"
#include "storage/table/table_reader.h"

namespace foresee {
// The plans of a table for walks. The plan of an object is compared with its chunks once per object, while chunks of
// the same object are read one after another.
class TableReader::Chunks final : public ChunkSource {
 public:
  Chunks(std::shared_ptr<TableReader> table, StoredPlans& plans) : table_(std::move(table)), plans_(plans) {}

  NodeSource& tree() override { return plans_.tree().nodes(); }

  void prefetch_chunk(std::int64_t number) override { plans_.prefetch_chunk(number); }
  void read_chunk(std::int64_t number, const LegTimes& times, Chunk& chunk) override {
    const std::optional<std::int64_t> stamp = table_->committed_stamp();
    if (!plans_.read_chunk(number, times, stamp, chunk))
      throw_damaged(plans_.name(), "chunk " + std::to_string(number) + " is missing");
    if (!chunk.record.empty()) return;
    if (!head_ || head_->object != chunk.object || !head_->has(number)) find_head(number, chunk.object);
    chunk.record = record_;
    if (stamp) plans_.add_record(number, record_);
  }

 private:
  void find_head(std::int64_t number, std::int64_t object) {
    const std::span<const double> record = table_->find(object, statement_state_);
    record_.assign(record.begin(), record.end());
    const bool is_known = !record_.empty() && has_plan(table_->format().at, record_.data());
    if (is_known) head_ = plans_.head_of(object, record_.data());
    if (!is_known || !head_->has(number))
      throw_damaged(plans_.name(), "chunk " + std::to_string(number) + " is not of the plan of object " +
                                       std::to_string(object));
  }

  std::shared_ptr<TableReader> table_;
  StoredPlans& plans_;
  StatementReadState statement_state_;
  std::optional<StoredPlans::Head> head_;
  std::vector<double> record_;
};

// --- reading

Plan TableReader::read_plan(std::int64_t id, std::span<const double> record) {
  transaction_.require_usable();
  return plans_->read(plans_->head_of(id, record.data()));
}

void TableReader::read_legs(std::int64_t id, std::span<const double> record, const LegTimes& times,
                            StatementReadState& statement_state, std::vector<Leg>& legs) {
  revalidate_cache(&statement_state);  // under another stamp the same number may be a chunk of another plan
  plans_->read_legs(plans_->head_of(id, record.data()), times, committed_stamp(), legs);
}

std::shared_ptr<ChunkSource> TableReader::chunks() {
  if (!plans_) return nullptr;
  return std::make_shared<Chunks>(shared_from_this(), *plans_);
}

std::vector<StoredPlans::Head> TableReader::read_heads(const EachObject& plain, std::vector<double>& records,
                                                       Interrupt& interrupt) {
  const auto size = static_cast<std::size_t>(format_.at.size);
  std::size_t objects = 0;
  std::vector<StoredPlans::Head> heads;
  tree_.read_leaves(interrupt, [&](const Node& leaf) {
    objects += leaf.size();
    for (std::size_t i = 0; i < leaf.size(); ++i) {
      const std::int64_t id = leaf.keys[i];
      const std::span<const double> record(leaf.values.data() + i * size, size);
      if (!has_plan(format_.at, record.data())) {
        plain(id, record, {});
        continue;
      }
      heads.push_back(plans_->head_of(id, record.data(), heads.size()));
      records.insert(records.end(), record.begin(), record.end());
    }
  });
  expect_objects(objects);
  return heads;
}

void TableReader::read_objects(double from, double until, const EachObject& each, Interrupt& interrupt) {
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

}  // namespace foresee
