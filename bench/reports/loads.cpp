// Loads of many rows: how the time and the bytes of a row, and the memory of the process, grow with the rows
// and with the transactions that bring them.
#include <cstdio>
#include <numeric>

#include "files.h"
#include "measure.h"
#include "reports/modes.h"
#include "reports/table.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

using Order = std::vector<std::uint32_t>;

Order ascending(std::size_t count) {
  Order order(count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

Order shuffled(std::size_t count) {
  Order order = ascending(count);
  testing::Random random(17);
  for (std::size_t left = count; left > 1; --left) std::swap(order[left - 1], order[random.below(left)]);
  return order;
}

double load(Table& table, const Workload& w, const Order& order, std::size_t transactions) {
  const Bodies bodies = w.bodies();
  return seconds_of([&] {
    for (std::size_t k = 0; k < transactions; ++k) {
      table.db().run("BEGIN");
      for (std::size_t i = k * w.count / transactions; i < (k + 1) * w.count / transactions; ++i)
        table.insert(order[i] + 1, bodies.row(order[i]));
      table.db().run("COMMIT");
    }
  });
}

/// In children, so that the memory is that of the work alone. The process holds the rows, but neither they
/// nor an empty table count.
class Loader {
 public:
  Loader(Table::Kind kind, const Workload& w, Medium medium) : kind_(kind), w_(w), medium_(medium) {
    const TwoFiles files;
    idle_ = peak_of([&] { Table(kind_, w_, medium_, files.ours); });
  }

  /// Leaves the file there.
  Cost load(const Order& order, std::size_t transactions, const std::string& path) const {
    return beyond_idle(cost_in_child([&] {
      Table table(kind_, w_, medium_, path);
      return bench::load(table, w_, order, transactions);
    }));
  }

  Cost run(const std::string& sql, const std::string& path) const {
    return beyond_idle(cost_in_child([&] {
      Database db(path);
      register_foresee(db);
      return seconds_of([&] { db.run(sql); });
    }));
  }

 private:
  Cost beyond_idle(const Cost& cost) const {
    return {cost.seconds, cost.peak_bytes - idle_, cost.written_bytes};
  }

  Table::Kind kind_;
  const Workload& w_;
  Medium medium_;
  double idle_;
};

/// Microseconds per row of the first load in one transaction, with which all others are compared.
double print(const std::string& what, const Workload& w, const Cost& cost, double bytes, double first) {
  const double n = static_cast<double>(w.count), a_row = cost.seconds / n * 1e6;
  std::printf("%-48s %7.2f us per row", (what + ", " + w.name).c_str(), a_row);
  if (first > 0) std::printf(" %6.2f times the first", a_row / first);
  std::printf(" %7.1f bytes per row, %7.1f written   peak %7.1f MB, of which a row %6.1f B\n", bytes / n,
              cost.written_bytes / n, cost.peak_bytes / 1e6, cost.peak_bytes / n);
  std::fflush(stdout);
  return a_row;
}

/// Ours beside an ordinary table: with shuffled ids that too keeps an order in which rows do not come.
void print_ratio(const Cost& ours, const Cost& ordinary) {
  std::printf("  an ordinary table: %.2fx of our time, ours writes %.2f of its bytes\n",
              ordinary.seconds / ours.seconds, ours.written_bytes / ordinary.written_bytes);
  std::fflush(stdout);
}

/// Loads in one transaction and in many, and the commands that rewrite the whole table.
double measure(const Workload& w, Medium medium, double first) {
  for (const bool shuffles : {false, true}) {
    const Order order = shuffles ? shuffled(w.count) : ascending(w.count);
    const Loader loader(Table::foresee, w, medium), ordinary(Table::ordinary, w, medium);
    for (const std::size_t transactions : {1, 20, 100}) {
      const TwoFiles files;
      const auto print_file = [&](const std::string& what, const Cost& cost) {
        return print(what, w, cost, static_cast<double>(std::filesystem::file_size(files.ours)), first);
      };
      const std::string how = std::string(name_of(medium)) + ", load in " + std::to_string(transactions) +
                              (shuffles ? ", shuffled" : "");
      const Cost ours = loader.load(order, transactions, files.ours);
      const double a_row = print_file(how, ours);
      if (first == 0) first = a_row;
      print_ratio(ours, ordinary.load(order, transactions, files.theirs));
      if (!shuffles || transactions != 20) continue;
      const std::string all = "UPDATE ships SET x = x + 1, y = y - 1";
      const Cost update = loader.run(all, files.ours);
      print_file("  then UPDATE of all", update);
      print_ratio(update, ordinary.run(all, files.theirs));
      print_file("  then 'optimize'", loader.run("INSERT INTO ships(ships) VALUES('optimize')", files.ours));
      print_file("  then 'rebuild'", loader.run("INSERT INTO ships(ships) VALUES('rebuild')", files.ours));
      const std::string third = "BEGIN; DELETE FROM ships WHERE id % 3 = 0; COMMIT";
      const Cost deletion = loader.run(third, files.ours);
      print_file("  then DELETE of a third", deletion);
      print_ratio(deletion, ordinary.run(third, files.theirs));
    }
  }
  return first;
}

/// In one transaction, ids ascending.
void compare_with_rtree(const Workload& w, Medium medium, int repetitions) {
  const Writes writes = writes_of(w);
  Comparison times;
  for (int i = 0; i < repetitions; ++i) {
    const TwoFiles files;
    Table ours(Table::foresee, w, medium, files.ours), rival(Table::rtree, w, medium, files.theirs);
    const double our_seconds = seconds_of([&] { ours.insert_all(writes); });
    times.add(our_seconds, seconds_of([&] { rival.insert_all(writes); }));
    if (!same_rows(ours, rival)) throw Error(w.name + ": the two tables hold other rows after a load");
  }
  const double a_row = 1e6 / static_cast<double>(w.count);
  std::printf("load in one, %-10s %-14s foresee %6.2f   R*Tree %6.2f us per row   %6.2fx (mark: 8x)\n",
              w.name.c_str(), name_of(medium), median(times.ours) * a_row, median(times.rivals) * a_row,
              median(times.ratios));
  std::fflush(stdout);
}

}  // namespace

void measure_loads(const Options& options) {
  const bool quick = options.has("--quick");
  const std::vector<std::string> names = options.names({quick ? "S-100000" : "S-500000"});
  double first = 0;
  for (const std::string& name : names)
    for (const Medium medium : mediums_of(options, {Medium::journal}))
      if (medium != Medium::memory) first = measure(make_workload(name), medium, first);
  for (const std::string& name : names)
    for (const Medium medium : mediums_of(options, {Medium::memory, Medium::journal}))
      if (make_workload(name).count <= 1000000)
        compare_with_rtree(make_workload(name), medium, quick ? 1 : 3);
}

}  // namespace foresee::bench
