#include "compare/contestant.h"
#include "sql_ours.h"
#include "sql_rival.h"

namespace foresee::bench {
namespace {

/// A database in memory, and a query of rows (a, b, t) whose ids count from 1.
class SqlContestant : public Contestant {
 public:
  using Contestant::Contestant;
  void begin() override { db_.run("BEGIN"); }
  void commit() override { db_.run("COMMIT"); }

 protected:
  Answer pairs_of(const std::string& sql) {
    Answer answer;
    for (Statement rows(db_, sql); rows.step();) {
      const auto row = [&](int column) { return static_cast<std::uint32_t>(rows.integer(column) - 1); };
      answer.add({row(0), row(1)}, rows.number(2));
    }
    return answer;
  }

  static std::string update_of(const std::string& table) {
    return "UPDATE " + table + " SET x = ?, y = ?, vx = ?, vy = ? WHERE id = ?";
  }
  static void store(Statement& update, std::uint32_t row, const Report& report) {
    const double numbers[] = {report.x, report.y, report.vx, report.vy};
    for (int k = 0; k < 4; ++k) update.bind(1 + k, numbers[k]);
    update.bind(5, static_cast<std::int64_t>(row) + 1);
    update.step();
  }

  Database db_{":memory:"};
};

class ForeseeTable final : public SqlContestant {
 public:
  explicit ForeseeTable(Workload& objects) : SqlContestant(objects) { create_ours(db_, objects); }

  void build() override { load_ours(db_, objects_); }
  void report(std::uint32_t row, const Report& report) override {
    write(row, report);
    if (!update_) update_ = std::make_unique<Statement>(db_, update_of("ships"));
    store(*update_, row, report);
  }
  Answer join() override {
    return pairs_of("SELECT a, b, t FROM predictive_join(" + std::to_string(objects_.h) + ")");
  }

 private:
  std::unique_ptr<Statement> update_;
};

/// A base table, SQLite's R*Tree of swept boxes, and foresee's contact as an SQL function.
class RtreeTable final : public SqlContestant {
 public:
  explicit RtreeTable(Workload& objects) : SqlContestant(objects), rival_(db_, objects) {}

  void build() override { rival_.load(); }
  void report(std::uint32_t row, const Report& report) override {
    if (!object_) {
      object_ = std::make_unique<Statement>(db_, update_of("base"));
      box_ = std::make_unique<Statement>(db_, Rival::move_box_sql);
    }
    write(row, report);
    store(*object_, row, report);
    rival_.store_box(*box_, row, swept_box<2>(objects_.bodies(), row, {0, objects_.h}, Vec<2>::zero()));
  }
  Answer join() override { return pairs_of(rival_.join_sql()); }

 private:
  Rival rival_;
  std::unique_ptr<Statement> object_, box_;
};

template <class Kind>
std::unique_ptr<Contestant> make(Workload& objects) {
  return std::make_unique<Kind>(objects);
}

}  // namespace

std::vector<ContestantKind> contestants_in_sql() {
  return {{.name = "foresee in SQL", .keeps_index = true, .make = make<ForeseeTable>},
          {.name = "R*Tree in SQL", .keeps_index = true, .make = make<RtreeTable>}};
}

}  // namespace foresee::bench
