// TableReader: reads, from pending objects and dirty nodes first, then from the shadow rows.
#include "storage/table/table_reader.h"

#include "database/value_text.h"
#include "format/leaf_node.h"

namespace foresee {
namespace {

/// Appends the ids and rows of the objects in leaves; with `wanted`, only of those that it accepts.
class LeafRows {
 public:
  LeafRows(const NodeFormat& format, const std::optional<KindTest>& wanted, std::vector<std::int64_t>& ids,
           std::vector<double>& rows)
      : format_(format),
        wanted_(wanted),
        record_size_(static_cast<std::size_t>(format.at.size)),
        row_size_(static_cast<std::size_t>(row_offsets(format.layout).size)),
        ids_(ids),
        rows_(rows) {}

  void reserve(std::size_t objects) {
    ids_.reserve(objects);
    rows_.reserve(objects * row_size_);
  }

  void add(const Node& leaf) {
    objects_ += leaf.size();
    if (row_size_ == record_size_ && !wanted_) {  // rows are records
      ids_.insert(ids_.end(), leaf.keys.begin(), leaf.keys.end());
      rows_.insert(rows_.end(), leaf.values.begin(), leaf.values.end());
      return;
    }
    std::size_t end = ids_.size();
    ids_.resize(end + leaf.size());
    rows_.resize((end + leaf.size()) * row_size_);
    for (std::size_t i = 0; i < leaf.size(); ++i) {
      const double* const record = leaf.values.data() + i * record_size_;
      if (wanted_ && !wanted_->accepts(kinds_of(record, format_.at))) continue;
      ids_[end] = leaf.keys[i];
      row_from_record(format_.layout, record, rows_.data() + end * row_size_);
      ++end;
    }
    ids_.resize(end);
    rows_.resize(end * row_size_);
  }

  /// Those of all leaves so far, wanted or not.
  std::size_t objects() const { return objects_; }

 private:
  const NodeFormat& format_;
  const std::optional<KindTest>& wanted_;
  std::size_t record_size_, row_size_;
  std::vector<std::int64_t>& ids_;
  std::vector<double>& rows_;
  std::size_t objects_ = 0;
};

/// So few that the share of all ids need not be known.
bool has_few_ids(const IdRange& range) {
  return static_cast<std::uint64_t>(range.last) - static_cast<std::uint64_t>(range.first) < 256;
}

/// The share of all ids that are in the range, if they are spread evenly.
double likely_share(const std::optional<IdRange>& all, const IdRange& range) {
  if (!all) return 1;
  const auto count = [](std::int64_t first, std::int64_t last) {
    return std::max(0.0, static_cast<double>(last) - static_cast<double>(first) + 1);
  };
  return count(std::max(all->first, range.first), std::min(all->last, range.last)) /
         count(all->first, all->last);
}

}  // namespace

// It holds the table and a position in the history of its nodes (node_history.h).
class TableReader::Snapshot final : public NodeSource, private FormSource {
 public:
  explicit Snapshot(std::shared_ptr<TableReader> table)
      : table_(std::move(table)),
        root_(table_->nodes().find_root()),
        forms_(table_->forms_ ? table_->forms_->known() : nullptr),
        nodes_(table_->nodes().take_snapshot()) {}
  ~Snapshot() override { table_->tree_.nodes().give_up(nodes_); }
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;

  const Layout& layout() const override { return table_->format().layout; }
  NodeNumber find_root() override { return root_; }
  std::shared_ptr<const Node> read(NodeNumber number) override {
    return table_->nodes().read_at(nodes_, number);
  }
  FormSource* forms() override { return forms_ ? this : nullptr; }

 private:
  /// From the forms at the time of the snapshot first: a rollback may have removed rows.
  std::shared_ptr<const Form> form(std::int64_t number) override {
    const auto known = forms_->find(number);
    return known == forms_->end() ? table_->form(number) : known->second;
  }

