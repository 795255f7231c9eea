#include "storage/nodes/object_spill.h"

#include <algorithm>
#include <cstring>
#include <new>

#include "database/sqlite_api.h"

namespace foresee {
namespace {

constexpr std::size_t largest_row = 256 << 10;  // bytes; larger rows are not cheaper to write

/// False, hence a file, if an authorizer forbids the PRAGMA.
bool keeps_in_memory(sqlite3* db) try {
  constexpr std::int64_t memory = 2;
  Statement pragma(db, "PRAGMA temp_store");
  Statement::Run run(pragma);
  return run.step() && run.integer(0) == memory;
} catch (const StoreError& error) {
  if (error.primary() != SQLITE_AUTH) throw;
  return false;
}

template <class T>
void append(std::span<const std::byte> bytes, std::vector<T>& values) {
  const std::size_t before = values.size();
  values.resize(before + bytes.size() / sizeof(T));
  if (!bytes.empty()) std::memcpy(values.data() + before, bytes.data(), bytes.size() / sizeof(T) * sizeof(T));
}

}  // namespace

ObjectSpill::ObjectSpill(sqlite3* db, const QualifiedName& name, std::size_t record_size,
                         std::size_t partitions, std::size_t max_held)
    : table_(name.table),
      record_size_(record_size),
      objects_per_row_(std::max<std::size_t>(
          1, std::min(largest_row, max_held / partitions) / ((record_size + 1) * sizeof(double)))),
      partitions_(partitions),
      counts_(partitions) {
  const char* where = keeps_in_memory(db) ? ":memory:" : "";
  in_file([&] {
    sqlite3* file = nullptr;
    const int code = sqlite3_open(where, &file);
    file_.reset(file);
    if (!file) throw std::bad_alloc();
    if (code != SQLITE_OK) throw_sqlite_error(file, code);
    execute(file,
            "PRAGMA page_size = 32768; PRAGMA journal_mode = OFF; BEGIN;"
            "CREATE TABLE objects(number INTEGER PRIMARY KEY, ids BLOB, records BLOB)");
    write_ = Statement(file, "INSERT INTO objects VALUES(?1, ?2, ?3)");
    read_ = Statement(file, "SELECT ids, records FROM objects WHERE number = ?1");
  });
}

template <class Body>
void ObjectSpill::in_file(Body body) {
  try {
    body();
  } catch (const StoreError& error) {
    throw StoreError(
        error.code,
        table_ + ": a temporary file for a reload (in the directory of SQLITE_TMPDIR): " + error.what());
  }
}

void ObjectSpill::add(std::size_t partition_number, std::int64_t id, const double* record) {
  Partition& partition = partitions_[partition_number];
  partition.ids.push_back(id);
  partition.records.insert(partition.records.end(), record, record + record_size_);
  ++counts_[partition_number];
  if (partition.ids.size() >= objects_per_row_) write(partition);
}

void ObjectSpill::write(Partition& partition) {
  if (partition.ids.empty()) return;
  in_file([&] {
    Statement::Run run(write_);
    run.bind(1, ++rows_);
    run.bind(2, std::as_bytes(std::span(partition.ids)));
    run.bind(3, std::as_bytes(std::span(partition.records)));
    run.step();
  });
  partition.rows.push_back(rows_);
  partition.ids.clear();
  partition.records.clear();
}

void ObjectSpill::finish() {
  for (Partition& partition : partitions_) {
    write(partition);
    partition.ids = {};
    partition.records = {};
  }
}

void ObjectSpill::read(std::size_t partition, std::vector<std::int64_t>& ids, std::vector<double>& records) {
  ids.clear();
  records.clear();
  ids.reserve(counts_[partition]);
  records.reserve(counts_[partition] * record_size_);
  in_file([&] {
    for (const std::int64_t row : partitions_[partition].rows) {
      Statement::Run run(read_);
      run.bind(1, row);
      if (!run.step()) continue;
      append(run.blob(0), ids);
      append(run.blob(1), records);
    }
  });
  if (ids.size() != counts_[partition] || records.size() != ids.size() * record_size_)
    throw StoreError(SQLITE_IOERR,
                     table_ + ": a temporary file returns other bytes than were written; load again");
}

}  // namespace foresee
