// Reading a moving_objects table: objects by id, leaf by leaf or in order, their plans and forms, and snapshots.
//
//   store.find(42, statement_state)                       // its record; empty: there is no such object
//   store.read_all(ids, rows, interrupt);                 // all objects, for a query
//   store.take_snapshot()                                 // the tree as it is now, whatever is written meanwhile
//
// Every double is returned bit for bit. Reads see all that this transaction has written.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "storage/nodes/id_map.h"
#include "storage/table/table_contents.h"

namespace foresee {

class TableReader : public TableContents,
                    public FormSource,
                    public std::enable_shared_from_this<TableReader> {
 public:
  /// The declared frame. Without a declared origin, with the one that the first position has chosen (empty: none yet),
  /// as this connection sees it now; that costs as much as read_version().
  const Frame& frame();
  /// frame() of a table that holds objects: SQLITE_CORRUPT_VTAB for degrees without an origin.
  const Frame& frame_of_objects(StatementReadState* statement_state = nullptr);

  bool contains(std::int64_t id);
  std::optional<std::vector<double>> read(std::int64_t id);
  /// read() for a statement that reads repeatedly; empty if there is no object. Valid until the next call.
  /// Cost: one look-up of the stamp per statement, then about 100 ns if the leaf is in memory.
  std::span<const double> find(std::int64_t id, StatementReadState& statement_state);
  /// Prefetches `many` ids from `first` on, as far as they are in memory. Changes nothing.
  void fetch_ahead(std::int64_t first, std::int64_t many) { tree_.nodes().fetch_ahead(first, many); }
  /// All ids and rows (row_from_record of each record), one leaf after another. SQLITE_CORRUPT_VTAB for a damaged leaf,
  /// and as in expect_objects(). With `wanted`, only the objects that it accepts; leaves without one may not be read.
  /// Returns whether these are all objects.
  bool read_all(std::vector<std::int64_t>& ids, std::vector<double>& rows, Interrupt& interrupt,
                const std::optional<KindTest>& wanted = {});
  /// Reads the leaf after leaf `after` (0: the first one). Returns its number, or 0 at the end.
  NodeNumber next_leaf(NodeNumber after, Node& leaf);
  /// Call it after reading every leaf: SQLITE_CORRUPT_VTAB if the map, when written, has another count.
  void expect_objects(std::size_t found);
  /// The ids of a range in order. Nothing if no order is wanted and a scan probably costs less than their look-ups.
  std::optional<IdWalk> walk_ids(const IdRange& range, std::optional<IdOrder> order);
  bool next_ids(IdWalk& walk, std::vector<std::int64_t>& ids);  ///< as IdWalk::next()
  /// Sets the auxiliary column of `id`, or NULL, as the result of `context`.
  void result_auxiliary(sqlite3_context* context, std::int64_t id, int column);
  /// A snapshot of the tree, which no change, commit or rollback affects. It must not outlive the statement, whose read
  /// transaction preserves the rows.
  std::shared_ptr<NodeSource> take_snapshot(StatementReadState* statement_state = nullptr);
  /// The largest reference time stored; 0 without objects or without t. Reads one node.
  double read_newest_t(StatementReadState* statement_state = nullptr);

  /// The outlines or meshes, by the number in a record; null in a table without.
  FormSource* forms() { return forms_ ? this : nullptr; }
  std::shared_ptr<const Form> form(std::int64_t number) override;
  /// form() for a statement that reads the table repeatedly.
  std::shared_ptr<const Form> form(std::int64_t number, StatementReadState& statement_state);

  // --- plans (table_reader_plans.cpp); requires: a layout with plans
  /// The plan of an object as it was written. Requires: the record of the object, with a plan.
  Plan read_plan(std::int64_t id, std::span<const double> record);
  /// Its legs that exist at some of these times, in order; the object's `until` has not cut them. Cost: two look-ups.
  void read_legs(std::int64_t id, std::span<const double> record, const LegTimes& times,
                 StatementReadState& statement_state, std::vector<Leg>& legs);
  /// The plans for walks; null in a layout without. Valid until the next write. Requires: the statement has taken a
  /// snapshot since it started, and has written nothing since.
  std::shared_ptr<ChunkSource> chunks();
  using EachObject =
      std::function<void(std::int64_t id, std::span<const double> record, std::span<const Leg> legs)>;
  /// Calls each() for every object, those without a plan first, with no legs. The others have the legs of the chunks
  /// that last at some time from `from` to `until`; objects without such a chunk are left out. It reads layouts without
  /// plans too. Requires: each() reads no plan of this table. Cost: some 20 ns per leg.
  void read_objects(double from, double until, const EachObject& each, Interrupt& interrupt);

 protected:
  using TableContents::TableContents;
  ~TableReader() = default;

  /// Calls plain() for every object without a plan. Returns the others; appends their records, in this order.
  std::vector<StoredPlans::Head> read_heads(const EachObject& plain, std::vector<double>& records,
                                            Interrupt& interrupt);

 private:
  class Snapshot;
  class Chunks;

  Frame frame_ = declaration_.frame;  ///< what frame() returns
  std::vector<double> first_found_;   ///< the record that find() has read without the cache
};

}  // namespace foresee
