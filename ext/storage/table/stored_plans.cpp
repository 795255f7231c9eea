#include "storage/table/stored_plans.h"

#include <algorithm>
#include <bit>

#include "base/axes.h"
#include "base/float_environment.h"
#include "database/sqlite_api.h"
#include "index/tpr_tree/node.h"
#include "motion/plan/plan_legs.h"

namespace foresee {
namespace {

/// So few are looked up one by one, in memory first; a range of rows is faster for more.
constexpr std::int64_t few_chunks = 8;

}  // namespace

// The page size at CREATE is not stored. Both trees take the smallest page that gives the size of the first one.
NodeFormat chunk_node_format(const NodeFormat& objects) {
  const Layout layout = chunk_layout(objects.layout);
  const std::size_t page = NodeFormat::page_size_for(objects.layout, objects.node_size).value();
  return NodeFormat(layout, NodeFormat::node_size_for(layout, page));
}

StoredPlans::StoredPlans(sqlite3* db, const NodeFormat& format, const QualifiedName& name, double horizon,
                         Journal& journal, MemoryBudget& memory, std::function<void()> write_out)
    : Participant(journal, Scope::transaction),
      db_(db),
      name_(name),
      layout_(format.layout),
      at_(format.at),
      item_at_(record_offsets(chunk_layout(layout_))),
      tree_(db, chunk_node_format(format), tree_name_, horizon, journal, memory, std::move(write_out)),
      cache_(memory, static_cast<std::size_t>(at_.size)) {}

void StoredPlans::connect(const ShadowTables& tables, MetaRows& meta) {
  tree_name_ = {tables.name().schema, tables.name().table + "_chunk"};
  rows_.emplace(tables, "leg", "number");
  tree_rows_.emplace(tables, meta, "chunk");
  tree_.connect(*tree_rows_);
}

void StoredPlans::require(const char* fault, std::int64_t number) const {
  if (fault) throw_damaged(name_, "chunk " + std::to_string(number) + " is damaged: " + fault);
}

// --- reading

StoredPlans::Head StoredPlans::head_of(std::int64_t object, const double* record, std::size_t place) const {
  return {object, static_cast<std::int64_t>(record[at_.plan]), static_cast<std::int64_t>(record[at_.chunks]),
          place};
}

StoredChunk StoredPlans::opened(std::int64_t number, std::span<const std::byte> blob,
                                const Head* head) const {
  StoredChunk chunk;
  require(open_chunk(layout_, blob, number, chunk), number);
  if (head) require_of(*head, number, chunk);
  return chunk;
}

void StoredPlans::require_of(const Head& head, std::int64_t number, const StoredChunk& chunk) const {
  if (chunk.object != head.object)
    throw_damaged(name_, "chunk " + std::to_string(number) + " is of object " + std::to_string(chunk.object) +
                             ", not of object " + std::to_string(head.object));
  if (chunk.is_first != (number == head.first) ||
      (chunk.is_first && static_cast<std::int64_t>(chunk.plan_chunks) != head.chunks))
    throw_damaged(name_, "chunk " + std::to_string(number) + " is not where object " +
                             std::to_string(head.object) + " has it");
}

template <class Use>
bool StoredPlans::with_chunk(std::int64_t number, std::optional<std::int64_t> stamp, Use use) {
  const ChunkCache::Entry* const known = stamp ? cache_.find(*stamp, number) : nullptr;
  if (known) {
    use(known->chunk(), known->record());
    return true;
  }
  return rows_->read_one(number, [&](std::span<const std::byte> blob) {
    const StoredChunk stored = opened(number, blob, nullptr);
    require(check_legs(stored), number);
    use(stored, std::span<const double>());
    if (stamp) cache_.add(number, blob, stored);
  });
}

Plan StoredPlans::read(const Head& head) {
  const FloatEnvironment environment;
  Plan plan;
  std::int64_t next = head.first;
  std::size_t legs = 0;
  rows_->read(head.first, head.last(), [&](std::int64_t number, std::span<const std::byte> blob) {
    if (number != next++) return;
    const StoredChunk chunk = opened(number, blob, &head);
    if (chunk.is_first) legs = chunk.plan_legs;
    require(append_to_plan(chunk, plan), number);
  });
  if (next != head.first + head.chunks)
    throw_damaged(name_, "a chunk of object " + std::to_string(head.object) + " is missing");
  if (plan.kind == PlanKind::knots) {
    if (plan.part_starts.back() != plan.knots.size())
      throw_damaged(name_, "the plan of object " + std::to_string(head.object) + " has no end");
    plan.part_starts.pop_back();
  }
  if (leg_count(plan) != legs)
    throw_damaged(
        name_, "object " + std::to_string(head.object) + " has another number of legs than its first chunk");
  return plan;
}

void StoredPlans::read_legs(const Head& head, const LegTimes& times, std::optional<std::int64_t> stamp,
                            std::vector<Leg>& legs) {
  const FloatEnvironment environment;
  legs.clear();
  std::int64_t first = head.first, last = head.first - 1;
  const bool has_first = with_chunk(head.first, stamp, [&](const StoredChunk& chunk, auto) {
    require_of(head, head.first, chunk);
    std::size_t begin = 0, end = 0;
    for (std::size_t step = std::bit_floor(chunk.plan_chunks); step > 0; step /= 2) {
      if (end + step <= chunk.plan_chunks && chunk.start(end + step - 1) <= times.until) end += step;
      if (begin + step < chunk.plan_chunks && chunk.start(begin + step) < times.from) begin += step;
    }
    begin = std::min(begin, end);
    first += static_cast<std::int64_t>(begin);
    last = head.first + static_cast<std::int64_t>(end) - 1;
  });
  const auto append_checked = [&](const StoredChunk& chunk, std::span<const double>) {
    require_of(head, first, chunk);
    require(append_legs(legs_during(chunk, times), legs, times), first++);
  };
  if (last - first < few_chunks)
    while (first <= last && with_chunk(first, stamp, append_checked)) {
    }
  else
    rows_->read(first, last, [&](std::int64_t number, std::span<const std::byte> blob) {
      if (number != first) return;
      require(append_legs(opened(number, blob, &head), legs, times), first++);
    });
  if (!has_first || first != last + 1)
    throw_damaged(name_, "a chunk of object " + std::to_string(head.object) + " is missing");
}

bool StoredPlans::read_chunk(std::int64_t number, const LegTimes& times, std::optional<std::int64_t> stamp,
                             Chunk& chunk) {
  const FloatEnvironment environment;
  return with_chunk(number, stamp, [&](const StoredChunk& stored, std::span<const double> record) {
    chunk.object = stored.object;
    chunk.record = record;
    chunk.legs.clear();
    require(append_legs(legs_during(stored, times), chunk.legs, times), number);
  });
}

std::vector<std::int64_t> StoredPlans::chunks_during(double from, double until, Interrupt& interrupt) {
  std::vector<std::int64_t> numbers;
  const std::size_t size = static_cast<std::size_t>(item_at_.size);
  const auto visit = [&]<int D>(Axes<D>, auto& self, NodeSource& nodes, const Unread& unread) -> void {
    interrupt.check();
    const auto node = foresee::read(nodes, unread);
    for (std::size_t slot = 0; slot < node->size(); ++slot) {
      if (node->is_leaf()) {
        const double* const item = node->values.data() + slot * size;
        if (item[item_at_.t] <= until && from <= item[item_at_.until]) numbers.push_back(node->keys[slot]);
        continue;
      }
      const Times times = times_at<D>(*node, slot);
      if (times.t_min <= until && from <= times.until_max)
        self(Axes<D>{}, self, nodes, unread_child(unread.number, *node, slot));
    }
  };
  tree_.reporting_damage([&] {
    if (tree_.nodes().find_root() == 0) return;
    with_axes(layout_.axes,
              [&](auto axes) { visit(axes, visit, tree_.nodes(), unread_root(tree_.nodes())); });
  });
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

void StoredPlans::scan(std::vector<Head>& heads, const EachRow& each, const EachStray& stray,
                       Interrupt& interrupt, const std::vector<std::int64_t>* numbers) {
  std::sort(heads.begin(), heads.end(), [](const Head& a, const Head& b) { return a.first < b.first; });
  Steps step(interrupt);
  auto head = heads.begin();
  const auto visit = [&](std::int64_t number, std::span<const std::byte> blob) {
    step();
    while (head != heads.end() && head->last() < number) ++head;
    if (head == heads.end() || number < head->first)
      stray(number);
    else
      each(*head, number, blob);
  };
  if (!numbers) return rows_->read_all(visit);
  for (const std::int64_t number : *numbers)
    if (!rows_->read_one(number, [&](std::span<const std::byte> blob) { visit(number, blob); }))
      throw_damaged(name_, "chunk " + std::to_string(number) + " is missing");
}

void StoredPlans::read_all(std::vector<Head>& heads, double from, double until, const EachPlan& each,
                           Interrupt& interrupt) {
  const FloatEnvironment environment;
  std::vector<Leg> legs;
  const Head* current = nullptr;
  std::int64_t found = 0, total = 0;
  const auto hand_over = [&] {
    if (!legs.empty()) each(*current, legs);
    legs.clear();
  };
  const auto read_chunk = [&](const Head& head, std::int64_t number, std::span<const std::byte> blob) {
    if (current != &head) {
      hand_over();
      current = &head;
    }
    const StoredChunk chunk = opened(number, blob, &head);
    if (!legs.empty() && !(legs.back().until <= chunk.t())) require("its times do not rise", number);
    require(append_legs(chunk, legs), number);
    ++found;
  };
  const auto stray = [&](std::int64_t number) {
    throw_damaged(name_, "chunk " + std::to_string(number) + " is of no object");
  };
  for (const Head& head : heads) total += head.chunks;
  if (from == -no_end && until == no_end) {
    scan(heads, read_chunk, stray, interrupt);
  } else {
    const std::vector<std::int64_t> wanted = chunks_during(from, until, interrupt);
    const bool are_few = 4 * static_cast<std::int64_t>(wanted.size()) < total;
    total = static_cast<std::int64_t>(wanted.size());
    auto next = wanted.begin();
    const auto read_if_wanted = [&](const Head& head, std::int64_t number, std::span<const std::byte> blob) {
      if (next != wanted.end() && *next == number) {
        ++next;
        read_chunk(head, number, blob);
      }
    };
    if (are_few)
      scan(heads, read_chunk, stray, interrupt, &wanted);
    else
      scan(heads, read_if_wanted, stray, interrupt);
  }
  hand_over();
  if (found != total)
    throw_damaged(name_, "its objects have " + std::to_string(total) + " chunks, but " +
                             std::to_string(found) + " are stored");
}

}  // namespace foresee
