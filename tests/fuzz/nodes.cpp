// Hostile nodes with valid checksums: some bytes of nodes, of the map and of the table's metadata are
// changed, checksums are recomputed, and the table is queried and written. The result must be an error or any
// rows; a crash, a hang or a leak is a failure.
#include <array>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include "format/crc32c.h"
#include "format/node_format.h"
#include "program.h"

namespace foresee::testing {
namespace {

/// A small table of three levels, one for each declaration, made once.
const std::vector<unsigned char>& sound_database(std::size_t which) {
  static std::vector<unsigned char> made[std::size(fuzz_tables)];
  std::vector<unsigned char>& bytes = made[which];
  if (!bytes.empty()) return bytes;
  Connection db;
  const FuzzTable& table = fuzz_tables[which];
  db.must("PRAGMA page_size = 512");
  db.must(std::string("CREATE VIRTUAL TABLE ships USING moving_objects(id, ") + table.columns + ")");
  for (int id = 1; id <= 60; ++id) {
    std::string values = std::to_string(id);
    for (int i = 0; i < table.numbers; ++i)
      values += ", " + std::to_string(1 + (id * (7 + i)) % (11 + 2 * i));
    if (!table.shapes.empty()) values += std::string(", ") + table.shapes[static_cast<std::size_t>(id % 3)];
    db.run("INSERT INTO ships VALUES(" + values + ")");  // until < t is refused
  }
  sqlite3_int64 size = 0;
  unsigned char* image = sqlite3_serialize(db.handle(), "main", &size, 0);
  bytes.assign(image, image + size);
  sqlite3_free(image);
  return bytes;
}

void load(Connection& db, const std::vector<unsigned char>& image) {
  auto* copy = static_cast<unsigned char*>(sqlite3_malloc64(image.size()));
  std::memcpy(copy, image.data(), image.size());
  const auto size = static_cast<sqlite3_int64>(image.size());
  if (sqlite3_deserialize(db.handle(), "main", copy, size, size,
                          SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_RESIZEABLE) != SQLITE_OK)
    fail("deserialize");
}

/// Overwrites up to 8 bytes of a blob, if there is one; the critical places are the most frequent.
/// seal(blob) recomputes the checksum.
template <class Seal>
void change_blob(Connection& db, FuzzBytes& bytes, const char* table, std::int64_t number, Seal seal) {
  sqlite3_blob* blob = nullptr;
  if (sqlite3_blob_open(db.handle(), "main", table, "data", number, 1, &blob) != SQLITE_OK) {
    sqlite3_blob_close(blob);
    return;
  }
  std::vector<std::byte> content(static_cast<std::size_t>(sqlite3_blob_bytes(blob)));
  sqlite3_blob_read(blob, content.data(), static_cast<int>(content.size()), 0);
  const std::size_t last = bytes.flag() ? 40 : content.size() - 1;
  const std::size_t at = bytes.in_range<std::size_t>(0, std::min(last, content.size() - 1));
  if (bytes.flag()) {
    const double number_there = fuzz_number(bytes);
    std::memcpy(content.data() + at, &number_there, std::min(sizeof number_there, content.size() - at));
  } else {
    content[at] = static_cast<std::byte>(bytes.any<std::uint8_t>());
  }
  seal(content);
  sqlite3_blob_write(blob, content.data(), static_cast<int>(content.size()), 0);
  sqlite3_blob_close(blob);
}

void change_node(Connection& db, FuzzBytes& bytes) {
  const auto number = bytes.in_range<std::int64_t>(1, 24);
  change_blob(db, bytes, "ships_node", number, [number](auto& node) { seal_node(node, number); });
}

/// The hash agrees, as after a forgery by a person who knows the format.
void change_shape(Connection& db, FuzzBytes& bytes) {
  const auto number = bytes.in_range<std::int64_t>(1, 3);
  std::uint32_t checksum = 0;
  change_blob(db, bytes, "ships_shape", number, [&checksum](std::vector<std::byte>& shape) {
    checksum = crc32c(shape.data(), shape.size() - sizeof checksum);
    std::memcpy(shape.data() + shape.size() - sizeof checksum, &checksum, sizeof checksum);
  });
  db.run("UPDATE ships_shape SET hash = " + std::to_string(checksum) +
         " WHERE number = " + std::to_string(number));
}

void change_tables(Connection& db, FuzzBytes& bytes) {
  constexpr std::array numbers{"horizon", "node_size", "objects"};
  const std::string one = std::to_string(bytes.in_range(-1, 30));
  switch (bytes.in_range(0, 6)) {
    case 0:
      db.run("INSERT OR REPLACE INTO ships_map VALUES(" + fuzz_id(bytes) + ", " + one + ")");
      return;
    case 1:
      db.run("DELETE FROM ships_map WHERE id = " + fuzz_id(bytes));
      return;
    case 6: {
      const std::string place = std::to_string(bytes.in_range(1, 40));
      db.run("UPDATE ships_map SET leaf = CAST(substr(leaf, 1, " + place + ") || char(" + one +
             ") || substr(leaf, " + place + " + 2) AS BLOB)");
      return;
    }
    case 2:
      db.run("UPDATE ships_meta SET value = " + one + " WHERE key = 'root'");
      return;
    case 3:
      db.run(in_order({"UPDATE ships_meta SET value = ", literal(fuzz_number(bytes)), " WHERE key = '",
                       numbers[bytes.in_range<std::size_t>(0, 2)], "'"}));
      return;
    case 4:
      db.run("DELETE FROM ships_node WHERE nodeno = " + one);
      return;
    default:
      db.run("UPDATE ships_node SET nodeno = nodeno + 1 WHERE nodeno = " + one);
      return;
  }
}

void query_and_write(Connection& db, FuzzBytes& bytes, const FuzzTable& table) {
  const std::string question = fuzz_question(bytes, table);
  for (const char* method : fuzz_methods) db.rows(with_method(question, method));
  db.rows("SELECT * FROM ships");
  db.rows("SELECT * FROM ships WHERE id = " + fuzz_id(bytes));
  db.rows("SELECT * FROM predictive_position(" + literal(fuzz_number(bytes)) + ")");
  db.rows("SELECT * FROM predictive_sweep(" + literal(fuzz_number(bytes)) +
          ") WHERE x1 >= " + literal(fuzz_number(bytes)));
  db.run("INSERT INTO ships(ships) VALUES('integrity-check')");
  for (int i = 0; i < 6; ++i) {
    db.run(in_order(
        {"INSERT OR REPLACE INTO ships VALUES(", fuzz_id(bytes), ", ", fuzz_values(bytes, table), ")"}));
    db.run("UPDATE ships SET x = x + 1 WHERE id = " + fuzz_id(bytes));
    db.run("DELETE FROM ships WHERE id = " + fuzz_id(bytes));
  }
  db.run(bytes.flag() ? "INSERT INTO ships(ships) VALUES('rebuild')"
                      : "INSERT INTO ships(ships) VALUES('optimize')");
  db.rows(with_method(question, "auto"));
  db.run("DROP TABLE ships");
}

void run(FuzzBytes& bytes) {
  const auto which = bytes.in_range<std::size_t>(0, std::size(fuzz_tables) - 1);
  Connection db;
  load(db, sound_database(which));
  for (int changes = bytes.in_range(1, 4); changes > 0; --changes)
    if (!fuzz_tables[which].shapes.empty() && bytes.flag())
      change_shape(db, bytes);
    else
      bytes.in_range(0, 3) > 0 ? change_node(db, bytes) : change_tables(db, bytes);
  query_and_write(db, bytes, fuzz_tables[which]);
}

}  // namespace
}  // namespace foresee::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  foresee::testing::FuzzBytes bytes({data, size});
  foresee::testing::run(bytes);
  return 0;
}
