// Queries of a table again and again while its objects report, or while transactions load it.
// A table of the same objects that was loaded at once is the rival. Both must give the same results.
#include <bit>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>

#include "measure.h"
#include "reports/modes.h"
#include "reports/table.h"

namespace foresee::bench {
namespace {

/// The number of rows, and a sum of their values that does not depend on their order.
struct Answer {
  std::uint64_t rows = 0, hash = 0;
  friend bool operator==(const Answer&, const Answer&) = default;

  void add(std::initializer_list<double> row) {
    ++rows;
    std::uint64_t mixed = 0;
    for (const double number : row)
      mixed = testing::Random(mixed ^ std::bit_cast<std::uint64_t>(number)).next();
    hash += mixed;
  }
};

/// The same places for every table.
class Places {
 public:
  explicit Places(const Workload& w) {
    for (std::size_t i = 0; i < w.count; ++i)
      for (int axis = 0; axis < 2; ++axis)
        side_[axis] = std::max(side_[axis], w.bodies().row(i)[w.bodies().at.x + axis]);
  }
  double next(int axis) { return random_.in(0, side_[axis]); }

 private:
  testing::Random random_{23};
  double side_[2] = {0, 0};
};

struct Question {
  std::string what;
  std::function<void(Table&, Answer&)> run;
};

/// S has an object on every 14 units of area, and during the horizon of 3 they come from about 4.4 units
/// away. `stored` of the scene's objects are in the table, and its ids are the first.
double window_side(const Workload& w, std::size_t stored, int objects) {
  return std::sqrt(14.0 * objects * static_cast<double>(w.count) / static_cast<double>(stored)) - 4.4;
}

Question window(const Workload& w, std::size_t stored, int objects, int questions) {
  return {"windows of about " + std::to_string(objects),
          [&w, stored, objects, questions](Table& table, Answer& answer) {
            Statement find(table.db(), "SELECT id, t FROM predictive_window(3, 'ships', ?1, ?2, ?3, ?4)");
            Places places(w);
            for (int i = 0; i < questions; ++i) {
              const double x = places.next(0), y = places.next(1), side = window_side(w, stored, objects);
              find.bind(1, x), find.bind(2, x + side), find.bind(3, y), find.bind(4, y + side);
              while (find.step()) answer.add({find.number(0), find.number(1)});
            }
          }};
}

Question nearest(const Workload& w, int questions) {
  return {"nearest 10", [&w, questions](Table& table, Answer& answer) {
            Statement find(table.db(), "SELECT id, distance FROM predictive_nearest(3, 'ships', 10, ?1, ?2)");
            Places places(w);
            for (int i = 0; i < questions; ++i) {
              find.bind(1, places.next(0)), find.bind(2, places.next(1));
              while (find.step()) answer.add({find.number(0), find.number(1)});
            }
          }};
}

Question partners(std::size_t stored, int questions) {
  return {"join, a = ?", [stored, questions](Table& table, Answer& answer) {
            Statement find(table.db(), "SELECT b, t FROM predictive_join(3, 'ships') WHERE a = ?");
            testing::Random random(29);
            for (int i = 0; i < questions; ++i) {
              find.bind(1, static_cast<std::int64_t>(1 + random.below(stored)));
              while (find.step()) answer.add({find.number(0), find.number(1)});
            }
          }};
}

Question join(const char* what, const char* method) {
  return {what, [method](Table& table, Answer& answer) {
            Statement find(table.db(), "SELECT a, b, t FROM predictive_join(3, 'ships') WHERE method = '" +
                                           std::string(method) + "'");
            while (find.step()) answer.add({find.number(0), find.number(1), find.number(2)});
          }};
}

std::vector<Question> all_questions(const Workload& w, std::size_t stored) {
  return {join("join", "auto"),         join("join by the tree", "tree"), window(w, stored, 10, 3000),
          window(w, stored, 100, 1000), window(w, stored, 1000, 200),     nearest(w, 1000),
          partners(stored, 3000)};
}

/// Fresh against used, each repetition one after the other; the first is a warm-up.
Comparison compare(const Question& question, Table& used, Table& fresh, int repetitions) {
  Comparison times;
  for (int i = 0; i <= repetitions; ++i) {
    Answer of_used, of_fresh;
    const double seconds = seconds_of([&] { question.run(used, of_used); });
    const double as_fresh = seconds_of([&] { question.run(fresh, of_fresh); });
    if (of_used != of_fresh) throw Error(question.what + ": the used table answers otherwise");
    if (i > 0) times.add(seconds, as_fresh);
  }
  return times;
}

double bytes_of(Table& table) {
  Statement size(table.db(), "SELECT page_count * page_size FROM pragma_page_count, pragma_page_size");
  size.step();
  const double bytes = size.number(0);
  size.step();
  return bytes;
}

/// write() of all but the first `begin` of the first `end` rows, in one transaction. Returns the seconds that it took.
double transaction_of(Table& table, const Writes& writes, std::size_t begin, std::size_t end,
                      void (Table::*write)(const Writes&, std::size_t)) {
  return seconds_of([&] {
    table.db().run("BEGIN");
    for (std::size_t i = begin; i < end; ++i) (table.*write)(writes, i);
    table.db().run("COMMIT");
  });
}

/// The speed of every query, as a multiple of that in a fresh table, at several times.
class Ratios {
 public:
  explicit Ratios(int repetitions) : repetitions_(repetitions) {}