  std::shared_ptr<TableReader> table_;
  NodeNumber root_;
  std::shared_ptr<const StoredForms::ByNumber> forms_;  ///< null: the layout has no forms
  NodeHistory::Snapshot nodes_;
};

std::shared_ptr<NodeSource> TableReader::take_snapshot(StatementReadState* statement_state) {
  revalidate_cache(statement_state);
  merge_pending();
  return std::make_shared<Snapshot>(shared_from_this());
}

const Frame& TableReader::frame() {
  if (!declaration_.frame.chooses_origin()) return frame_;
  revalidate_cache();
  if (!origin_->known) {
    const std::string stored = shadow_rows().meta().read("origin");
    const std::optional<LatLon> origin = parse_origin(stored);
    if (!origin && !stored.empty())
      throw_damaged(name_, "the origin '" + without_nul(stored) + "' in _meta is no latitude and longitude");
    if (!origin && shadow_rows().tree().read_root().value_or(0) != 0)
      throw_damaged(name_, "the origin is missing in _meta");
    origin_.change() = {.known = true, .value = origin};
  }
  frame_.origin = origin_->value;
  return frame_;
}

const Frame& TableReader::frame_of_objects(StatementReadState* statement_state) {
  if (!declaration_.frame.chooses_origin()) return frame_;
  if (!version().is_checked(statement_state) || !origin_->known) frame();
  version().note_checked(statement_state);
  if (!origin_->value) throw_damaged(name_, "the origin is missing in _meta");
  frame_.origin = origin_->value;
  return frame_;
}

bool TableReader::contains(std::int64_t id) {
  transaction_.resolve_doubt();
  // New ascending ids, the common case, are larger than any known id.
  const LargestId& largest = totals_->largest;
  if (largest.known && (!largest.id || *largest.id < id)) return false;
  if (tree_.pending().find(id)) return true;
  if (tree_.pending().is_erased(id)) return false;
  return (version().written_here() ? nodes().find_leaf(id) : shadow_rows().tree().map().find_leaf(id))
      .has_value();
}

std::optional<std::vector<double>> TableReader::read(std::int64_t id) {
  transaction_.resolve_doubt();
  const auto size = static_cast<std::size_t>(format_.at.size);
  if (tree_.pending().is_erased(id)) return std::nullopt;
  const double* found = tree_.pending().find(id);
  if (!found && version().written_here()) found = nodes().find_record(id);
  if (found) return std::vector<double>(found, found + size);
  std::vector<double> record;
  if (version().written_here() || !tree().read_stored(id, record)) return std::nullopt;
  return record;
}

std::span<const double> TableReader::find(std::int64_t id, StatementReadState& statement_state) {
  const auto size = static_cast<std::size_t>(format_.at.size);
  const auto found = [size](const double* record) { return std::span(record, record ? size : 0); };
  transaction_.resolve_doubt();
  if (const double* record = tree_.pending().find(id)) return found(record);
  if (tree_.pending().is_erased(id)) return found(nullptr);
  if (version().written_here()) return found(nodes().find_record(id));
  if (version().is_checked(&statement_state)) {
    if (const double* record = nodes().find_record_in_memory(id)) return found(record);
    if (!nodes().find_leaf(id)) return found(nullptr);
  }
  // The first row after opening should not wait until one more statement is compiled.
  if (!version().seen() && first_found_.empty())
    return tree().read_stored(id, first_found_) ? found(first_found_.data()) : found(nullptr);
  // Also before a node is read: with uncommitted reads (shared cache) it may belong to another stamp.
  revalidate_cache(&statement_state);
  return found(nodes().find_record(id));
}

bool TableReader::read_all(std::vector<std::int64_t>& ids, std::vector<double>& rows, Interrupt& interrupt,
                           const std::optional<KindTest>& wanted) {
  merge_pending();
  ids.clear();
  rows.clear();
  WantedLeaves leaves;
  if (wanted) leaves = tree_.reporting_damage([&] { return find_leaves(nodes(), *wanted, interrupt); });
  // A leaf by number costs more than the next one of a scan.
  const bool by_number = leaves.others > leaves.numbers.size() / 2;
  LeafRows found(format_, wanted, ids, rows);
  const auto add_leaf = [&](const Node& leaf) { found.add(leaf); };
  if (by_number) {
    found.reserve(leaves.numbers.size() * format_.leaf_capacity);
    tree_.read_leaves(leaves.numbers, interrupt, add_leaf);
    return false;
  }
  if (!nodes().has_unwritten())
    found.reserve(static_cast<std::size_t>(shadow_rows().tree().map().count_ids()));
  tree_.read_leaves(interrupt, add_leaf);
  expect_objects(found.objects());
  return ids.size() == found.objects();
}

void TableReader::expect_objects(std::size_t found) {
  totals_.change().count.note_all(found);
  tree().require_as_many(found);
}

NodeNumber TableReader::next_leaf(NodeNumber after, Node& leaf) {
  if (after == 0) merge_pending();
  return tree().next_leaf(after, leaf);
}

std::optional<IdWalk> TableReader::walk_ids(const IdRange& range, std::optional<IdOrder> order) {
  revalidate_cache();
  merge_pending();
  // An object of a scan costs as much as a tenth of a look-up in memory, or a sixtieth of one that reads a leaf.
  const bool fits = static_cast<double>(likely_objects()) * static_cast<double>(format_.record_size) <
                    static_cast<double>(memory_->max_kept());
  const double small_share = fits ? 0.1 : 0.016;
  if (!order && !has_few_ids(range) && likely_share(nodes().id_extent(), range) > small_share)
    return std::nullopt;
  return nodes().walk_ids(range, order.value_or(IdOrder::ascending));
}

bool TableReader::next_ids(IdWalk& walk, std::vector<std::int64_t>& ids) {
  transaction_.require_usable();
  return walk.next(ids);
}

void TableReader::result_auxiliary(sqlite3_context* context, std::int64_t id, int column) {
  shadow_rows().result_auxiliary(context, id, column);
}

double TableReader::read_newest_t(StatementReadState* statement_state) {
  revalidate_cache(statement_state);
  merge_pending();
  return tree_.reporting_damage([&] { return foresee::read_newest_t(nodes()); });
}

std::shared_ptr<const Form> TableReader::form(std::int64_t number) {
  revalidate_cache();  // under another stamp the number may refer to another form
  return forms_->form(number);
}

std::shared_ptr<const Form> TableReader::form(std::int64_t number, StatementReadState& statement_state) {
  revalidate_cache(&statement_state);
  return forms_->form(number);
}

}  // namespace foresee
