// The store behind object_store.h: shadow tables, and before them the changes of a write transaction that are
// not written yet.
//
//   insert ─► Pending (leaves, moved ids) ─► flush: leaves in order, then the map in key order
//   read   ─► Pending, else the tables
//
// Changes wait in memory until commit, a savepoint, or some MB; reads look there first, so that reading never
// writes. Flushing before each savepoint makes SQLite's own rollback exact: what it takes back is what was
// written since, and what was not written is dropped. Nothing read in one transaction is believed in the
// next: another connection may have written.
//
// Auxiliary values are written at once. A change first does everything that may fail (reads leaves, reserves
// memory, writes auxiliary values) and then what cannot.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "storage/object_store.h"
#include "storage/pending.h"
#include "storage/shadow_rows.h"

namespace foresee {

class Store final : public ObjectStore, public std::enable_shared_from_this<Store> {
 public:
  Store(sqlite3* db, QualifiedName name, Declaration declaration, const NodeFormat& format, bool is_new);

  const Declaration& declaration() const override { return declaration_; }
  const NodeFormat& format() const { return format_; }

  ContentVersion version() override;
  bool contains(std::int64_t id) override;
  std::optional<std::vector<double>> read(std::int64_t id) override;
  void load(std::vector<std::int64_t>& ids, std::vector<double>& rows, Interrupt& interrupt) override;
  std::int64_t next_leaf(std::int64_t after, std::vector<std::int64_t>& ids,
                         std::vector<double>& records) override;
  void result_auxiliary(sqlite3_context* context, std::int64_t id, int column) override;
  std::int64_t count() override;

  std::int64_t next_id() override;
  void insert(std::int64_t id, std::span<const double> record,
              std::span<sqlite3_value*> auxiliaries) override;
  void update(std::int64_t id, std::int64_t new_id, std::span<const double> record,
              std::span<sqlite3_value*> auxiliaries) override;
  void erase(std::int64_t id) override;

  void rebuild(Interrupt& interrupt) override;
  void optimize(Interrupt& interrupt) override;
  std::vector<std::string> check(Interrupt& interrupt) override;

  void begin() override;
  void sync() override;
  void commit() override;
  void rollback() override;
  void savepoint(int level) override;
  void release(int level) override;
  void rollback_to(int level) override;
  void rename(const std::string& new_table) override;
  void drop() override;

 private:
  class OwnStatements;

  ShadowRows& rows();
  bool has_auxiliaries() const { return !declaration_.auxiliaries.empty(); }
  [[noreturn]] void damaged(const std::string& what) const;
  void require_sound(std::int64_t number, std::span<const std::byte> blob) const;

  // reading (store_read.cpp)
  std::optional<std::int64_t> leaf_of(std::int64_t id);
  void read_leaves(Interrupt& interrupt, const std::function<void(const LeafView&)>& use);
  const std::optional<std::int64_t>& largest_id();

  // writing (store_write.cpp)
  struct Place {
    PendingLeaf* leaf;
    int index;
  };
  void start_change(std::span<const double> record);
  PendingLeaf& fetch(std::int64_t number);
  PendingLeaf& leaf_with_room();
  Place place_of(std::int64_t id);
  void take_out(const Place& place, std::int64_t id) noexcept;
  void put_in(PendingLeaf& leaf, std::int64_t id, const double* record) noexcept;
  void flush();
  void forget() noexcept;

  // packing (store_pack.cpp)
  void pack(Interrupt& interrupt);
  void write_packed(const std::vector<std::int64_t>& ids, const std::vector<double>& records,
                    const std::vector<std::uint32_t>& order);

  sqlite3* db_;
  QualifiedName name_;
  Declaration declaration_;
  NodeFormat format_;
  std::unique_ptr<ShadowRows> rows_;

  bool in_transaction_;
  Pending pending_;
  PendingLeaf* newest_ = nullptr;  ///< among the pending leaves: where new objects go
  bool stamped_ = false;           ///< this transaction has written its stamp
  bool half_packed_ = false;       ///< packing failed half-way: only rolling back helps
  int own_statements_ = 0;         ///< our own writes under way: callbacks that come now are about them
  bool forget_after_ = false;      ///< … a rollback among them

  // Known within a write transaction only.
  bool largest_known_ = false;
  bool largest_exact_ = false;  ///< else no id is larger
  std::optional<std::int64_t> largest_;

  bool changed_ = false;  ///< since version() was last asked
  std::uint64_t changes_ = 0;
};

}  // namespace foresee