  /// `stored` of the scene's objects are in both tables.
  void add(const Workload& w, std::size_t stored, Table& used, Table& fresh) {
    bytes_.push_back(bytes_of(used) / bytes_of(fresh));
    const std::vector<Question> questions = all_questions(w, stored);
    names_.resize(questions.size()), ratios_.resize(questions.size());
    for (std::size_t q = 0; q < questions.size(); ++q) {
      names_[q] = questions[q].what;
      ratios_[q].push_back(median(compare(questions[q], used, fresh, repetitions_).ratios));
    }
  }

  void print(const std::string& title) const {
    std::printf("%s (marks: median 0.85x, slowest 0.80x); %.2f times the bytes (mark: 1.3)\n", title.c_str(),
                median(bytes_));
    for (std::size_t q = 0; q < ratios_.size(); ++q) {
      const auto slowest = std::min_element(ratios_[q].begin(), ratios_[q].end());
      std::printf("  %-24s median %5.2fx   slowest %5.2fx, after %td\n", names_[q].c_str(),
                  median(ratios_[q]), *slowest, slowest - ratios_[q].begin() + 1);
    }
    std::fflush(stdout);
  }

 private:
  int repetitions_;
  std::vector<std::string> names_;
  std::vector<double> bytes_;
  std::vector<std::vector<double>> ratios_;  ///< by query
};

/// Every query each time that all objects have reported once, in random order.
void compare_while_it_is_reported(const std::string& name, std::size_t transactions, int repetitions) {
  constexpr int rounds = 10;
  Feed feed(make_workload(name));
  const Workload& w = feed.objects();
  Table reported(Table::foresee, w, Medium::memory, "");
  reported.insert_all(writes_of(w));
  Ratios ratios(repetitions);
  std::vector<double> seconds;
  for (int round = 0; round < rounds; ++round) {
    const Writes reports = writes_of(feed.reports_of_all(), w);
    for (std::size_t k = 0; k < transactions; ++k)
      seconds.push_back(transaction_of(reported, reports, k * w.count / transactions,
                                       (k + 1) * w.count / transactions, &Table::update));
    Table fresh(Table::foresee, w, Medium::memory, "");
    fresh.insert_all(writes_of(w));
    if (!same_rows(reported, fresh)) throw Error(name + ": other rows than were reported");
    ratios.add(w, w.count, reported, fresh);
  }
  ratios.print(name + ", after each of " + std::to_string(rounds) + " reports of every object, " +
               std::to_string(transactions) + " transactions each");
  const double all = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  std::printf("  transactions             %.2f us per report, median %.2f ms, longest %.2f ms\n",
              1e6 * all / static_cast<double>(rounds * w.count), 1e3 * median(seconds),
              1e3 * *std::max_element(seconds.begin(), seconds.end()));
  std::fflush(stdout);
}

/// Every query twenty times while transactions load a table.
void compare_while_it_grows(const Workload& w, std::size_t transactions, int repetitions) {
  constexpr std::size_t times = 20;
  Table grown(Table::foresee, w, Medium::memory, "");
  const Writes writes = writes_of(w);
  Ratios ratios(repetitions);
  for (std::size_t k = 0; k < transactions; ++k) {
    const std::size_t stored = (k + 1) * w.count / transactions;
    transaction_of(grown, writes, k * w.count / transactions, stored, &Table::insert);
    if ((k + 1) % (transactions / times) != 0) continue;
    Table fresh(Table::foresee, w, Medium::memory, "");
    transaction_of(fresh, writes, 0, stored, &Table::insert);
    ratios.add(w, stored, grown, fresh);
  }
  ratios.print(w.name + ", each time that a twentieth is loaded, of " + std::to_string(transactions) +
               " transactions");
}

}  // namespace

void measure_after(const Options& options) {
  const bool quick = options.has("--quick");
  const int repetitions = quick ? 1 : 3;
  const std::vector<std::string> few = {"S-100000"}, all = {"S-100000", "S-1000000"};
  for (const std::string& name : options.names(quick ? few : all)) {
    for (const std::size_t transactions : {10, 100, 1000})
      compare_while_it_is_reported(name, transactions, repetitions);
    for (const std::size_t transactions : {20, 100})
      compare_while_it_grows(make_workload(name), transactions, repetitions);
  }
}

}  // namespace foresee::bench
