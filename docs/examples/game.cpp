// A game loop without SQLite: which units will collide within ten seconds, kept up to date while they move.
//
// Build: c++ -std=c++20 game.cpp $(pkg-config --cflags --libs foresee-core)     (docs/hosts/c.md)
// Prints, per tick, the changes of the pairs that will collide:
//   t=0    + 1 and 2 collide at t=4
//   t=0    + 3 and 4 collide at t=9
//   t=1    ~ 1 and 2 collide at t=7
//   t=3    - 1 and 2 do not collide any more
//   t=3    - 3 and 4 do not collide any more
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "query/memory_table.h"
#include "query/watch/memory_watch.h"
#include "query/watch/pair_update.h"

namespace {

using namespace foresee;

class Units {
 public:
  /// From this time on, a unit is at (x, y) and moves along x.
  void set(std::int64_t id, double t, double x, double y, double vx) {
    table_->put(id, record_of(table_->layout(), {{"t", t}, {"x", x}, {"y", y}, {"vx", vx}, {"r", 0.5}}));
  }
  void remove(std::int64_t id) { table_->erase(id); }

  /// The end of a tick: brings the pairs up to date, and prints what has changed.
  void tick(double t) {
    state_.requested_clock = t;
    PairUpdate update({.a = table_}, state_, watch_, {.interrupt = never_});
    if (const auto after = update.run()) state_ = *after;
    table_->commit();
    for (const LoggedChange& change : watch_.take_log()) {
      std::printf("t=%-4g %c %d and %d", t, change.op, static_cast<int>(change.a),
                  static_cast<int>(change.b));
      if (change.op == '-')
        std::printf(" do not collide any more\n");
      else
        std::printf(" collide at t=%g\n", change.t);
    }
  }

 private:
  std::shared_ptr<MemoryTable> table_ = std::make_shared<MemoryTable>(
      "units", Layout{.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true});
  MemoryWatch watch_;
  WatchState state_{{.tbl = "units", .horizon = 10, .manual = true}};
  NeverInterrupt never_;
};

void run_ticks() {
  Units units;
  units.set(1, 0, 0, 0, 1);  // 1 and 2 approach each other: their edges are 8 apart
  units.set(2, 0, 9, 0, -1);
  units.set(3, 0, 0, 50, 1);  // 3 and 4 too
  units.set(4, 0, 19, 50, -1);
  units.set(5, 0, 0, 99, 1);  // 5 meets no other unit
  units.tick(0);

  units.set(2, 1, 8, 0, 0);  // 2 halts
  units.tick(1);

  units.tick(2);  // nothing has changed

  units.set(1, 3, 3, 0, -1);  // 1 turns round
  units.remove(4);
  units.tick(3);
}

}  // namespace

int main() {
  try {
    run_ticks();
  } catch (const foresee::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
  }
}
