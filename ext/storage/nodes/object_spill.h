// Temporary file for the objects of a table that is reloaded and does not fit into memory, divided into
// partitions.
//
//   ObjectSpill spill(db, name, record_size, 9, 16 << 20);
//   spill.add(partition, id, record);                    // for all objects
//   spill.finish();
//   tree->bulk_load_partitions(spill, interrupt);        // reads one partition at a time
//
// The file is a temporary database of SQLite with its own connection. It is where SQLite keeps temporary
// files (SQLITE_TMPDIR), or in memory if PRAGMA temp_store of the connection is MEMORY. It disappears when it
// is closed or the process ends. Neither the table's file nor its transaction contains any of it.
//
// Errors: StoreError with SQLite's code, and a message that names the file. Cost: as many bytes of disk as
// the objects have; some MB of memory, and a list of the rows written.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "database/shadow_tables.h"
#include "database/statement.h"
#include "index/tpr_tree/tpr_tree.h"

namespace foresee {

class ObjectSpill final : public ObjectPartitions {
 public:
  /// `db`: the connection whose temp_store decides whether the file is in memory; `record_size` in doubles;
  /// `max_held`: maximum bytes of objects that wait for a write.
  ObjectSpill(sqlite3* db, const QualifiedName& name, std::size_t record_size, std::size_t partitions,
              std::size_t max_held);

  void add(std::size_t partition, std::int64_t id, const double* record);
  /// Call it after the last add().
  void finish();

  std::span<const std::size_t> counts() const override { return counts_; }
  void read(std::size_t partition, std::vector<std::int64_t>& ids, std::vector<double>& records) override;

 private:
  /// Objects of a partition that are not written yet, and the rows of the others.
  struct Partition {
    std::vector<std::int64_t> ids;
    std::vector<double> records;
    std::vector<std::int64_t> rows;
  };
  struct Close {
    void operator()(sqlite3* db) const { sqlite3_close(db); }
  };

  template <class Body>
  void in_file(Body body);
  void write(Partition& partition);

  std::string table_;
  std::size_t record_size_, objects_per_row_;
  std::vector<Partition> partitions_;
  std::vector<std::size_t> counts_;
  std::int64_t rows_ = 0;
  std::unique_ptr<sqlite3, Close> file_;
  Statement write_, read_;
};

}  // namespace foresee
