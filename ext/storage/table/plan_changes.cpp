// StoredPlans: the numbers, items and rows of the plans that one change adds, keeps and removes.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/float_environment.h"
#include "database/sqlite_api.h"
#include "database/statement.h"
#include "motion/plan/plan_legs.h"
#include "shape/chunk_item.h"
#include "storage/table/stored_plans.h"

namespace foresee {
namespace {

/// What of a record an item depends on, besides its legs: from the sizes to the kinds.
std::span<const double> item_inputs(const Offsets& at, int axes, std::span<const double> record) {
  const auto first = static_cast<std::size_t>((at.a == Offsets::absent ? at.v : at.a) + axes);
  return record.subspan(first, static_cast<std::size_t>(at.plan) - first);
}

/// About the work on one chunk, in steps of Steps.
constexpr unsigned chunk_steps = 64;

bool equal_bits(std::span<const double> a, std::span<const double> b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

}  // namespace

std::int64_t StoredPlans::last_number() {
  return std::max(last_number_, rows_->read_largest());
}

StoredPlans::Change::~Change() {
  if (written_ == 0 || finished_) return;
  // After some errors SQLite has rolled everything back: another connection may have these numbers by now.
  if (rolled_back_) return;
  try {
    plans_->rows_->erase(first_, first_ + written_ - 1);
  } catch (...) {
    try {
      plans_->abandon_newest_mark();
    } catch (...) {
    }
  }
}

std::span<const double> StoredPlans::Change::add(std::int64_t id, std::span<const double> record,
                                                 const Plan& plan, const Head* before) {
  StoredPlans& plans = *plans_;
  const FloatEnvironment environment;
  if (plan.axes != plans.layout_.axes)
    throw Error("a plan of " + std::to_string(plan.axes) + " axes, where objects have " +
                std::to_string(plans.layout_.axes));
  check_size(plan);
  StatementInterrupt interrupt(plans.db_);
  Steps steps(interrupt);
  const auto legs = static_cast<unsigned>(leg_count(plan));
  check_plan(plan);
  steps.costly(legs);
  added_.emplace(plan, id);
  steps.costly(legs);
  first_ = plans.last_number() + 1;
  const auto chunks = static_cast<std::int64_t>(added_->chunks());
  if (first_ > largest_chunk_number - chunks)
    throw StoreError(SQLITE_FULL, plans.name_.table + ": no number is left for a chunk");
  record_.assign(record.begin(), record.end());
  write_leg(plans.at_, plans.layout_.axes, added_->all_legs().front(), record_.data());
  record_[static_cast<std::size_t>(plans.at_.plan)] = static_cast<double>(first_);
  record_[static_cast<std::size_t>(plans.at_.chunks)] = static_cast<double>(chunks);
  plans.tree_.reporting_damage([&] { add_items(before, steps); });
  if (before) note_removed(*before);
  return record_;
}

// A plan is often replaced by one that leads through the same places at nearly the same times. So a new chunk takes the
// place of the old one that starts nearest in time, where it fits. That writes one leaf. An erasure and an insertion
// write two, and the entries above both.
void StoredPlans::Change::add_items(const Head* before, Steps& steps) {
  TreeStore& tree = plans_->tree_;
  const auto t_at = static_cast<std::size_t>(plans_->item_at_.t);
  std::vector<double> item(static_cast<std::size_t>(plans_->item_at_.size));
  std::int64_t old = before ? before->first : 1, last = before ? before->last() : 0;
  const auto away = [&](std::int64_t number) {
    const double* const other = tree.nodes().find_record(number);
    return other ? std::abs(other[t_at] - item[t_at]) : 0;
  };
  for (std::size_t i = 0; i < added_->chunks(); ++i) {
    steps.costly(chunk_steps);
    const std::int64_t number = first_ + static_cast<std::int64_t>(i);
    write_chunk_item(plans_->layout_, record_.data(), added_->legs(i), item.data());
    while (old < last && away(old + 1) <= away(old)) erase_item(old++);
    if (old <= last && tree.replace(old, number, item))
      ++old;
    else
      tree.insert(number, item);
  }
  while (old <= last) erase_item(old++);
}

std::span<const double> StoredPlans::Change::keep(std::int64_t id, std::int64_t new_id,
                                                  std::span<const double> before,
                                                  std::span<const double> record) {
  StoredPlans& plans = *plans_;
  const Offsets& at = plans.at_;
  const int axes = plans.layout_.axes;
  const bool had_plan = !before.empty() && has_plan(at, before.data());
  record_.assign(record.begin(), record.end());
  if (!had_plan || !has_plan(at, record.data())) {
    record_[static_cast<std::size_t>(at.plan)] = record_[static_cast<std::size_t>(at.chunks)] = 0;
    if (had_plan) remove(id, before);
    return record_;
  }
  if (before[static_cast<std::size_t>(at.plan)] != record[static_cast<std::size_t>(at.plan)])
    throw Error(plans.name_.table + ": object " + std::to_string(id) + " has another plan");
  record_[static_cast<std::size_t>(at.chunks)] = before[static_cast<std::size_t>(at.chunks)];
  const auto motion_end = static_cast<std::size_t>((at.a == Offsets::absent ? at.v : at.a) + axes);
  std::copy_n(before.begin(), motion_end, record_.begin());
  const Head head = plans.head_of(id, record_.data());
  plans.changed_.add(head.first, head.last());
  if (new_id != id) {
    moved_ = head;
    moved_->object = new_id;
  }
  if (equal_bits(item_inputs(at, axes, before), item_inputs(at, axes, record_))) return record_;
  std::vector<double> item(static_cast<std::size_t>(plans.item_at_.size));
  std::vector<Leg> legs;
  std::int64_t next = head.first;
  const FloatEnvironment environment;
  plans.rows_->read(head.first, head.last(), [&](std::int64_t number, std::span<const std::byte> blob) {
    legs.clear();
    plans.require(append_legs(plans.opened(number, blob, &head), legs), number);
    write_chunk_item(plans.layout_, record_.data(), legs, item.data());
    if (!plans.tree_.update(number, item))
      throw_damaged(plans.name_,
                    "chunk " + std::to_string(number) + " is missing in " + plans.name_.table + "_chunkmap");
    ++next;
  });
  if (next != head.last() + 1)
    throw_damaged(plans.name_, "a chunk of object " + std::to_string(id) + " is missing");
  return record_;
}

void StoredPlans::Change::remove(std::int64_t id, std::span<const double> record) {
  if (record.empty() || !has_plan(plans_->at_, record.data())) return;
  const Head head = plans_->head_of(id, record.data());
  plans_->tree_.reporting_damage([&] {
    for (std::int64_t number = head.first; number <= head.last(); ++number) erase_item(number);
  });
  note_removed(head);
}

void StoredPlans::Change::erase_item(std::int64_t number) {
  if (!plans_->tree_.erase(number))
    throw_damaged(plans_->name_,
                  "chunk " + std::to_string(number) + " is missing in " + plans_->name_.table + "_chunkmap");
}

void StoredPlans::Change::note_removed(const Head& head) {
  plans_->changed_.add(head.first, head.last());
  plans_->last_number_ = std::max(plans_->last_number_, head.last());
  removed_.push_back(head);
}

void StoredPlans::Change::write() {
  if (!added_) return;
  plans_->last_number_ =
      std::max(plans_->last_number_, first_ + static_cast<std::int64_t>(added_->chunks()) - 1);
  for (std::size_t i = 0; i < added_->chunks(); ++i) {
    plans_->rows_->write(first_ + written_, added_->blob(i, first_ + written_));
    ++written_;
  }
}

void StoredPlans::Change::finish() {
  if (!removed_.empty() || moved_) {
    plans_->join();
    plans_->abandon_newest_mark();
  }
  for (const Head& head : removed_) plans_->rows_->erase(head.first, head.last());
  if (moved_)
    for (std::int64_t number = moved_->first; number <= moved_->last(); ++number) {
      std::vector<std::byte> changed;
      plans_->rows_->read_one(number, [&](std::span<const std::byte> blob) {
        plans_->opened(number, blob, nullptr);
        changed = chunk_of_object(blob, number, moved_->object);
      });
      if (changed.empty()) throw_damaged(plans_->name_, "chunk " + std::to_string(number) + " is missing");
      plans_->rows_->write(number, changed);
    }
  finished_ = true;
}

}  // namespace foresee
