// Run time of stiff and extreme scenes through SQL: one row per scene, as CSV.
//
//   bench_extreme_scenes
//
// tests/sqlite/extreme_scenes.h describes the scenes and holds their rows, which the tests compare bit by
// bit; here only the number of rows is checked. Processor time of the query, one run, the table ready.
#include "sqlite/extreme_scenes.h"

#include <cstdio>

#include "measure.h"
#include "sql.h"
#include "sqlite/foresee.h"

int main() {
  using namespace foresee;
  bool right = true;
  std::printf("scene,rows,seconds\n");
  for (const testing::ExtremeScene& scene : testing::extreme_scenes()) {
    bench::Database db(":memory:");
    db.require_ok(sqlite3_foresee_init(db.handle(), nullptr, nullptr));
    db.run(scene.setup);
    bench::Statement query(db, scene.query);
    std::size_t rows = 0;
    const double seconds = bench::seconds_of([&] {
      while (query.step()) ++rows;
    });
    right &= rows == scene.expected.size();
    std::printf("\"%s\",%zu,%.4f\n", scene.name.c_str(), rows, seconds);
    std::fflush(stdout);
  }
  return right ? 0 : 1;
}
