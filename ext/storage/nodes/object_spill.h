// Where do the objects of a table wait that memory cannot hold, while it is loaded anew? In a temporary file,
// part by part.
//
//   ObjectSpill spill(db, name, record_size, 9, 16 << 20);
//   spill.add(partition, id, record);                    // all of them
//   spill.finish();
//   tree->bulk_load_partitions(spill, interrupt);        // reads one part after another
//
// The file is a database of its own, SQLite's for one connection and its life: where SQLite keeps temporary
// files (SQLITE_TMPDIR), in memory where the connection's PRAGMA temp_store says MEMORY, gone when it is
// closed or the process ends. Nothing of it is in the table's file or in its transaction.
//
// Errors: StoreError with SQLite's code, and a message that says which file it is about. Cost: as many bytes
// of disk as the objects have; of memory some MB, and lists of what was written.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "index/tpr_tree/tpr_tree.h"
#include "storage/rows/shadow_tables.h"
#include "storage/rows/statement.h"

namespace foresee {

class ObjectSpill final : public ObjectPartitions {
 public:
  /// `db`: the connection that says whether the file is in memory; `record_size` in doubles; `max_held`:
  /// bytes of objects that may wait for a write.
  ObjectSpill(sqlite3* db, const QualifiedName& name, std::size_t record_size, std::size_t partitions,
              std::size_t max_held);

  void add(std::size_t partition, std::int64_t id, const double* record);
  /// All are there.
  void finish();

  std::span<const std::size_t> counts() const override { return counts_; }
  void read(std::size_t partition, std::vector<std::int64_t>& ids, std::vector<double>& records) override;

 private:
  /// Objects of a part that are not written yet, and the rows that have the others.
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
  std::size_t record_size_, objects_a_row_;
  std::vector<Partition> partitions_;
  std::vector<std::size_t> counts_;
  std::int64_t rows_ = 0;
  std::unique_ptr<sqlite3, Close> file_;
  Statement write_, read_;
};

}  // namespace foresee
