// Random statements against a model: a moving_objects table and an ordinary table with the same columns go
// through the same transactions, savepoints, writes and commands. Their contents always agree, every method
// gives the same rows, and the integrity check finds nothing.
#include "program.h"

namespace foresee::testing {
namespace {

class Twins {
 public:
  Twins(FuzzBytes& bytes)
      : bytes_(bytes), table_(fuzz_tables[bytes.in_range<std::size_t>(0, std::size(fuzz_tables) - 1)]) {
    db_.must("PRAGMA page_size = 512");  // few objects make a deep tree
    db_.must(std::string("CREATE VIRTUAL TABLE ships USING moving_objects(id, ") + table_.columns + ")");
    db_.must(std::string("CREATE TABLE model(id INTEGER PRIMARY KEY, ") + table_.columns + ")");
  }

  void run() {
    for (int steps = 0; steps < 60 && bytes_.left() > 0; ++steps) step();
    while (db_.in_transaction()) db_.must("COMMIT");
    compare();
    db_.must("INSERT INTO ships(ships) VALUES('integrity-check')");
  }

 private:
  void step() {
    switch (bytes_.in_range(0, 15)) {
      case 0:
        return db_.must(db_.in_transaction() ? "COMMIT" : "BEGIN"), savepoints_ = 0, void();
      case 1:
        if (db_.in_transaction()) db_.must("ROLLBACK"), savepoints_ = 0;
        return;
      case 2:
        return db_.must("SAVEPOINT s" + std::to_string(savepoints_++));
      case 3:
        return roll_back_to_savepoint();
      case 4:
        if (savepoints_ > 0)
          savepoints_ = which_savepoint(), db_.must("RELEASE s" + std::to_string(savepoints_));
        return;
      case 5:
        return both("DELETE FROM TABLE WHERE id = " + fuzz_id(bytes_));
      case 6:
        return both("DELETE FROM TABLE WHERE id % 5 = " + std::to_string(bytes_.in_range(0, 4)));
      case 7:
        return both(in_order({"UPDATE TABLE SET id = ", fuzz_id(bytes_), " WHERE id = ", fuzz_id(bytes_)}));
      case 8:
        return both(in_order({"UPDATE TABLE SET (", table_.columns, ") = (", fuzz_values(bytes_, table_),
                              ") WHERE id = ", fuzz_id(bytes_)}));
      case 9:
        return both("UPDATE TABLE SET x = x + " + literal(fuzz_number(bytes_)) + " WHERE id % 3 = 0");
      case 10:
        return both(in_order({"INSERT OR REPLACE INTO TABLE VALUES(", fuzz_id(bytes_), ", ",
                              fuzz_values(bytes_, table_), ")"}));
      case 11:
        return insert_many();
      case 12:
        return db_.must(bytes_.flag() ? "INSERT INTO ships(ships) VALUES('rebuild')"
                                      : "INSERT INTO ships(ships) VALUES('optimize')");
      case 13:
        return compare();
      case 14:
        return query();
      default:
        return both(
            in_order({"INSERT INTO TABLE VALUES(", fuzz_id(bytes_), ", ", fuzz_values(bytes_, table_), ")"}));
    }
  }

  void roll_back_to_savepoint() {
    if (savepoints_ == 0) return;
    const int kept = which_savepoint();
    db_.must("ROLLBACK TO s" + std::to_string(kept));
    savepoints_ = kept + 1;
  }

  int which_savepoint() { return bytes_.in_range(0, savepoints_ - 1); }

  /// A statement that moving_objects refuses changes nothing there, so nothing in the model either.
  void both(const std::string& sql) {
    const auto in = [&](const std::string& table) {
      return std::string(sql).replace(sql.find("TABLE"), 5, table);
    };
    if (db_.run(in("ships")) == SQLITE_OK) db_.must(in("model"));
  }

  /// A statement of many rows: a lattice that grows from one object.
  void insert_many() {
    const int count = bytes_.in_range(1, 24), from = bytes_.in_range(-4, 60);
    const std::string values = fuzz_values(bytes_, table_);
    const std::size_t comma = values.find(',');
    std::string rows;
    for (int i = 0; i < count; ++i) {
      const std::string step = " + " + std::to_string(i);
      rows += (i ? "), (" : "(") + std::to_string(from + i) + ", " +
              (comma == std::string::npos ? values + step
                                          : values.substr(0, comma) + step + values.substr(comma));
    }
    both("INSERT INTO TABLE VALUES " + rows + ")");
  }

  void compare() {
    const std::string found = db_.rows("SELECT * FROM ships ORDER BY id");
    const std::string right = db_.rows("SELECT * FROM model ORDER BY id");
    if (found != right) fail("contents differ:\n" + found + "model:\n" + right);
    const std::string id = fuzz_id(bytes_);
    if (db_.rows("SELECT * FROM ships WHERE id = " + id) != db_.rows("SELECT * FROM model WHERE id = " + id))
      fail("object " + id + " differs");
  }

  void query() {
    const std::string question = fuzz_question(bytes_, table_);
    const std::string right = db_.rows(with_method(question, "scan"));
    for (const char* method : fuzz_methods) {
      if (std::string(method) == "grid" && question.find("join") == std::string::npos) continue;
      if (const std::string found = db_.rows(with_method(question, method)); found != right)
        fail(question + ": " + method + "\n" + found + "scan\n" + right);
    }
  }

  FuzzBytes& bytes_;
  FuzzTable table_;
  Connection db_;
  int savepoints_ = 0;
};

}  // namespace
}  // namespace foresee::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  foresee::testing::FuzzBytes bytes({data, size});
  foresee::testing::Twins(bytes).run();
  return 0;
}
